"""A small sweep of scenes for the tests, and a stand-in for its physics that is quick and known."""

import copy
from pathlib import Path

import numpy as np
import yaml

from silostudy.choice.expand import expand_file
from silostudy.sweep.part import compute_part
from silostudy.sweep.plan import Plan, planned, write_plan
from tests.conftest import ROOT

CONTENT = yaml.safe_load((ROOT / "config/studies/discharge-slit.yaml").read_text())


def content(slits=(0.04, 0.06, 0.08), frictions=(0.0, 0.176), axes=(), **changes) -> dict:
    found = copy.deepcopy(CONTENT) | changes
    found["sweep"] = [
        {"axis": "slit_width", "values": {"silo.slit_width_m": list(slits)}},
        {"axis": "wall_friction", "values": {"walls.sliding_friction": list(frictions)}},
        *axes,
    ]
    return found


def save(folder: Path, **changes) -> Path:
    path = folder / "sweep.yaml"
    path.write_text(yaml.safe_dump(content(**changes)))
    return path


def stand_in(calls):
    """A measure that notes its calls, and fails for a slit of 0.06 without wall friction."""

    def measure(study, case):
        config = case.config
        key = config.silo.slit_width_m, config.walls.sliding_friction
        calls.append(key)
        if key == (0.06, 0.0):
            raise ValueError("ran away")
        return {"end_time": np.array(key[0] * 10 + key[1]), "resting_normal_force": np.array(key)}

    return measure


def make_plan(path: Path, folder: Path, cores=1) -> tuple[Plan, list[Path]]:
    """The plan of a study, written, and the marks of unfinished parts."""
    plan, unfinished = planned(expand_file(path), folder, cores)
    write_plan(plan, folder)
    return plan, unfinished


def compute(path: Path, folder: Path, cores=1) -> int:
    """Plans and computes all parts; how many cases were computed."""
    plan, _ = make_plan(path, folder, cores)
    return sum(compute_part(path, part, folder, lambda text: None) for part in plan)
