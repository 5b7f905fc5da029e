"""EN 1991-4:2006 on the hopper's wall, as functions of a method."""

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4 import hopper
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, characteristic
from silostudy.pressure.en1991_4.on_wall import CYLINDER, SEEN, filled, take

SHAPE = ("diameter", "perimeter", "hopper_half_angle", "slot")
WALL = (*PROPERTIES, "hopper_half_angle", "hopper_wall_friction", "slot")
HOPPER = (*CYLINDER, *SHAPE, "hopper_wall_friction")
NUMBERS = {
    "hopper_steep": "1 in a steep hopper, 0 in a shallow one (1).",
    "hopper_effective_friction": "Wall friction mobilised in the hopper (1): mu_h, or mu_heff of a shallow one.",
    "hopper_pressure_ratio": "Normal over vertical pressure in the hopper (1): F_f, or F_e in discharge of a steep one.",
    "hopper_exponent": "Exponent n (1) of the pressure in the hopper.",
}


def wall_state(phase, given):
    """(steep, mu_heff, F, n) (1) of the hopper's wall.

    Discharge in a shallow hopper is taken as filling: as two public programs of three have it.
    """
    properties = take(given, PROPERTIES) | {"wall_friction": given["hopper_wall_friction"]}
    beta = given["hopper_half_angle"]
    mu, k, _ = characteristic("hopper_filling", **properties)
    steep, effective = hopper.is_steep(beta, mu, k), hopper.effective_friction(beta, mu, k)
    ratio = hopper.filling_ratio(beta, effective)
    if phase == "discharge":
        mu, _, phi = characteristic("hopper_discharge", **properties)
        effective = np.where(steep, mu, effective)
        ratio = np.where(steep, hopper.discharge_ratio(beta, mu, phi), ratio)
    return steep, effective, ratio, hopper.exponent(ratio, beta, effective, given["slot"])


def load(given):
    """Vertical pressure p_vft (Pa) at the transition."""
    return filled(given["cylinder_depth"], "vertical_load", given)[1]


def _pressure(quantity, phase):
    def function(x, **given):
        _, mu, ratio, exponent = wall_state(phase, given)
        height = hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
        weight, top = given["unit_weight"] * height, load(given)
        p_v = hopper.vertical_pressure(x / height, weight=weight, exponent=exponent, top=top)
        return {"normal_pressure": ratio, "friction_traction": mu * ratio, "vertical_pressure": 1.0}[quantity] * p_v

    return asking(function, HOPPER, f"{quantity.replace('_', ' ').capitalize()} (Pa) at height x (m). {SEEN}", "x")


def pressures(phase):
    """Pressures on the hopper's wall in a phase."""
    return {f"hopper_{quantity}": _pressure(quantity, phase) for quantity in hopper.QUANTITIES}


def totals(phase):
    """Forces at the transition and the outlet (N), and the numbers behind; EN 1991-4 has no ring force."""
    p_v = _pressure("vertical_pressure", phase)

    def transition(**given):
        height = hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"])
        return load(given) * hopper_shape.area(height, **take(given, SHAPE))

    def outlet(**given):
        x = hopper_shape.outlet_height(given["outlet_width"], given["hopper_half_angle"])
        area = hopper_shape.area(x, **take(given, SHAPE))
        return np.where(x > 0, area * p_v(x, **take(given, HOPPER)), 0.0)

    return {
        "transition_force": asking(transition, HOPPER, f"Downward force p_vft A (N) on the hopper. {SEEN}", None),
        "outlet_force": asking(outlet, (*HOPPER, "outlet_width"), f"Downward force (N) on the outlet. {SEEN}", None),
        **{name: _number(place, phase, doc) for place, (name, doc) in enumerate(NUMBERS.items())},
    }


def _number(place, phase, doc):
    def function(**given):
        return wall_state(phase, given)[place].astype(float)

    return asking(function, WALL, f"{doc} {SEEN}", None)
