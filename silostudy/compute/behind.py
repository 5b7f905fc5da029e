"""The numbers behind the numbers: which values each method reckons with, and which limit of it a case breaks."""

from collections.abc import Mapping, Sequence

import numpy as np

from silostudy.compute.evaluate import AskedMethod
from silostudy.limits import INSIDE
from silostudy.pressure.calls import call, parameters_of
from silostudy.pressure.family import ON_HOPPER, USED, USED_FOR, PressureMethod, Quantities
from silostudy.scene.expand import Expansion


def used_variables(expansion: Expansion, methods: list[AskedMethod], given: Sequence[Mapping]) -> dict[str, np.ndarray]:
    """Every parameter of USED as the methods reckon with it, (method, phase, axes..., used_for), and what follows from it.

    given: the parameters handed to each method.
    """
    shape = (len(methods), len(expansion.study.phases), *expansion.shape, len(USED_FOR))
    used = {name: np.full(shape, np.nan) for name in USED}
    for m, (method, parameters) in enumerate(zip(methods, given, strict=True)):
        for p, phase in enumerate(expansion.study.phases):
            for q, quantity in enumerate(USED_FOR):
                for name, value in _values_used(method, phase, quantity, parameters).items():
                    used[name][m, p, ..., q] = np.broadcast_to(value, (*expansion.shape, 1))[..., 0]
    radii = np.array([case.scene.silo.hydraulic_radius for case in expansion.cases]).reshape(*expansion.shape, 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        depth = radii / (used["lateral_pressure_ratio"] * used["wall_friction"])
    cut = (used["wall_friction"] < used["wall_friction_uncapped"] * (1 - 1e-12)).astype(np.int8)
    named = {f"used_{name}": value for name, value in used.items()}
    return {**named, "depth_constant": np.where(np.isfinite(depth), depth, np.nan), "used_wall_friction_capped": cut}


def _values_used(method: AskedMethod, phase: str, quantity: str, parameters: Mapping) -> dict[str, np.ndarray]:
    """Parameter -> value with which a quantity is reckoned: the method's own, or the one handed over if it is asked for."""
    functions = _functions(method.row, phase) if quantity == ON_HOPPER else method.functions(phase)
    function = next(iter(functions.values()), None) if quantity == ON_HOPPER else functions.get(quantity)
    if function is None:
        return {}
    own, asked = method.row.used.get(phase, {}).get(quantity, {}), parameters_of(function)
    values = {name: call(own[name], None, parameters) for name in own}
    for name in USED.keys() - own.keys():
        if (source := _handed(name, quantity)).removesuffix("_uncapped") in asked:
            values[name] = parameters[source]
    return values


def _functions(row: PressureMethod, phase: str) -> Quantities:
    return row.hopper.get(phase, {})


def _handed(name: str, quantity: str) -> str:
    return f"hopper_{name}" if quantity == ON_HOPPER and name.startswith("wall_friction") else name


def limit_variables(expansion: Expansion, methods: list[AskedMethod], given: Sequence[Mapping]) -> dict:
    """Limit that keeps a method from giving a wall pressure, (method, phase, axes...): its number on the axis of limits."""
    words = list(dict.fromkeys([INSIDE, *(limit.words() for method in methods for limit in method.row.limits)]))
    broken_limits = np.zeros((len(methods), len(expansion.study.phases), *expansion.shape), dtype=np.int8)
    for m, (method, parameters) in enumerate(zip(methods, given, strict=True)):
        for p, phase in enumerate(expansion.study.phases):
            for limit in reversed(method.row.limits) if method.functions(phase) else ():
                if limit.holds_for("wall_normal_pressure", phase) and not limit.measure.of_depth:
                    broken = np.broadcast_to(limit.broken(None, parameters), (*expansion.shape, 1))[..., 0]
                    broken_limits[m, p] = np.where(broken, words.index(limit.words()), broken_limits[m, p])
    return {"limit_broken": broken_limits, "limit": words}
