"""The buckling stage: every rule of a study over all its shells in one vectorised call each."""

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.buckling.family import MODES, PARAMETERS, QUANTITIES, REASONS, BucklingRule, evaluate
from silostudy.compute.axes import axis_coordinates
from silostudy.compute.miller_charts import charts
from silostudy.compute.variables import attributes, flags
from silostudy.cube.contract import check
from silostudy.cube.provenance import provenance
from silostudy.scene.expand import Expansion

SHOWN = ("yield_stress", "youngs_modulus", "shell_radius", "thickness", "bay_length", "ring_area")
FLAGS = (
    ("buckling_mode", "how the shell buckles (-1: masked)", MODES),
    ("buckling_stress_scope", "why buckling_stress is masked", REASONS),
)
OF_TEST = ("lower_buckling_stress", "upper_buckling_stress", "scale", "material", "collapse", "total_length")


def buckling_cube(expansion: Expansion) -> xr.Dataset:
    """The cube of a buckling study: each quantity (rule, axes...) with mode and scope flags beside it."""
    study = expansion.study
    rules = [study.family(BUCKLING)[key] for key in study.rule_keys]
    rules += [study.family(RIVALS)[key] for key in study.rival_keys]
    parameters = {name: _gathered(expansion, name) for name in PARAMETERS}
    found = [evaluate(rule, parameters) for rule in rules]
    axes = [axis.axis for axis in study.sweep]
    dims = ("rule", *axes)
    data: dict = {name: (dims, np.array([one[name] for one in found]), attributes(name)) for name in QUANTITIES}
    for name, long_name, meanings in FLAGS:
        data[name] = (dims, np.array([one[name] for one in found]), flags(long_name, meanings))
    data |= {name: (axes, parameters[name], attributes(name)) for name in SHOWN}
    data["case"] = (axes, np.array([case.id for case in expansion.cases]).reshape(expansion.shape), attributes("case"))
    if all(case.scene.test for case in expansion.cases):
        data |= _measured(expansion, axes) | charts()
    coords = {**rule_coordinates(rules), **axis_coordinates(study)}
    text = study.model_dump_json(exclude_defaults=True)
    sources = [rule.source for rule in rules]
    told = {"sweep_axes": " ".join(axes), "rival_readings": " ".join(study.rival_keys), **study.own_methods}
    return check(xr.Dataset(data, coords, {**provenance(study.title, text, sources, "buckling"), **told}))


def rule_coordinates(rules: list[BucklingRule]) -> dict[str, tuple]:
    """The rule axis with what figures need to know of a rule, so that a figure is a function of the cube alone."""
    coords: dict[str, tuple] = {"rule": ("rule", [rule.key for rule in rules], attributes("rule"))}
    for name in ("title", "colour", "marker", "line"):
        texts = [getattr(rule, name) for rule in rules]
        coords[f"rule_{name}"] = ("rule", texts, attributes(f"rule_{name}"))
    return coords


def _gathered(expansion: Expansion, name: str) -> np.ndarray:
    return np.array([float(getattr(case.scene, name)) for case in expansion.cases]).reshape(expansion.shape)


def _measured(expansion: Expansion, axes: list[str]) -> dict[str, tuple]:
    """What the tests of the study measured, and what tells them apart."""
    values = {name: [getattr(case.scene.test, name) for case in expansion.cases] for name in OF_TEST}
    return {
        f"test_{name}": (axes, np.array(column).reshape(expansion.shape), attributes(f"test_{name}"))
        for name, column in values.items()
    }
