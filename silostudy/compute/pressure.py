"""The pressure stage: every method of a study over all its cases in one vectorised call each."""

from collections.abc import Callable, Mapping

import numpy as np
import xarray as xr

from silostudy.compute.axes import axis_coordinates
from silostudy.cube.contract import VARIABLES, check
from silostudy.cube.provenance import provenance
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import (
    ABOVE_CONTACT,
    IN_SCOPE,
    NO_PHASE,
    NO_PLAN,
    NO_PROPERTY,
    NO_QUANTITY,
    OUT_OF_RANGE,
    QUANTITIES,
    REASONS,
    PressureMethod,
    call,
    parameters_of,
)
from silostudy.scene.expand import Expansion
from silostudy.scene.scene import geometry_parameters, solid_parameters

HANDED = ("unit_weight", "internal_friction_angle", "wall_friction", "lateral_pressure_ratio", "poisson_ratio")
HANDED_IF_KNOWN = ("unit_weight_lower", "effective_friction_angle", "hopper_wall_friction", "repose_angle", "a_phi", "a_K", "a_mu")
AS_PRINTED = "_as_printed"


def pressure_cube(expansion: Expansion) -> xr.Dataset:
    """The cube of a study: each quantity (method, phase, axes..., depth) with a scope flag beside it."""
    labels = method_labels(expansion)
    z = depths_in_metres(expansion)
    shape = (len(labels), len(expansion.study.phases), *z.shape)
    values = {name: np.full(shape, np.nan) for name in (*QUANTITIES, "overpressure_factor")}
    scopes = {name: np.full(shape, NO_PHASE, dtype=np.int8) for name in values}
    handed = {name: np.full(shape[:1] + shape[2:-1], np.nan) for name in (*HANDED, *HANDED_IF_KNOWN, "wall_friction_capped")}
    for m, label in enumerate(labels):
        parameters = gather(expansion, label)
        _note(handed, m, parameters, shape[2:-1])
        for p, phase in enumerate(expansion.study.phases):
            found = evaluate(label, phase, z, parameters, plans(expansion))
            for name, (value, scope) in found.items():
                values[name][m, p], scopes[name][m, p] = value, scope
    return _assemble(expansion, labels, z, values, scopes, handed)


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


def depths_in_metres(expansion: Expansion) -> np.ndarray:
    """Depth (m) of every value, shape (axes..., depth)."""
    depths = np.array(expansion.study.depths)
    if expansion.study.depth_m is not None:
        return np.broadcast_to(depths, (*expansion.shape, depths.size))
    heights = np.array([case.scene.silo.cylinder_depth for case in expansion.cases]).reshape(expansion.shape)
    return heights[..., None] * depths


def gather(expansion: Expansion, label: str) -> dict[str, np.ndarray]:
    """Every parameter a method may ask for, in SI, shape (axes..., 1)."""
    as_printed = label.endswith(AS_PRINTED)
    key = row_of(label).key
    each = [{**geometry_parameters(case.scene), **solid_parameters(case.scene, key, as_printed)} for case in expansion.cases]
    return {name: np.array([one[name] for one in each]).reshape(*expansion.shape, 1) for name in each[0]}


def plans(expansion: Expansion) -> np.ndarray:
    """Plan shape of every case, shape (axes..., 1)."""
    return np.array([case.scene.silo.plan for case in expansion.cases]).reshape(*expansion.shape, 1)


def evaluate(label: str, phase: str, z: np.ndarray, parameters: Mapping, plan: np.ndarray) -> dict[str, tuple]:
    """quantity -> (values, scope flags) of one method in one phase; empty where the method does not cover the phase."""
    row, functions = row_of(label), functions_of(label, phase)
    if not functions:
        return {}
    found = {}
    for name in QUANTITIES:
        if name in functions:
            found[name] = _masked(functions[name], z, parameters, np.isin(plan, list(row.plans)))
        else:
            found[name] = np.nan, np.int8(NO_QUANTITY)
    pressure, scope = found["wall_normal_pressure"]
    static = call(row.static, np.where(z > 0, z, np.nan), parameters)  # 0 / 0 at the surface is no factor
    found["overpressure_factor"] = pressure / static, np.where((z > 0) | (scope != IN_SCOPE), scope, OUT_OF_RANGE)
    return found


def _masked(function: Callable, z: np.ndarray, parameters: Mapping, plan_covered: np.ndarray) -> tuple:
    """Values with NaN where the method does not speak, and why not (first reason that applies)."""
    known = np.logical_and.reduce([np.isfinite(parameters[name]) for name in parameters_of(function)])
    above = z < parameters["top_cone_height"] / 3
    value = np.broadcast_to(call(function, z, parameters), z.shape)
    reasons = [(~plan_covered, NO_PLAN), (~known, NO_PROPERTY), (above, ABOVE_CONTACT), (np.isnan(value), OUT_OF_RANGE)]
    conditions = [np.broadcast_to(condition, z.shape) for condition, _ in reasons]
    scope = np.select(conditions, [code for _, code in reasons], IN_SCOPE).astype(np.int8)
    return np.where(scope == IN_SCOPE, value, np.nan), scope


def _note(handed: dict[str, np.ndarray], m: int, parameters: Mapping, shape: tuple[int, ...]) -> None:
    for name in (*HANDED, *HANDED_IF_KNOWN):
        handed[name][m] = parameters[name].reshape(shape)
    capped = parameters["wall_friction"] < parameters["wall_friction_uncapped"]
    handed["wall_friction_capped"][m] = capped.reshape(shape)


def _assemble(expansion: Expansion, labels: list[str], z, values, scopes, handed) -> xr.Dataset:
    axes = [axis.axis for axis in expansion.study.sweep]
    by_metres = expansion.study.depth_m is not None
    level = "depth" if by_metres else "relative_depth"
    dims = ("method", "phase", *axes, level)
    data: dict = {}
    for name, value in values.items():
        data[name] = (dims, value, {**_attributes(name), "ancillary_variables": f"{name}_scope"})
        data[f"{name}_scope"] = (dims, scopes[name], _scope_attributes(name))
    for name, value in handed.items():
        if name in HANDED_IF_KNOWN and np.isnan(value).all():
            continue
        kept = value.astype(np.int8) if name == "wall_friction_capped" else value
        data[name] = (("method", *axes), kept, _attributes(name))
    for name in ("hydraulic_radius", "cylinder_depth"):
        sizes = np.array([getattr(case.scene.silo, name) for case in expansion.cases]).reshape(expansion.shape)
        data[name] = (axes, sizes, _attributes(name))
    data["case"] = (axes, np.array([case.id for case in expansion.cases]).reshape(expansion.shape), _attributes("case"))
    data |= total_variables(expansion, labels)
    if expansion.study.hopper_position is not None:
        data |= hopper_variables(expansion, labels)
        coords_of_hopper = {"hopper_position": ("hopper_position", expansion.study.hopper_positions, attributes_of("hopper_position"))}
    depth = {"standard_name": "depth", "units": "m", "positive": "down", "axis": "Z"}
    depth["long_name"] = "depth below the equivalent flat surface of the stored solid"
    coords: dict = {
        "method": ("method", labels, _attributes("method")),
        **_looks(labels),
        "phase": ("phase", list(expansion.study.phases), _attributes("phase")),
        **axis_coordinates(expansion.study),
    }
    if by_metres:
        coords["depth"] = ("depth", np.array(expansion.study.depths), depth)
    else:
        coords["relative_depth"] = (level, np.array(expansion.study.depths), _attributes("relative_depth"))
        depth.pop("axis")
        coords["depth"] = ((*axes, level), z, depth)
    study = expansion.study.model_dump_json(exclude_defaults=True)
    sources = [row_of(label).source for label in labels] + [case.scene.solid.source for case in expansion.cases]
    attributes = {**provenance(expansion.study.title, study, sources, "pressure"), "sweep_axes": " ".join(axes)}
    return check(xr.Dataset(data, coords, attributes))


def _looks(labels: list[str]) -> dict[str, tuple]:
    """What figures need to know of a method, so that a figure is a function of the cube alone."""
    titles = [row_of(label).title + (" (as printed)" if label.endswith(AS_PRINTED) else "") for label in labels]
    looks = {"title": titles}
    for name in ("number", "colour", "marker"):
        looks[name] = [getattr(row_of(label), name) for label in labels]
    return {f"method_{name}": ("method", texts, _attributes(f"method_{name}")) for name, texts in looks.items()}


def _attributes(name: str) -> dict[str, str]:
    return {"units": VARIABLES[name].units, "long_name": VARIABLES[name].long_name}


def _scope_attributes(name: str) -> dict:
    return {
        "long_name": f"why {name} is masked",
        "standard_name": "status_flag",
        "flag_values": np.arange(len(REASONS), dtype=np.int8),
        "flag_meanings": " ".join(REASONS),
    }
