"""A small silo of discs as a user writes it, and how tests carry it through."""

from pathlib import Path

import numpy as np

from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.config.dem import DemScene
from silostudy.config.load import validated
from tests.conftest import with_changes

SMALL = {
    "kind": "dem",
    "title": "a small silo",
    "silo": {"width_m": 0.17, "height_m": 0.4, "slit_width_m": 0.06, "wall_cells": 5},
    "packing": {"kind": "rows", "across": 8, "fill_height_m": 0.2, "gap_m": 4e-5},
    "radius_m": 0.01,
    "density_kg_m3": 2650,
    "discs": {"normal_stiffness_N_m2": 9.46e6, "normal_damping_N_s_m2": 3977, "sliding_friction": 0.577},
    "walls": {"normal_stiffness_N_m2": 1.89e7, "normal_damping_N_s_m2": 7955, "sliding_friction": 0.176},
    "march": {"step_s": 2.5e-5, "limit_s": 1.0},
    "events": [{"when": "time", "value": 0.05, "do": "open_slit"}, {"when": "after", "value": 0.15, "do": "stop"}],
    "record": {"wall_force_window_s": 0.01, "snapshots_s": [0.05, 0.2], "fields": {"cells": [3, 5], "every_s": 0.05}},
}


def scene_of(**changes) -> DemScene:
    return validated(DemScene, with_changes(SMALL, changes), "small.yaml")


def carried(scene, checkpoint=None):
    run = run_of(scene, scene_model(scene, Path()))
    carry_through(run, scene, checkpoint, lambda step: None)
    return run


def given(tmp_path, x, y):
    import xarray as xr

    file = tmp_path / "given.nc"
    xr.Dataset({"disc_x": ("disc", x), "disc_y": ("disc", y), "disc_radius": ("disc", np.full(len(x), 0.01))}).to_netcdf(file)
    return scene_of(packing={"kind": "given", "file": str(file)})
