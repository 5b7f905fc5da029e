"""AS 3774-1996, loads on bulk solids containers: initial and flow pressures on vertical walls, second-hand.

The printed standard was not seen and only one account of it was at hand.  What h_b counts is taken as the depth of the
cylinder and r_c as the hydraulic radius (with it the initial state is in vertical equilibrium); both are readings.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking, first_line, parameters_of
from silostudy.pressure.family import CIRCULAR, SLOT, USUAL_PHASES, PressureMethod
from silostudy.pressure.limits import SLENDERNESS, Limit

LEAST_RATIO = 0.35
GIVEN = ("unit_weight", "hydraulic_radius", "wall_friction", "internal_friction_angle")


def lateral_ratio(wall_friction, internal_friction_angle):
    """k (1). Source: as3774_1996, second-hand: [1 + sin^2 f - 2 sqrt(sin^2 f - mu^2 cos^2 f)]/(4 mu^2 + cos^2 f) >= 0.35."""
    sine, cosine = np.sin(internal_friction_angle), np.cos(internal_friction_angle)
    root = np.sqrt(np.maximum(sine**2 - (wall_friction * cosine) ** 2, 0.0))
    return np.maximum((1 + sine**2 - 2 * root) / (4 * wall_friction**2 + cosine**2), LEAST_RATIO)


def flow_factor(*, cylinder_depth, diameter, slot):
    """c_nf (1), flow over initial pressure.

    Source: as3774_1996, second-hand: max((7.6 (h_b/d_c)^0.06 - 6.4) c_c, 1.2 c_c), c_c 1 axisymmetric, 1.2 planar.
    """
    slenderness, plane = cylinder_depth / diameter, np.where(slot == 1, 1.2, 1.0)
    return np.maximum(7.6 * slenderness**0.06 - 6.4, 1.2) * plane


def friction_factor(*, slot):
    """Flow over initial wall friction (1): 1.2, planar 1.4. Source: as3774_1996, second-hand."""
    return np.where(slot == 1, 1.4, 1.2)


def _initial(quantity):
    def function(z, **given):
        ratio = lateral_ratio(given["wall_friction"], given["internal_friction_angle"])
        own = {name: given[name] for name in ("unit_weight", "hydraulic_radius", "wall_friction")}
        return janssen.STATE[quantity](z, **own, lateral_pressure_ratio=ratio)

    doc = f"{first_line(janssen.STATE[quantity])} Source: as3774_1996, second-hand."
    return asking(function, GIVEN, doc)


INITIAL = {quantity: _initial(quantity) for quantity in janssen.STATE}


def _flow(quantity, factor):
    initial = INITIAL[quantity]

    def function(z, **given):
        scale = factor(**{name: given[name] for name in parameters_of(factor)})
        return scale * initial(z, **{name: given[name] for name in parameters_of(initial)})

    return asking(function, (*parameters_of(initial), *parameters_of(factor)), f"{initial.__doc__} In flow.")


ROW = PressureMethod(
    key="as3774_1996",
    rank=170,
    title="AS 3774-1996 (second-hand)",
    source="as3774_1996",
    locator="second-hand account (printed standard not seen)",
    phases={
        "filling": INITIAL,
        "discharge": {
            "wall_normal_pressure": _flow("wall_normal_pressure", flow_factor),
            "wall_friction_traction": _flow("wall_friction_traction", friction_factor),
        },
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR | SLOT,
    not_computed=("squat containers, hoppers, eccentric flow, upper and lower values of the properties, rapid filling",),
    formula="p_ni = gamma r_c/mu (1 - exp(-z/z_o)), z_o = r_c/(mu k), k from phi and mu; flow times "
    "max(7.6 (h_b/d_c)^0.06 - 6.4, 1.2) c_c, friction times 1.2 (planar 1.4)",
    limits=(Limit(measure=SLENDERNESS, least=1.0, why="the account gives no pressures of squat containers"),),
    used={phase: janssen.for_state({"lateral_pressure_ratio": lateral_ratio}) for phase in USUAL_PHASES},
    validity="properties as handed over; second-hand: the printed standard was not seen; no published numbers: "
    "checked in 50-digit arithmetic and by equilibrium",
    colour="#FDB863",
    marker="8",
    equilibrium=("filling",),
)
