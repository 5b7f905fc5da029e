"""EN 1991-4:2006 on the hopper's wall, as functions of a method."""

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.calls import asking, call, parameters_of
from silostudy.pressure.en1991_4 import factors, hopper
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, characteristic
from silostudy.pressure.en1991_4.on_wall import CYLINDER, SEEN, filled, take

SHAPE = ("diameter", "hydraulic_radius", "perimeter", "hopper_half_angle", "slot")
WALL = (*PROPERTIES, "hopper_half_angle", "hopper_wall_friction", "slot", "end_ratio")
HOPPER = (*CYLINDER, *SHAPE, "hopper_wall_friction", "end_ratio")
# the end walls of a rectangle are flatter than its long ones, and its slices carry on both
PLANS = {name: frozenset({"rectangular"}) for name in ("hopper_end_normal_pressure", "hopper_end_friction_traction")}
FLOW_ANGLE = f"Turn of the stresses at the wall in flow (rad): eps of F_e. {SEEN}"
NUMBERS = {
    "hopper_steep": "1 in a steep hopper, 0 in a shallow one (1), by its long walls.",
    "hopper_effective_friction": "Wall friction mobilised on the long walls (1): mu_h, or mu_heff of a shallow hopper.",
    "hopper_pressure_ratio": "Normal over vertical pressure at the long walls (1): F_f, or F_e in discharge of a steep hopper.",
}


def wall_state(phase, half_angle, given):
    """State (steep, mu_heff, F) (1) of the hopper's walls of one half angle, each pair judged steep or shallow by itself.

    Discharge in a shallow hopper is taken as filling: as two public programs of three have it.
    """
    properties = take(given, PROPERTIES) | {"wall_friction": given["hopper_wall_friction"], "contact_share": 1.0}
    mu, k, _ = characteristic("hopper_filling", **properties)
    steep, effective = hopper.is_steep(half_angle, mu, k), hopper.effective_friction(half_angle, mu, k)
    ratio = hopper.filling_ratio(half_angle, effective)
    if phase == "discharge":
        mu, _, phi = characteristic("hopper_discharge", **properties)
        effective = np.where(steep, mu, effective)
        ratio = np.where(steep, hopper.discharge_ratio(half_angle, mu, phi), ratio)
    return steep, effective, ratio


def half_angles(given):
    """Half angles (rad) of the long walls and of the end walls; those of a cone or a square pyramid are the same."""
    return given["hopper_half_angle"], hopper_shape.end_half_angle(given["hopper_half_angle"], given["end_ratio"])


def exponent(phase, given):
    """Exponent n (1): the sum over both pairs of walls; a wedge has one pair."""
    (_, mu, ratio), (_, end_mu, end_ratio) = (wall_state(phase, angle, given) for angle in half_angles(given))
    long, ends = half_angles(given)
    return hopper.exponent(ratio, long, mu) + (1 - given["slot"]) * hopper.exponent(end_ratio, ends, end_mu)


def flow_angle(**given):
    """Angle eps (rad) of the steep hopper in discharge."""
    properties = take(given, PROPERTIES) | {"wall_friction": given["hopper_wall_friction"], "contact_share": 1.0}
    mu, _, phi = characteristic("hopper_discharge", **properties)
    return hopper.flow_angle(mu, phi)


def load(magnifier, given):
    """Vertical pressure p_vft (Pa) on the bottom: C_b times that at the transition."""
    return call(magnifier, None, given) * filled(given["cylinder_depth"], "vertical_load", given)[1]


def mean_pressure(x, phase, magnifier, given):
    """Mean vertical pressure p_v (Pa) at height x (m) above the apex."""
    height = hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
    weight, top = given["unit_weight"] * height, load(magnifier, given)
    return hopper.vertical_pressure(x / height, weight=weight, exponent=exponent(phase, given), top=top)


def _pressure(quantity, phase, magnifier, pair=0):
    def function(x, **given):
        _, mu, ratio = wall_state(phase, half_angles(given)[pair], given)
        share = {"normal_pressure": ratio, "friction_traction": mu * ratio, "vertical_pressure": 1.0}[quantity]
        return share * mean_pressure(x, phase, magnifier, given)

    where = " on the end walls" * pair
    names = (*HOPPER, *parameters_of(magnifier))
    return asking(function, names, f"{quantity.replace('_', ' ').capitalize()} (Pa){where} at height x (m). {SEEN}", "x")


def pressures(phase, magnifier=factors.bottom_magnifier):
    """Pressures on the hopper's wall in a phase, under a load magnified by C_b."""
    functions = {f"hopper_{quantity}": _pressure(quantity, phase, magnifier) for quantity in hopper.QUANTITIES}
    return functions | {
        f"hopper_end_{quantity}": _pressure(quantity, phase, magnifier, pair=1) for quantity in hopper.QUANTITIES[:2]
    }


def totals(phase, magnifier=factors.bottom_magnifier):
    """Load on the bottom, forces at the transition and the outlet, and the numbers behind; EN 1991-4 has no ring force."""
    own = parameters_of(magnifier)

    def bottom(**given):
        return load(magnifier, given)

    def transition(**given):
        height = hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
        return load(magnifier, given) * hopper_shape.area(height, **take(given, SHAPE))

    def outlet(**given):
        x = hopper_shape.outlet_height(given["outlet_width"], given["hopper_half_angle"])
        area = hopper_shape.area(x, **take(given, SHAPE))
        return np.where(x > 0, area * mean_pressure(x, phase, magnifier, given), 0.0)

    def power(**given):
        return exponent(phase, given)

    return {
        "bottom_load_magnifier": magnifier,
        "bottom_pressure": asking(bottom, (*CYLINDER, *own), f"Mean vertical pressure p_vft (Pa) on the bottom. {SEEN}", None),
        "transition_force": asking(transition, (*HOPPER, *own), f"Downward force p_vft A (N) on the hopper. {SEEN}", None),
        "outlet_force": asking(outlet, (*HOPPER, *own, "outlet_width"), f"Downward force (N) on the outlet. {SEEN}", None),
        **{name: _number(place, phase, doc) for place, (name, doc) in enumerate(NUMBERS.items())},
        **({"hopper_flow_angle": asking(flow_angle, WALL, FLOW_ANGLE, None)} if phase == "discharge" else {}),
        "hopper_exponent": asking(power, WALL, f"Exponent n (1) of the pressure in the hopper. {SEEN}", None),
    }


def _number(place, phase, doc):
    def function(**given):
        return wall_state(phase, given["hopper_half_angle"], given)[place].astype(float)

    return asking(function, WALL, f"{doc} {SEEN}", None)
