"""The vertical force on a hopper's wall over the places at which its pressures are taken."""

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.calls import call, parameters_of
from silostudy.pressure.jenike_1969 import ROW
from silostudy.pressure.quadrature import double_exponential, hopper_wall_force

LADDERS = {
    "double-exponential rule in two parts": (5, 9, 13, 21, 31, 41, 61, 81),
    "even places, trapezoidal rule": (5, 9, 17, 33, 65, 129, 257, 513, 1025),
}
HOPPERS = 200  # steeper than where so smooth a wall has no initial field, 21.8 degrees
PHASES = ("filling", "discharge")  # both fields
DIAMETER = 5.0  # m, at the transition
OUTLET = 0.6  # m
BIN: dict = {
    "unit_weight": 8e3, "wall_friction": 0.3, "lateral_pressure_ratio": 0.5, "hydraulic_radius": 1.25, "diameter": DIAMETER,
    "perimeter": np.pi * DIAMETER, "cylinder_depth": np.geomspace(2.5, 25.0, HOPPERS)[:, None], "length": 0.0, "slot": 0.0,
    "hopper_half_angle": np.radians(np.linspace(8.0, 21.5, HOPPERS))[:, None], "hopper_wall_friction": 0.3,
    "effective_friction_angle": np.radians(45.0), "outlet_width": OUTLET,
}  # fmt: skip
TOP = hopper_shape.apex_height(DIAMETER, BIN["hopper_half_angle"])
SLOPE = np.tan(BIN["hopper_half_angle"])
BOTTOM = hopper_shape.outlet_height(OUTLET, BIN["hopper_half_angle"])


def prepare(ladder: str, setting: float):
    """The force before and in flow; in two parts that meet at the kink of the pressure, or straight over it."""
    peaks = {phase: np.clip(call(ROW.totals[phase]["peak_height"], None, BIN), BOTTOM, TOP) for phase in PHASES}
    even = np.linspace(0.0, 1.0, int(setting)), np.full(int(setting), 1.0 / (setting - 1))
    even[1][[0, -1]] /= 2

    def force(phase):
        pressures = [ROW.hopper[phase][f"hopper_{name}"] for name in ("normal_pressure", "friction_traction")]

        def both(x):
            return [call(pressure, x, BIN) for pressure in pressures]

        if ladder.startswith("even"):
            return hopper_wall_force(both, (BOTTOM, TOP), BIN, SLOPE, even)
        rule, peak = double_exponential(int(setting)), peaks[phase]
        return sum(hopper_wall_force(both, part, BIN, SLOPE, rule) for part in ((BOTTOM, peak), (peak, TOP)))

    return lambda: {f"{phase}_force": force(phase) for phase in PHASES}


def reference():
    """Force that equilibrium leaves to the wall: weight and load from above, less what ring and outlet carry."""
    shape = {name: BIN[name] for name in parameters_of(hopper_shape.contents)}
    top, bottom = (hopper_shape.contents(x, **shape) for x in (TOP, BOTTOM))
    forces = {}
    for phase in PHASES:
        load, ring, outlet = (
            call(ROW.totals[phase][f"{name}_force"], None, BIN) for name in ("transition", "ring", "outlet")
        )  # fmt: skip
        forces[f"{phase}_force"] = (BIN["unit_weight"] * (top - bottom) + load - ring - outlet)[:, 0]
    return forces
