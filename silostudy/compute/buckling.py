"""The buckling stage: every rule of a study over all its shells in one vectorised call each."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.buckling.family import MODES, PARAMETERS, QUANTITIES, REASONS, BucklingRule, evaluate
from silostudy.compute.axes import sweep_of
from silostudy.compute.miller_charts import charts
from silostudy.cube.assemble import assemble
from silostudy.cube.variables import flags
from silostudy.limits import INSIDE
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
    results = [evaluate(rule, parameters) for rule in rules]
    data: dict = {name: np.array([result[name] for result in results]) for name in QUANTITIES}
    data |= {name: (np.array([result[name] for result in results]), flags(told, meanings)) for name, told, meanings in FLAGS}
    data |= {name: parameters[name] for name in SHOWN} | rule_coordinates(rules) | limit_variables(rules, parameters)
    if all(case.scene.test for case in expansion.cases):
        data |= _measured(expansion) | charts()
    notes = {"rival_readings": " ".join(study.rival_keys), **study.own_methods}
    sources = [rule.source for rule in rules]
    return assemble(study, "buckling", data, sources=sources, notes=notes, sweep=sweep_of(expansion))


def rule_coordinates(rules: list[BucklingRule]) -> dict[str, list[str]]:
    """The rule axis with what figures need to know of a rule, so that a figure is a function of the cube alone."""
    looks = {f"rule_{name}": [getattr(rule, name) for rule in rules] for name in ("title", "colour", "marker", "line")}
    return {"rule": [rule.key for rule in rules], **looks}


def limit_variables(rules: list[BucklingRule], parameters: Mapping) -> dict:
    """Limit of its range that masks a rule, (rule, axes...): its number on the axis of limits, of several the first."""
    words = list(dict.fromkeys([INSIDE, *(limit.words() for rule in rules for limit in rule.limits)]))
    broken_limits = np.zeros((len(rules), *np.shape(parameters["thickness"])), dtype=np.int8)
    for place, rule in enumerate(rules):
        for limit in reversed(rule.limits):
            broken_limits[place] = np.where(limit.broken(None, parameters), words.index(limit.words()), broken_limits[place])
    return {"rule_limit_broken": broken_limits, "rule_limit": words}


def _gathered(expansion: Expansion, name: str) -> np.ndarray:
    return np.array([float(getattr(case.scene, name)) for case in expansion.cases]).reshape(expansion.shape)


def _measured(expansion: Expansion) -> dict[str, np.ndarray]:
    """Strengths that the tests of the study measured, and what tells the tests apart."""
    values = {name: [getattr(case.scene.test, name) for case in expansion.cases] for name in OF_TEST}
    return {f"test_{name}": np.array(column).reshape(expansion.shape) for name, column in values.items()}
