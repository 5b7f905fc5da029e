"""What every part of the pressure stage shares: labels, parameters, and values with the reason where they are masked."""

from collections.abc import Callable, Mapping

import numpy as np

from silostudy.compute.variables import attributes, flags
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import (
    ABOVE_CONTACT,
    IN_SCOPE,
    NO_HOPPER,
    NO_PLAN,
    NO_PROPERTY,
    OUT_OF_RANGE,
    REASONS,
    PressureMethod,
    call,
    parameters_of,
)
from silostudy.scene.expand import Expansion
from silostudy.scene.scene import geometry_parameters, solid_parameters

AS_PRINTED = "_as_printed"


def method_labels(expansion: Expansion) -> list[str]:
    """Names on the cube's method axis: the methods asked for, then those asked for as printed."""
    return [*expansion.study.method_keys, *(key + AS_PRINTED for key in expansion.study.as_printed)]


def row_of(label: str) -> PressureMethod:
    """The catalogue row behind a name on the method axis."""
    return PRESSURE[label.removesuffix(AS_PRINTED)]


def functions_of(label: str, phase: str) -> Mapping[str, Callable]:
    """quantity -> function of a method (or of its misprinted twin) in a phase; empty where it does not cover it."""
    row = row_of(label)
    if label.endswith(AS_PRINTED) and row.as_printed:
        return row.as_printed.get(phase, {})
    return row.phases.get(phase, {})


def gather(expansion: Expansion, label: str) -> dict[str, np.ndarray]:
    """Every parameter a method may ask for, in SI, shape (axes..., 1)."""
    as_printed = label.endswith(AS_PRINTED)
    key = row_of(label).table_key or row_of(label).key
    each = [{**geometry_parameters(case.scene), **solid_parameters(case.scene, key, as_printed)} for case in expansion.cases]
    return {name: np.array([one[name] for one in each]).reshape(*expansion.shape, 1) for name in each[0]}


def plans(expansion: Expansion) -> np.ndarray:
    """Plan shape of every case, shape (axes..., 1)."""
    return np.array([case.scene.silo.plan for case in expansion.cases]).reshape(*expansion.shape, 1)


def masked(function: Callable, place: np.ndarray | None, parameters: Mapping, plan_covered: np.ndarray) -> tuple:
    """Values with NaN where the method does not speak, and why not (first reason that applies); no place: a total."""
    names = parameters_of(function)
    known = np.logical_and.reduce([np.isfinite(parameters[name]) for name in names])
    no_hopper = np.isnan(parameters["hopper_half_angle"]) & ("hopper_half_angle" in names)
    with np.errstate(divide="ignore", invalid="ignore"):  # unknown parameters are NaN and are masked below
        value = np.asarray(call(function, place, parameters))
    shape = np.broadcast_shapes(value.shape, plan_covered.shape, *([] if place is None else [place.shape]))
    value = np.broadcast_to(value, shape)
    reasons = [(~plan_covered, NO_PLAN), (no_hopper, NO_HOPPER), (~known, NO_PROPERTY), (np.isnan(value), OUT_OF_RANGE)]
    conditions = [np.broadcast_to(condition, shape) for condition, _ in reasons]
    scope = np.select(conditions, [code for _, code in reasons], IN_SCOPE).astype(np.int8)
    return np.where(scope == IN_SCOPE, value, np.nan), scope


def above_contact(found: tuple, z: np.ndarray, parameters: Mapping) -> tuple:
    """Values on the cylinder, masked above the highest contact of solid and wall."""
    value, scope = found
    above = (z < parameters["top_cone_height"] / 3) & ~np.isin(scope, [NO_PLAN, NO_PROPERTY])
    return np.where(above, np.nan, value), np.where(above, np.int8(ABOVE_CONTACT), scope)


def scope_attributes(name: str) -> dict:
    """Attributes of the flags that say why values are masked."""
    return flags(f"why {name} is masked", REASONS)


def looks(labels: list[str]) -> dict[str, tuple]:
    """What figures need to know of a method, so that a figure is a function of the cube alone."""
    titles = [row_of(label).title + (" (as printed)" if label.endswith(AS_PRINTED) else "") for label in labels]
    found = {"title": titles}
    for name in ("number", "colour", "marker"):
        found[name] = [getattr(row_of(label), name) for label in labels]
    found["values"] = ["; ".join(f"{q}: {v}" for q, v in row_of(label).values.items()) for label in labels]
    return {
        f"pressure_method_{name}": ("pressure_method", texts, attributes(f"pressure_method_{name}"))
        for name, texts in found.items()
    }
