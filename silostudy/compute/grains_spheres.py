"""A round silo of spheres that will be shaken: its model, the run that fills it, and what its surfaces push."""

from dataclasses import replace

import numpy as np

from silostudy.config.grains_spheres import ShakenSpheres
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.scene.dem import rest_of
from silostudy.scene.grains_spheres import filling_scene, pouring_time
from silostudy.scene.space_silo import FLOOR, WALL
from silostudy.scene.spheres import rain_of, space_silo_of
from silostudy.scene.spheres_model import sphere_model


def silo_model(config: ShakenSpheres, seed: int) -> Model:
    """The model at its start, its spheres yet to come in; its silo may be shaken."""
    return replace(sphere_model(filling_scene(config, seed), None), quake=np.zeros((1, 3)))


def filling_run(config: ShakenSpheres, seed: int, model: Model, limit: float) -> Run:
    """The run that rains the spheres in and waits, at most so long (s), for them to come to rest."""
    scene = filling_scene(config, seed)
    rain = rain_of(scene, space_silo_of(scene), model.radius)
    stop, whole = Event("rest", 0.0, "stop"), pouring_time(scene) + limit
    return Run(Engine(model), (stop,), limit=whole, rest=rest_of(scene), rain=rain)


def silo_pushes(model: Model, window: np.ndarray) -> tuple[float, float, float]:
    """Horizontal force (N) on the spheres along x from the wall and from the floor, and the sum of the wall's pressing (N).

    window: what the cells feel, (cell, component).  A wall's cell presses inward, a floor's takes its shear outward; both
    have their third component counter-clockwise.
    """
    first = model.space.walls_of(model.walls).cells[1:, 0]
    cells = dict(zip((wall.name for wall in model.walls), np.split(window, first), strict=True))
    wall, floor = cells[WALL], cells[FLOOR]
    turn = 2.0 * np.pi * (np.arange(len(wall)) + 0.5) / len(wall)
    outward, around = np.cos(turn), np.sin(turn)
    of_wall = -wall[:, 0] @ outward - wall[:, 2] @ around
    return float(of_wall), float(floor[:, 1] @ outward - floor[:, 2] @ around), float(wall[:, 0].sum())
