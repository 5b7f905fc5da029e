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
from silostudy.compute.hopper import hopper_variables, total_variables
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
)


def pressure_cube(expansion: Resolved) -> xr.Dataset:
    """The cube of a study: each quantity (method, phase, axes..., depth) with a scope flag beside it."""
    methods = methods_of(expansion)
    z = depths_in_metres(expansion)
    shape = (len(methods), len(expansion.study.phases), *z.shape)
    values = {name: np.full(shape, np.nan) for name in (*offered(methods), "overpressure_factor")}
    scopes = {name: np.full(shape, NO_PHASE, dtype=np.int8) for name in values}
    handed = {name: np.full(shape[:1] + shape[2:-1], np.nan) for name in (*HANDED, *HANDED_IF_KNOWN, "wall_friction_capped")}
    for m, method in enumerate(methods):
        parameters = gather(expansion, method)
        _note(handed, m, parameters, shape[2:-1])
        for p, phase in enumerate(expansion.study.phases):
            found = evaluate(method, phase, z, parameters)
            for name in values.keys() & found.keys():
                values[name][m, p], scopes[name][m, p] = found[name]
    return _assemble(expansion, methods, z, values, scopes, handed)


def silent_cube(expansion: Resolved) -> xr.Dataset:
    """Wall pressures at the quarters of the depth alone, for what is told of silent methods before computing."""
    methods = methods_of(expansion)
    heights = np.array([case.scene.silo.cylinder_depth for case in expansion.cases]).reshape(expansion.shape)
    z = heights[..., None] * np.array([0.25, 0.5, 0.75, 1.0])
    shape = (len(methods), len(expansion.study.phases), *z.shape)
    value, scope = np.full(shape, np.nan), np.full(shape, NO_PHASE, dtype=np.int8)
    for m, method in enumerate(methods):
        parameters = gather(expansion, method)
        for p, phase in enumerate(expansion.study.phases):
            if found := evaluate(method, phase, z, parameters):
                value[m, p], scope[m, p] = found["wall_normal_pressure"]
    data = {"wall_normal_pressure": value, **with_reasons({"wall_normal_pressure": scope}), **method_coordinates(methods)}
    data |= {"phase": list(expansion.study.phases), "depth": z, "relative_depth": np.array([0.25, 0.5, 0.75, 1.0])}
    data |= limit_variables(expansion, methods)
    return assemble(expansion.study, "pressure", data, sources=[], sweep=sweep_of(expansion))


def offered(methods: list[AskedMethod]) -> list[str]:
    """The quantities of the cylinder that a cube holds: the usual ones, and what else a method of the study gives."""
    given = {name for method in methods for functions in method.row.phases.values() for name in functions}
    return [name for name in QUANTITIES if name in USUAL_QUANTITIES or name in given]


def depths_in_metres(expansion: Resolved) -> np.ndarray:
    """Depth (m) of every value, shape (axes..., depth)."""
    depths = np.array(expansion.study.depths)
    if expansion.study.depth_m is not None:
        return np.broadcast_to(depths, (*expansion.shape, depths.size))
    heights = np.array([case.scene.silo.cylinder_depth for case in expansion.cases]).reshape(expansion.shape)
    return heights[..., None] * depths


def evaluate(method: AskedMethod, phase: str, z: np.ndarray, parameters: Mapping) -> dict[str, tuple]:
    """quantity -> (values, scope flags) of one method in one phase; empty where the method does not cover the phase."""
    row, functions = method.row, method.functions(phase)
    if not functions:
        return {}
    found = {}
    for name in QUANTITIES:
        if name in functions:
            value = masked(row, name, phase, functions[name], z, parameters)
            found[name] = above_contact(value, z, parameters)
        else:
            found[name] = np.nan, np.int8(NO_QUANTITY)
    pressure, scope = found["wall_normal_pressure"]
    static = call(row.static, np.where(z > 0, z, np.nan), parameters)  # 0 / 0 at the surface is no factor
    found["overpressure_factor"] = pressure / static, np.where((z > 0) | (scope != IN_SCOPE), scope, OUT_OF_RANGE)
    return found


def _note(handed: dict[str, np.ndarray], m: int, parameters: Mapping, shape: tuple[int, ...]) -> None:
    for name in (*HANDED, *HANDED_IF_KNOWN):
        handed[name][m] = parameters[name].reshape(shape)
    capped = parameters["wall_friction"] < parameters["wall_friction_uncapped"]
    handed["wall_friction_capped"][m] = capped.reshape(shape)


def _assemble(expansion: Resolved, methods: list[AskedMethod], z, values, scopes, handed) -> xr.Dataset:
    study = expansion.study
    data: dict = {**values, **with_reasons(scopes), **method_coordinates(methods), "phase": list(study.phases)}
    for name, value in handed.items():
        if name not in HANDED_IF_KNOWN or not np.isnan(value).all():
            data[name] = value.astype(np.int8) if name == "wall_friction_capped" else value
    for name in ("hydraulic_radius", "cylinder_depth"):
        data[name] = np.array([getattr(case.scene.silo, name) for case in expansion.cases]).reshape(expansion.shape)
    data["contact_depth"] = np.array([case.scene.silo.contact_depth for case in expansion.cases]).reshape(expansion.shape)
    data |= depth_coordinates(study, z) | total_variables(expansion, methods) | channel_variables(expansion, methods, z)
    data |= used_variables(expansion, methods) | limit_variables(expansion, methods) | {"used_for": list(USED_FOR)}
    if study.hopper_position is not None:
        data |= hopper_variables(expansion, methods)
    notes = {**expansion.promise, **study.own_methods}
    return assemble(study, "pressure", data, sources=sources_of(expansion), notes=notes, sweep=sweep_of(expansion))


def depth_coordinates(study, z: np.ndarray) -> dict[str, np.ndarray]:
    """Depths as the study asks for them: in metres, or relative with what they come to (m) in every case."""
    if study.depth_m is not None:
        return {"depth": np.array(study.depths)}
    return {"depth": z, "relative_depth": np.array(study.depths)}
