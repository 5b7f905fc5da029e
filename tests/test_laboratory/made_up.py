"""A small laboratory for the tests, and cubes of numbers that are known beforehand: no kernel is compiled."""

from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
import yaml

from silostudy.choice.expand import expand
from silostudy.compute.axes import sweep_of
from silostudy.compute.laboratory import PATH, coordinates, sources
from silostudy.cube.assemble import assemble
from silostudy.scene.expand import Expansion
from tests.conftest import ROOT, with_changes

SHIPPED = ROOT / "config/studies/wheat-laboratory.yaml"
# a rolling law, without friction, so that tests with it need no kernel of their own
ROLLING = {"restitution": 0.3, "rolling": "spring-slider", "rolling_stiffness_N_m": 0.01, "rolling_friction": 0.0}
CONTENT: dict[str, Any] = {
    "kind": "laboratory",
    "title": "a small laboratory",
    "scene": {
        "grains": "spheres",
        "grain": {"youngs_modulus_MPa": 10, "poissons_ratio": 0.3, "density_kg_m3": 1350},
        "wall": {"youngs_modulus_MPa": 200000, "poissons_ratio": 0.3},
        "spheres": ROLLING | {"sliding_friction": 0.45},
        "walls": {"restitution": 0.3, "sliding_friction": 0.2},
        "sizes": {"kind": "uniform", "least_mm": 4, "largest_mm": 5},
        "height_grains": 5,
        "inertial_number": 0.005,
    },
    "solid": {"key": "small_spheres", "grain": "coarse_grain"},
    "stresses_kPa": [10, 20],
    "cells": [6, 8],
    "fillings": 3,
}

DISCS: dict[str, Any] = CONTENT | {
    "scene": {
        "grains": "discs",
        "radius_m": 0.004,
        "radius_spread": 0.1,
        "density_kg_m3": 1350,
        "discs": {"normal_stiffness_N_m2": 2e6, "restitution": 0.5, "sliding_friction": 0.45},
        "walls": {"normal_stiffness_N_m2": 4e6, "restitution": 0.5, "sliding_friction": 0.25},
        "height_grains": 8,
        "inertial_number": 1e-3,
    },
    "solid": {"key": "small_discs", "grain": "coarse_grain"},
    "stresses_kPa": [1, 2],
    "cells": [32, 48],
}


def content(**changes: Any) -> dict[str, Any]:
    """The small laboratory with other values; `scene__walls` is the key `walls` of its scene."""
    return with_changes(CONTENT, changes)


def expansion(**changes: Any) -> Expansion:
    """Its cells."""
    return expand(content(**changes), "small", "small.yaml", Path())


def of_discs(**changes: Any) -> Expansion:
    """The cells of a small laboratory of discs, with other values."""
    return expand(with_changes(DISCS, changes), "small", "small.yaml", Path())


def cube_of(found: Expansion, ratio=0.45, inside=0.5, wall=0.3) -> xr.Dataset:
    """A cube of a solid of these ratios; a filling is off by 1 % more than the one before it, a wider cell has no other."""
    study = found.study
    shape, stresses = found.shape, len(study.stresses_kPa)
    off = 1.0 + 0.01 * (np.arange(shape[-1]) - 0.5 * (shape[-1] - 1))
    each = np.broadcast_to(off, shape)
    at = np.broadcast_to(each[..., None], (*shape, stresses))
    way = coordinates(study)["shear_strain"]
    rise = np.minimum(1.0, way / 0.1)[:, None]  # the stresses come last
    path = np.linspace(0.0, 1e3 * study.stresses_kPa[-1], PATH + 1)[1:]
    numbers = {
        "tested_grains": np.full(shape, 270.0),
        "tested_grain_diameter": np.full(shape, 4.5e-3),
        "loose_unit_weight": 7.9e3 * each,
        "tested_repose_angle": 0.4 * each,
        "tested_drawn_angle": 0.5 * each,
        "tested_restitution": np.full(shape, 0.3),
        "asked_restitution": np.full(shape, 0.3),
        "tested_unit_weight": 8.5e3 * at,
        "tested_lateral_pressure_ratio": ratio * at,
        "secant_lateral_pressure_ratio": 1.05 * ratio * at,
        "path_horizontal_stress": ratio * path * each[..., None],
    }
    for name, value in (("internal", inside), ("wall", wall)):
        numbers |= {
            f"{name}_shear_ratio": value * rise * at[..., None, :],
            f"{name}_peak_shear_ratio": value * at,
            f"{name}_steady_shear_ratio": 0.9 * value * at,
            f"{name}_torque_imbalance": 0.0 * at,
            f"{name}_stress_error": 0.0 * at,
        }
    numbers |= {"force_imbalance": 0.0 * at, "pressing_stress_error": 0.0 * at}
    return assemble(study, study.kind, numbers | coordinates(study), sources=sources(study), sweep=sweep_of(found))


def shipped() -> Expansion:
    """The cells of the shipped laboratory."""
    return expand(yaml.safe_load(SHIPPED.read_text()), SHIPPED.stem, str(SHIPPED), SHIPPED.parent)
