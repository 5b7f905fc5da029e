"""A small bin of spheres as a user writes it, and how tests carry it through."""

import copy
import pickle
from pathlib import Path

import numpy as np

from silostudy.compute.dem import run_of, scene_model
from silostudy.config.load import validated
from silostudy.config.spheres import SphereScene

SAME = ("grain_x", "grain_spin_y", "outflow_time", "outflow_mass", "wall_pressure_max", "surface_cross_force_max",
        "contact_load_z", "field_contact_stress", "field_velocity", "contact_fabric", "contact_sliding")  # fmt: skip
SMALL = {
    "kind": "dem",
    "grains": "spheres",
    "title": "a small bin",
    "silo": {
        "plan": "circular",
        "diameter_m": 0.06,
        "cylinder_depth_m": 0.1,
        "hopper": {"half_angle_deg": 30, "outlet_width_m": 0.04},
    },
    "grain": {"youngs_modulus_MPa": 100, "poissons_ratio": 0.25, "density_kg_m3": 2500, "softened_modulus_MPa": 5},
    "wall": {"youngs_modulus_MPa": 100, "poissons_ratio": 0.25},
    "spheres": {"restitution": 0.3, "sliding_friction": 0.5},
    "walls": {"restitution": 0.3, "sliding_friction": 0.3},
    "sizes": {"kind": "equal", "diameter_mm": 8},
    "filling": {"kind": "rain", "count": 150, "rate_1_s": 1500},
    "march": {"limit_s": 1.0},
    "rest": {"criterion": "unbalanced-force", "below": 2e-3},
    "events": [{"when": "rest", "do": "open_outlet"}, {"when": "after", "value": 0.15, "do": "stop"}],
    "record": {
        "wall_force_window_s": 0.02,
        "pressure_cells": [4, 6],
        "snapshots_s": [0.05, 0.2],
        "fields": {"cells": [3, 24], "every_s": 0.05},
        "contact_statistics": {"every_s": 0.05},
    },
}


def content(**changes) -> dict:
    """The bin with some keys changed; two underscores lead into a section, None takes a key out."""
    found = copy.deepcopy(SMALL)
    for path, value in changes.items():
        node = found
        *parents, last = path.split("__")
        for key in parents:
            node = node[key]
        node[last] = value
        if value is None:
            del node[last]
    return found


def scene_of(**changes) -> SphereScene:
    return validated(SphereScene, content(**changes), "small.yaml")


def run(scene, folder=Path(), threads=1):
    return run_of(scene, scene_model(scene, folder, "small.yaml"), threads=threads)


def carried(scene, **how):
    one = run(scene, **how)
    one.go()
    return one


def resumed(scene, stop, threads=1):
    """The finished run that a checkpoint gives which another left at a step; and what had happened to that one by then."""
    begun, other = run(scene), run(scene, threads=threads)
    begun.go(until=stop)
    other.restore(pickle.loads(pickle.dumps(begun.checkpoint())))
    other.go()
    return other, begun.recording.happened


def check_same(cube, other):
    """Whatever a run comes to has the same bits in both cubes."""
    for name in SAME:
        assert np.array_equal(cube[name], other[name], equal_nan=True), name
