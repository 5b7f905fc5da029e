"""AS 3774-1996 on the hopper's wall, cone and wedge, after filling and in flow: both in equilibrium, slice by slice."""

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.as3774_1996 import wall
from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4 import hopper as slices

SHAPE = ("diameter", "hydraulic_radius", "perimeter", "hopper_half_angle", "slot")
WALL = ("hopper_half_angle", "hopper_wall_friction", "internal_friction_angle", "slot")
GIVEN = (*wall.GIVEN, *SHAPE, "hopper_wall_friction")
SEEN = "Source: as3774_1996, second-hand (one account), and the equilibrium of slices."


def filling_ratio(*, hopper_half_angle, hopper_wall_friction):
    """Ratio k_h (1) of normal to vertical pressure after filling: tan a/(tan a + mu_h).

    Source: as3774_1996, second-hand (one account), and equilibrium: with it every slice carries its own weight.
    """
    slope = np.tan(hopper_half_angle)
    return slope / (slope + hopper_wall_friction)


def pressure_ratio(phase, given):
    """Ratio k_h or k_hf (1) of normal to vertical pressure: in flow that of EN 1991-4, whose eps is twice this code's eta."""
    angle, mu = given["hopper_half_angle"], given["hopper_wall_friction"]
    if phase == "filling":
        return filling_ratio(hopper_half_angle=angle, hopper_wall_friction=mu)
    return slices.discharge_ratio(angle, mu, given["internal_friction_angle"])


def exponent(phase, given):
    """Exponent j (1): c_h [k (mu_h cot a + 1) - 1], c_h 2 for a cone, 1 for a wedge; 0 after filling."""
    angle, mu = given["hopper_half_angle"], given["hopper_wall_friction"]
    return (2 - given["slot"]) * slices.exponent(pressure_ratio(phase, given), angle, mu)


def mean_pressure(x, phase, given):
    """Mean vertical pressure (Pa) at height x (m) above the apex, under p_vi at the transition."""
    height = hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
    if phase == "filling":  # j = 0: it grows by gamma per metre
        return wall.load(given) + given["unit_weight"] * (height - x)
    weight = given["unit_weight"] * height
    return slices.vertical_pressure(x / height, weight=weight, exponent=exponent(phase, given), top=wall.load(given))


def _pressure(quantity, phase):
    def function(x, **given):
        ratio, mu = pressure_ratio(phase, given), given["hopper_wall_friction"]
        share = {"normal_pressure": ratio, "friction_traction": mu * ratio, "vertical_pressure": 1.0}[quantity]
        return share * mean_pressure(x, phase, given)

    return asking(function, GIVEN, f"{quantity.replace('_', ' ').capitalize()} (Pa) at height x (m). {SEEN}", "x")


def pressures(phase):
    """Pressures on the hopper's wall in a phase."""
    return {f"hopper_{quantity}": _pressure(quantity, phase) for quantity in slices.QUANTITIES}


def _area(x, given):
    return hopper_shape.area(x, **{name: given[name] for name in SHAPE})


def totals(phase):
    """Forces at the transition and the outlet (N), and the numbers behind."""

    def transition(**given):
        return wall.load(given) * _area(hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"]), given)

    def outlet(**given):
        x = hopper_shape.outlet_height(given["outlet_width"], given["hopper_half_angle"])
        return _area(x, given) * mean_pressure(x, phase, given)

    return {
        "transition_force": asking(transition, GIVEN, f"Downward force p_vi A (N) on the hopper. {SEEN}", None),
        "outlet_force": asking(outlet, (*GIVEN, "outlet_width"), f"Downward force (N) on the outlet. {SEEN}", None),
        "hopper_pressure_ratio": asking(
            lambda **given: pressure_ratio(phase, given), WALL, f"Normal over vertical pressure (1), k_h or k_hf. {SEEN}", None
        ),
        "hopper_exponent": asking(
            lambda **given: exponent(phase, given), WALL, f"Exponent j (1) of the pressure in the hopper. {SEEN}", None
        ),
    }
