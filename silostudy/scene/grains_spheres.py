"""The filling of a round silo that is shaken, as an ordinary scene of spheres."""

from math import pi

import numpy as np

from silostudy.config.grains_spheres import ShakenSpheres
from silostudy.config.spheres import SphereScene
from silostudy.packing.sizes import SIZES
from silostudy.scene.laboratory_cell import DRAWN, LOOSE
from silostudy.scene.laboratory_scenes import ROOM, column_rain

AROUND = 180  # cells around wall and floor: a force in the middle of its cell is off by 0.005 % in the mean
BEYOND = 1.0  # s: the scene's own limit beyond the rain; the study's holds


def filling_scene(config: ShakenSpheres, seed: int) -> SphereScene:
    """Spheres rain into the silo and come to rest."""
    width = config.box.diameter_m
    height = config.box.slenderness * width
    radii = SIZES[config.sizes.kind].radii(np.random.default_rng(0), DRAWN, config.sizes)
    rain = column_rain(max(1, round(LOOSE * 0.25 * pi * width**2 * height / float((4.0 / 3.0 * pi * radii**3).mean()))), height)
    pours = rain["count"] / rain["rate_1_s"]
    content = {
        "kind": "dem", "grains": config.grains, "title": "a silo that will be shaken",
        "silo": {"plan": "circular", "diameter_m": width, "cylinder_depth_m": ROOM * height}, "filling": rain,
        "grain": config.grain, "wall": config.wall, "spheres": config.spheres, "walls": config.walls, "sizes": config.sizes,
        "seed": seed, "march": {"limit_s": pours + BEYOND, "step_factor": config.step_factor},
        "events": [{"when": "rest", "do": "stop"}], "record": {"wall_force_window_s": pours, "pressure_cells": [1, AROUND]},
    }  # fmt: skip
    return SphereScene.model_validate(content)


def pouring_time(scene: SphereScene) -> float:
    """Time (s) that the rain takes."""
    return float(scene.filling.count / scene.filling.rate_1_s)
