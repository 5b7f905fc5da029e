"""Values of the pressure stage with the reason where they are masked, labels, and parameters."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from silostudy.cube.variables import flags
from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call, parameters_of
from silostudy.pressure.family import (
    ABOVE_CONTACT,
    IN_SCOPE,
    NO_HOPPER,
    NO_PHASE,
    NO_PLAN,
    NO_PROPERTY,
    OUT_OF_RANGE,
    QUANTITIES,
    REASONS,
    PressureMethod,
)
from silostudy.pressure.limits import broken
from silostudy.scene.expand import Expansion
from silostudy.scene.scene import parameters_of_scenes

AS_PRINTED = "_as_printed"


@dataclass(frozen=True)
class AskedMethod:
    """A method as a study asks for it: its row, and whether the source's misprints are left in."""

    row: PressureMethod
    as_printed: bool = False

    @property
    def label(self) -> str:
        """Name on the cube's axis of methods."""
        return self.row.key + AS_PRINTED * self.as_printed

    @property
    def title(self) -> str:
        """Name for people."""
        return self.row.title + " (as printed)" * self.as_printed

    @property
    def drawn(self) -> str:
        """Look of the method in a figure that compares many methods."""
        return self.row.drawn_as_printed if self.as_printed else self.row.drawn

    def functions(self, phase: str) -> Mapping[str, Callable]:
        """Functions by quantity in a phase; empty where the method does not cover it."""
        misprinted = self.as_printed and self.row.as_printed
        return (self.row.as_printed if misprinted else self.row.phases).get(phase, {})


def methods_of(expansion: Expansion) -> list[AskedMethod]:
    """The methods that a study asks for, then those that it asks for as printed."""
    study, rows = expansion.study, expansion.study.family(PRESSURE)
    return [*(AskedMethod(rows[key]) for key in study.method_keys), *(AskedMethod(rows[key], True) for key in study.as_printed)]


def sources_of(expansion: Expansion) -> list[str]:
    """References of the methods and of the stored solids."""
    return [method.row.source for method in methods_of(expansion)] + [case.scene.solid.source for case in expansion.cases]


def gather(expansion: Expansion, method: AskedMethod) -> dict[str, np.ndarray]:
    """Every parameter a method may ask for, in SI, and the plan's shape: arrays of shape (axes..., 1)."""
    parameters = parameters_of_scenes([case.scene for case in expansion.cases], method.row, method.as_printed)
    return {name: values.reshape(*expansion.shape, 1) for name, values in parameters.items()}


def masked(row: PressureMethod, quantity: str, phase: str, function: Callable, place, parameters: Mapping) -> tuple:
    """Values with NaN where the method does not speak, and why not (first reason that applies); no place: a total."""
    names = parameters_of(function)
    plan_covered = np.isin(parameters["plan"], list(row.covers(quantity)))
    known = np.logical_and.reduce([np.isfinite(parameters[name]) for name in names])
    no_hopper = np.isnan(parameters["hopper_half_angle"]) & ("hopper_half_angle" in names)
    with np.errstate(all="ignore"):  # unknown or impossible parameters are masked below
        value = np.asarray(call(function, place, parameters))
    beyond = broken(row.limits, quantity, phase, place if quantity in QUANTITIES else None, parameters)
    shape = np.broadcast_shapes(value.shape, plan_covered.shape, *([] if place is None else [place.shape]))
    value = np.broadcast_to(value, shape)
    reasons = [(~plan_covered, NO_PLAN), (no_hopper, NO_HOPPER), (~known, NO_PROPERTY)]
    reasons.append((np.isnan(value) | beyond, OUT_OF_RANGE))
    conditions = [np.broadcast_to(condition, shape) for condition, _ in reasons]
    scope = np.select(conditions, [code for _, code in reasons], IN_SCOPE).astype(np.int8)
    return np.where(scope == IN_SCOPE, value, np.nan), scope


def above_contact(evaluated: tuple, z: np.ndarray, parameters: Mapping) -> tuple:
    """Values on the cylinder, masked above the highest contact of solid and wall."""
    value, scope = evaluated
    above = (z < parameters["contact_depth"]) & ~np.isin(scope, [NO_PLAN, NO_PROPERTY])
    return np.where(above, np.nan, value), np.where(above, np.int8(ABOVE_CONTACT), scope)


def with_reasons(scopes: Mapping[str, np.ndarray]) -> dict[str, tuple]:
    """The flags of quantities that say why their values are masked, as the cube's variables."""
    return {f"{name}_scope": (values, flags(f"why {name} is masked", REASONS)) for name, values in scopes.items()}


def filled(expansion, given, methods, names, evaluate, *last_shape) -> dict:
    """The named quantities of every method and phase with their scope flags.

    evaluate(row, phase, parameters) -> name -> (value, scope).
    """
    shape = (len(methods), len(expansion.study.phases), *expansion.shape, *last_shape)
    values = {name: np.full(shape, np.nan) for name in names}
    scopes = {name: np.full(shape, NO_PHASE, dtype=np.int8) for name in names}
    for m, (method, parameters) in enumerate(zip(methods, given, strict=True)):
        for p, phase in enumerate(expansion.study.phases):
            for name, (value, scope) in evaluate(method.row, phase, parameters).items():
                values[name][m, p], scopes[name][m, p] = value, scope
    return values | with_reasons(scopes)


def method_coordinates(methods: list[AskedMethod]) -> dict[str, list[str]]:
    """The axis of methods with what figures need to know of them, so that a figure is a function of the cube alone."""
    columns = {f"_{name}": [getattr(method, name) for method in methods] for name in ("title", "drawn")}
    columns |= {"": [method.label for method in methods]}
    for name in ("number", "colour", "marker", "initial_state"):
        columns[f"_{name}"] = [getattr(method.row, name) for method in methods]
    columns["_values"] = ["; ".join(f"{q}: {v}" for q, v in method.row.values.items()) for method in methods]
    return {f"pressure_method{name}": texts for name, texts in columns.items()}
