"""The hopper wall and the totals of a silo: pressures over the height, forces, and the vertical balance."""

from collections.abc import Mapping, Sequence

import numpy as np

from silostudy.compute.evaluate import AskedMethod, filled, masked
from silostudy.config.fields import expand
from silostudy.cube.variables import attributes
from silostudy.pressure import hopper_shape, mass_flow
from silostudy.pressure.calls import call, parameters_of
from silostudy.pressure.family import (
    HOPPER_QUANTITIES,
    IN_SCOPE,
    NO_QUANTITY,
    OUT_OF_RANGE,
    TOTALS,
    PressureMethod,
)
from silostudy.pressure.quadrature import hopper_wall_force
from silostudy.scene.expand import Expansion

BALANCE = ("hopper_weight", "hopper_wall_force", "hopper_balance")


def total_variables(expansion: Expansion, methods: list[AskedMethod], given: Sequence[Mapping]) -> dict:
    """Every total that a method of the study gives, each (method, phase, axes...), with its scope flags."""
    offered = [name for name in TOTALS if any(name in total for method in methods for total in method.row.totals.values())]
    return filled(expansion, given, methods, offered, lambda row, phase, parameters: _totals(row, phase, offered, parameters))


def hopper_variables(expansion: Expansion, methods: list[AskedMethod], given: Sequence[Mapping]) -> dict:
    """Pressures on the hopper wall (method, phase, axes..., hopper_position), the balance, and the hopper's shape."""
    places = np.array(expand(expansion.study.hopper_position))

    def on_wall(row, phase, parameters):
        top, bottom = heights(parameters)
        return _of_wall(row, phase, top - places * (top - bottom), parameters)

    wall = filled(expansion, given, methods, HOPPER_QUANTITIES, on_wall, places.size)
    balance = filled(expansion, given, methods, BALANCE, balanced)
    top, bottom = heights(given[0])
    shape = _shape(given[0]) | {"hopper_place_height": top - places * (top - bottom)}
    return {**wall, **balance, **shape, "hopper_position": places}


def heights(parameters: Mapping) -> tuple[np.ndarray, np.ndarray]:
    """Heights (m) of the transition and the outlet above the hopper's apex, shape (axes..., 1)."""
    half_angle = parameters["hopper_half_angle"]
    return (
        hopper_shape.apex_height(parameters["diameter"], half_angle),
        hopper_shape.outlet_height(parameters["outlet_width"], half_angle),
    )


def _totals(row: PressureMethod, phase: str, offered: list[str], parameters: Mapping) -> dict[str, tuple]:
    functions = row.totals.get(phase, {})
    totals = {}
    for name in offered if phase in row.phases else ():
        if name not in functions:
            totals[name] = np.nan, np.int8(NO_QUANTITY)
            continue
        value, scope = masked(row, name, phase, functions[name], None, parameters)
        totals[name] = value[..., 0], scope[..., 0]
    return totals


def _of_wall(row: PressureMethod, phase: str, x: np.ndarray, parameters: Mapping) -> dict[str, tuple]:
    functions = row.hopper.get(phase, {})
    return {
        name: masked(row, name, phase, functions[name], x, parameters) if name in functions else (np.nan, np.int8(NO_QUANTITY))
        for name in (HOPPER_QUANTITIES if phase in row.phases else ())
    }


def balanced(row: PressureMethod, phase: str, parameters: Mapping) -> dict[str, tuple]:
    """Weight of the hopper's contents (N), vertical wall force (N) by quadrature, and what vertical balance misses (1)."""
    functions, totals = row.hopper.get(phase, {}), row.totals.get(phase, {})
    if "hopper_friction_traction" not in functions or "outlet_force" not in totals:
        return dict.fromkeys(BALANCE, (np.nan, np.int8(NO_QUANTITY))) if phase in row.phases else {}
    (transition, scope), (outlet, _) = (
        _totals(row, phase, [name], parameters)[name] for name in ("transition_force", "outlet_force")
    )
    ring = np.nan_to_num(_totals(row, phase, ["ring_force"], parameters)["ring_force"][0])
    weight = parameters["unit_weight"] * _contents(parameters)
    wall = _wall_force(row, phase, parameters)
    missing = 1 - (wall + ring + outlet) / (weight[..., 0] + transition)
    scope = np.where(scope == IN_SCOPE, _of_wall_scope(row, phase, parameters), scope)
    scope = np.where((scope == IN_SCOPE) & np.isnan(missing), np.int8(OUT_OF_RANGE), scope)
    parts = (np.broadcast_to(value, scope.shape) for value in (weight[..., 0], wall, missing))
    return {name: (np.where(scope == IN_SCOPE, value, np.nan), scope) for name, value in zip(BALANCE, parts, strict=True)}


def _of_wall_scope(row: PressureMethod, phase: str, parameters: Mapping) -> np.ndarray:
    """Reason why the hopper wall's normal pressure is masked, at its top."""
    return _of_wall(row, phase, heights(parameters)[0], parameters)["hopper_normal_pressure"][1][..., 0]


def _contents(parameters: Mapping) -> np.ndarray:
    """Volume (m3) between the outlet and the transition."""
    names = parameters_of(hopper_shape.contents)
    top, bottom = (hopper_shape.contents(x, **{name: parameters[name] for name in names}) for x in heights(parameters))
    return top - bottom


def _wall_force(row: PressureMethod, phase: str, parameters: Mapping) -> np.ndarray:
    """Vertical force (N) on the hopper wall, of a rectangle on both pairs of walls.

    In two parts that meet at the peak of the pressure, where it has a kink.
    """
    top, bottom = heights(parameters)
    peak = row.totals[phase].get("peak_height")
    middle = (top + bottom) / 2 if peak is None else np.clip(call(peak, None, parameters), bottom, top)

    def force(side, slope):
        def pressures(x):
            wall = _of_wall(row, phase, x, parameters)
            return [wall[f"hopper_{side}{quantity}"][0] for quantity in ("normal_pressure", "friction_traction")]

        return sum(hopper_wall_force(pressures, part, parameters, slope) for part in ((bottom, middle), (middle, top)))

    slope, ratio = np.tan(parameters["hopper_half_angle"]), parameters["end_ratio"]
    whole = force("", slope)
    if "hopper_end_normal_pressure" not in row.hopper[phase]:
        return whole
    ends, share = force("end_", ratio * slope), (1 / (1 + ratio))[..., 0]  # in the perimeter; NaN where none is flatter
    return np.where(np.isnan(ends), whole, (1 - share) * whole + share * ends)


def _shape(parameters: Mapping) -> dict:
    """The hopper's dimensions and its flow pattern by the mass-flow limit, (axes...)."""
    friction = parameters["effective_friction_angle"], parameters["hopper_wall_friction"]
    pattern = mass_flow.flow_pattern(parameters["hopper_half_angle"], *friction, parameters["circular"])
    shape = {
        "hopper_height": heights(parameters)[0],
        "hopper_half_angle": parameters["hopper_half_angle"],
        "outlet_width": parameters["outlet_width"],
        "perimeter": parameters["perimeter"],
        "mass_flow_limit": mass_flow.limit_angle(*friction),
    }
    flags = np.arange(len(mass_flow.PATTERNS), dtype=np.int8)
    meanings = {"flag_values": flags, "flag_meanings": " ".join(mass_flow.PATTERNS)}
    told = {**attributes("flow_pattern"), **meanings}
    return {**{name: value[..., 0] for name, value in shape.items()}, "flow_pattern": (pattern[..., 0], told)}
