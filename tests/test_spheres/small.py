"""A small bin of spheres as a user writes it, and how tests carry it through."""

import pickle
from pathlib import Path

import numpy as np

from silostudy.accuracy.optional_spheres import SCENE as BIN
from silostudy.compute.dem import run_of, scene_model
from silostudy.config.load import validated
from silostudy.config.spheres import SphereScene
from tests.conftest import with_changes

SAME = ("grain_x", "grain_spin_y", "outflow_time", "outflow_mass", "wall_pressure_max", "surface_cross_force_max",
        "contact_force_z", "field_contact_stress", "field_velocity", "contact_fabric", "contact_sliding")  # fmt: skip
SMALL = BIN | {
    "title": "a small bin",
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
    return with_changes(SMALL, changes)


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
