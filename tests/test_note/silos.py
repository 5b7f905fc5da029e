"""Silos of many kinds for the note: the shipped study of the checks, changed, so that every line has a silo of its own."""

import copy
from functools import cache

import yaml

from silostudy.choice.expand import expand
from silostudy.compute.checks import checks_cube
from silostudy.compute.pressure import pressure_cube
from tests.conftest import ROOT

ONE_SOURCE = ["shear_buckling_2025", "interaction_2025"]
THICK = [{"down_to": 0.5, "thickness_mm": 30.0}, {"down_to": 1.0, "thickness_mm": 60.0}]
# silo -> changes of the shipped study: dotted keys below scene, the rest of the study under ""
SILOS: dict[str, dict] = {
    "slender": {},
    "intermediate": {
        "silo.cylinder_depth_m": 9.0,
        "silo.heap_at_repose": True,
        "silo.hopper.half_angle_deg": 55.0,
        "silo.dynamic_bottom_load": True,
        "hopper_shell.thickness_mm": 14.0,
        "": {"rules": ["en1993_4_1_2025", "en1993_1_6_2025"], "checks": {"one_source": ONE_SOURCE}},
    },
    "squat": {"silo.cylinder_depth_m": 5.5, "characteristic_friction": "uncapped", "silo.patch_of_low_silo": True},
    "stocky": {
        **{"silo.diameter_m": 2.0, "silo.cylinder_depth_m": 12.0, "silo.heap_at_repose": True},
        **{"shell.strakes": THICK, "anchors.circle_diameter_m": 2.1},
    },
    "no wind": {"wind": None},
    "corrugated": {"wall_contact_share": 0.8},
}


def content(name: str) -> dict:
    """The study of a silo."""
    study = yaml.safe_load((ROOT / "config/studies/steel-wheat-checks.yaml").read_text())
    study |= {"methods": ["en1991_4"], "relative_depth": {"start": 0.0, "stop": 1.0, "count": 9}, "outputs": []}
    study["hopper_position"] = {"start": 0.0, "stop": 1.0, "count": 21}
    for key, value in copy.deepcopy(SILOS[name]).items():
        *parents, last = key.split(".")
        node = study["scene"]
        for parent in parents:
            node = node[parent]
        if key:
            node[last] = value
        else:
            study |= value
    return study


@cache
def cubes(name: str) -> tuple:
    """(cube of the pressures, cube of the checks) of a silo."""
    expansion = expand(content(name), name, f"{name}.yaml", ROOT)
    pressure = pressure_cube(expansion)
    return pressure, checks_cube(expansion, pressure)
