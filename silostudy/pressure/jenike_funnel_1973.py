"""Jenike, Johanson and Carson (1973), funnel flow: what the flow channel leaves of the cylinder to the rules of mass flow.

The channel widens upward from the outlet and meets the wall at the effective transition, D / (2 tan(channel half angle))
above the outlet.  Where the cylinder is at most 2 D deep the channel never reaches the wall: Janssen.  Where it is at least
5 D deep the part above the effective transition follows the strain energy of mass flow with its transition there.  The
peak at the effective transition itself and the bins between have design equations that the abstract read does not print.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking, parameters_of
from silostudy.pressure.family import CIRCULAR, PressureMethod
from silostudy.pressure.jenike_mass_flow import envelope_pressure
from silostudy.pressure.limits import SLENDERNESS, Limit, Measure

# H / D
SHALLOW = 2.0  # up to which a bin is shallow
TALL = 5.0  # from which on it is tall


def effective_transition(*, diameter, outlet_depth, channel_half_angle):
    """Depth (m) at which the flow channel meets the wall. Source: silo_handbook, section 4.5.3 (geometry)."""
    return outlet_depth - diameter / (2 * np.tan(channel_half_angle))


def _pressure(z, **given):
    slenderness = given["cylinder_depth"] / given["diameter"]
    transition = effective_transition(**{name: given[name] for name in parameters_of(effective_transition)})
    static = janssen.normal_pressure(z, **{name: given[name] for name in parameters_of(janssen.normal_pressure)})
    own = {name: given[name] for name in parameters_of(envelope_pressure)} | {"cylinder_depth": np.maximum(transition, z)}
    return np.where(slenderness <= SHALLOW, static, envelope_pressure(z, **own))


def _below_transition(z, *, cylinder_depth, diameter, outlet_depth, channel_half_angle):
    """Depth (m) below the effective transition; 0 in shallow bins, whose channel never reaches the wall."""
    below = z - effective_transition(diameter=diameter, outlet_depth=outlet_depth, channel_half_angle=channel_half_angle)
    return np.where(cylinder_depth / diameter <= SHALLOW, 0.0, below)


LIMITS = (
    Limit(
        measure=SLENDERNESS,
        gap=(SHALLOW, TALL),
        phases=("discharge",),
        why="the design equations between are not in the abstract read",
    ),
    Limit(
        measure=Measure("z - effective transition, for h_c/d_c > 2,", "m", _below_transition),
        most=0.0,
        phases=("discharge",),
        why="below it the source's equations were not at hand",
    ),
)


GIVEN = (
    *parameters_of(envelope_pressure),
    *parameters_of(janssen.normal_pressure),
    *parameters_of(effective_transition),
)

ROW = PressureMethod(
    key="jenike_funnel_1973",
    rank=70,
    title="Jenike 1973, funnel-flow rules",
    source="silo_handbook",
    locator="section 4.5.3",
    phases={
        "filling": janssen.STATE,
        "discharge": {
            "wall_normal_pressure": asking(
                _pressure, GIVEN, "Wall normal pressure (Pa) at depth z (m). Source: silo_handbook, section 4.5.3."
            )
        },
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    not_computed=("the peak at the effective transition, and bins with 2 < H/D < 5: design equations not in the abstract",),
    formula="H/D <= 2: Janssen; H/D >= 5: strain energy of mass flow above the effective transition; masked elsewhere",
    limits=LIMITS,
    validity="needs the half angle of the flow channel, which the source leaves to the solid and its handling; no published "
    "numbers: checked against the mass-flow method",
    colour="#E78AC3",
    marker="$f$",
    equilibrium=("filling",),
)
