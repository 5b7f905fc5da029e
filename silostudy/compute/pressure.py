"""The pressure stage: every method of a study over all its cases in one vectorised call each."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved
from silostudy.compute.axes import sweep_of
from silostudy.compute.behind import limit_variables, used_variables
from silostudy.compute.channel import channel_variables
from silostudy.compute.evaluate import (
    AskedMethod,
    above_contact,
    gather,
    masked,
    method_coordinates,
    methods_of,
    sources_of,
    with_reasons,
)
from silostudy.compute.floor import floor_variables
from silostudy.compute.hopper import hopper_variables, total_variables
from silostudy.compute.silo_numbers import contents_mass, silo_variables
from silostudy.cube.assemble import assemble
from silostudy.pressure.calls import call
from silostudy.pressure.family import (
    IN_SCOPE,
    NO_PHASE,
    NO_QUANTITY,
    OUT_OF_RANGE,
    QUANTITIES,
    USED_FOR,
    USUAL_QUANTITIES,
)

HANDED = ("unit_weight", "internal_friction_angle", "wall_friction", "lateral_pressure_ratio", "poisson_ratio")
HANDED_IF_KNOWN = (
    "unit_weight_lower",
    "effective_friction_angle",
    "hopper_wall_friction",
    "repose_angle",
    "a_phi",
    "a_K",
    "a_mu",
    "patch_factor",
)


def pressure_cube(expansion: Resolved) -> xr.Dataset:
    """The cube of a study: each quantity (method, phase, axes..., depth) with a scope flag beside it."""
    study, methods, z = expansion.study, methods_of(expansion), depths_in_metres(expansion)
    given = [gather(expansion, method) for method in methods]
    data = _labels(expansion, methods) | _on_wall(expansion, methods, given, z) | _handed(given)
    for name in ("hydraulic_radius", "cylinder_depth", "contact_depth"):
        data[name] = np.array([getattr(case.scene.silo, name) for case in expansion.cases]).reshape(expansion.shape)
    data |= silo_variables(expansion, methods) | {"contents_mass": contents_mass(expansion, given)}
    data |= depth_coordinates(study, z) | {"used_for": list(USED_FOR)}
    for variables in (total_variables, used_variables, limit_variables):
        data |= variables(expansion, methods, given)
    data |= channel_variables(expansion, methods, given, z)
    if study.floor_position is not None:
        data |= floor_variables(expansion, methods, given)
    if study.hopper_position is not None:
        data |= hopper_variables(expansion, methods, given)
    notes = {**expansion.promise, **study.own_methods}
    return assemble(study, "pressure", data, sources=sources_of(expansion), notes=notes, sweep=sweep_of(expansion))


def silent_cube(expansion: Resolved) -> xr.Dataset:
    """The cylinder at the quarters of its depth alone, for what is told of silent methods before computing."""
    methods, quarters = methods_of(expansion), np.array([0.25, 0.5, 0.75, 1.0])
    given = [gather(expansion, method) for method in methods]
    z = _heights(expansion)[..., None] * quarters
    data = _labels(expansion, methods) | _on_wall(expansion, methods, given, z) | {"depth": z, "relative_depth": quarters}
    data |= limit_variables(expansion, methods, given)
    return assemble(expansion.study, "pressure", data, sources=[], sweep=sweep_of(expansion))


def _labels(expansion: Resolved, methods: list[AskedMethod]) -> dict:
    return {**method_coordinates(methods), "phase": list(expansion.study.phases)}


def _on_wall(expansion: Resolved, methods: list[AskedMethod], given: list[dict], z: np.ndarray) -> dict:
    """Every quantity of the cylinder's wall with its scope flags."""
    shape = (len(methods), len(expansion.study.phases), *z.shape)
    values = {name: np.full(shape, np.nan) for name in (*offered(methods), "overpressure_factor")}
    scopes = {name: np.full(shape, NO_PHASE, dtype=np.int8) for name in values}
    for m, (method, parameters) in enumerate(zip(methods, given, strict=True)):
        for p, phase in enumerate(expansion.study.phases):
            quantities = evaluate(method, phase, z, parameters)
            for name in values.keys() & quantities.keys():
                values[name][m, p], scopes[name][m, p] = quantities[name]
    return values | with_reasons(scopes)


def _handed(given: list[dict]) -> dict[str, np.ndarray]:
    """The properties of the solid that each method was handed, (method, axes...)."""
    handed = {name: np.array([parameters[name] for parameters in given])[..., 0] for name in (*HANDED, *HANDED_IF_KNOWN)}
    handed = {name: value for name, value in handed.items() if name in HANDED or not np.isnan(value).all()}
    capped = [parameters["wall_friction"] < parameters["wall_friction_uncapped"] for parameters in given]
    return {**handed, "wall_friction_capped": np.array(capped).astype(np.int8)[..., 0]}


def offered(methods: list[AskedMethod]) -> list[str]:
    """The quantities of the cylinder that a cube holds: the usual ones, and what else a method of the study gives."""
    given = {name for method in methods for functions in method.row.phases.values() for name in functions}
    return [name for name in QUANTITIES if name in USUAL_QUANTITIES or name in given]


def depths_in_metres(expansion: Resolved) -> np.ndarray:
    """Depth (m) of every value, shape (axes..., depth)."""
    depths = np.array(expansion.study.depths)
    if expansion.study.depth_m is not None:
        return np.broadcast_to(depths, (*expansion.shape, depths.size))
    return _heights(expansion)[..., None] * depths


def _heights(expansion: Resolved) -> np.ndarray:
    return np.array([case.scene.silo.cylinder_depth for case in expansion.cases]).reshape(expansion.shape)


def evaluate(method: AskedMethod, phase: str, z: np.ndarray, parameters: Mapping) -> dict[str, tuple]:
    """Values and scope flags by quantity of one method in one phase; empty where the method does not cover the phase."""
    row, functions = method.row, method.functions(phase)
    if not functions:
        return {}
    quantities = {}
    for name in QUANTITIES:
        if name in functions:
            value = masked(row, name, phase, functions[name], z, parameters)
            quantities[name] = above_contact(value, z, parameters)
        else:
            quantities[name] = np.nan, np.int8(NO_QUANTITY)
    pressure, scope = quantities["wall_normal_pressure"]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        static = call(row.static, z, parameters)
        factor = pressure / np.where(static > 0, static, np.nan)  # 0 / 0, as at the surface, is no factor
    quantities["overpressure_factor"] = factor, np.where((scope == IN_SCOPE) & np.isnan(factor), np.int8(OUT_OF_RANGE), scope)
    return quantities


def depth_coordinates(study, z: np.ndarray) -> dict[str, np.ndarray]:
    """Depths as the study asks for them: in metres, or relative with what they come to (m) in every case."""
    if study.depth_m is not None:
        return {"depth": np.array(study.depths)}
    return {"depth": z, "relative_depth": np.array(study.depths)}
