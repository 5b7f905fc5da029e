"""Jenike, Johanson and Carson (1973): mass flow, minimum recoverable strain energy in the cylinder below the switch.

Initial state: Janssen.  Discharge: the locus of the peak pressure at the switch level, over all switch levels.
Below the switch level z_s the mean vertical stress S follows S'' = (S - 2 nu gamma b) / (2 (1 - nu) b^2), b = R / mu,
with S = Janssen's at z_s and p = nu / (1 - nu) S at the transition.  Solving for p(z_s) and cancelling the terms in
2 nu gamma b by hand leaves only terms of one sign, with L = (H - z_s) / (b M), M = sqrt(2 (1 - nu)), k = nu / (1 - nu):

    p(z_s) = [ gamma b (1 - 2 nu k) (1 - sech L) + S (k + tanh(L) / M) ] / (1 + k M tanh L)

In a long slot the strain energy is that of plane strain, (1 - nu)(S^2 + p^2) - 2 nu S p: S'' = (S - k gamma b) / b^2, so that
M = 1 and k stands for 2 nu.  In the hopper the initial pressure is the straight line of section 4.5.3: every slice carries
its own weight and passes the stress above it on, so that the mean stress grows by gamma per metre and
p = (S_t + gamma (h - x)) / (1 + mu / tan theta).  While the switch travels up the hopper, the flow field of section 4.5.2
stands below it and this initial state above: what this passes down more than that takes up is a ring force at the switch.

It neither overflows in deep silos nor cancels in shallow ones, and holds for mu -> 0 and nu -> 0.5.
"""

from collections.abc import Callable

import numpy as np

from silostudy.pressure import hopper_shape, janssen
from silostudy.pressure.calls import asking, call, parameters_of
from silostudy.pressure.family import CONE_OR_WEDGE, PressureMethod
from silostudy.pressure.jenike_1969 import OF_STATE, SHAPE, State, flow_field
from silostudy.pressure.saturation import saturation


def envelope_pressure(
    z,
    *,
    unit_weight,
    hydraulic_radius,
    wall_friction,
    lateral_pressure_ratio,
    poisson_ratio,
    cylinder_depth,
    slot,
):
    """Horizontal wall pressure (Pa) when the switch level passes depth z (m): the design envelope in discharge.

    Source: silo_handbook, section 4.2.2 (d), worked out from the strain energy of section 4.5.3.
    """
    stress = janssen.vertical_pressure(
        z,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )
    k = poisson_ratio / (1 - poisson_ratio)
    m = np.where(slot == 1, 1.0, np.sqrt(2 * (1 - poisson_ratio)))
    # 1 - 2 nu k, in a slot 1 - k^2, without the difference that loses digits as nu goes to 1/2
    shear = (1 - 2 * poisson_ratio) / (1 - poisson_ratio) * np.where(slot == 1, 1 / (1 - poisson_ratio), 1 + poisson_ratio)
    below = cylinder_depth - z
    length = wall_friction * below / (hydraulic_radius * m)
    # b (1 - sech L), with the two small differences taken in closed form: (1 - sech L) / L = L sat(L)^2 / (1 + e^-2L)
    bulge = below / m * length * saturation(length) ** 2 / (1 + np.exp(-2 * length))
    tanh = np.tanh(length)
    weight_term = unit_weight * shear * bulge
    return (weight_term + stress * (k + tanh / m)) / (1 + k * m * tanh)


def envelope_traction(
    z,
    *,
    unit_weight,
    hydraulic_radius,
    wall_friction,
    lateral_pressure_ratio,
    poisson_ratio,
    cylinder_depth,
    slot,
):
    """Wall friction traction (Pa) that goes with the envelope pressure: mu p_h, as its equilibrium condition assumes.

    Source: silo_handbook, section 4.5.3.
    """
    return wall_friction * envelope_pressure(
        z,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
        poisson_ratio=poisson_ratio,
        cylinder_depth=cylinder_depth,
        slot=slot,
    )


def printed_envelope(
    z,
    *,
    unit_weight,
    hydraulic_radius,
    wall_friction,
    lateral_pressure_ratio,
    poisson_ratio,
    cylinder_depth,
    slot,
):
    """Horizontal wall pressure (Pa) as Table 4.2.5 prints it: the hydraulic radius of a plane slot, D/2 in place of D/4."""
    return envelope_pressure(
        z,
        unit_weight=unit_weight,
        hydraulic_radius=2 * hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
        poisson_ratio=poisson_ratio,
        cylinder_depth=cylinder_depth,
        slot=slot,
    )


def hopper_vertical_pressure(
    x, *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio, cylinder_depth, diameter, hopper_half_angle
):
    """Mean vertical pressure (Pa) at height x (m) above the hopper's apex before flow: the straight line through Janssen's.

    Source: silo_handbook, section 4.5.3 (a straight line; its slope gamma is what equilibrium of every slice leaves).
    """
    top = janssen.vertical_pressure(
        cylinder_depth,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
    )
    return top + unit_weight * (hopper_shape.apex_height(diameter, hopper_half_angle) - x)


def _hopper_wall(share: Callable, doc: str) -> Callable:
    def pressure(x, **given):
        steepness = hopper_shape.steepness(given["hopper_half_angle"], given["hopper_wall_friction"])
        return share(given["hopper_wall_friction"]) * call(hopper_vertical_pressure, x, given) / steepness

    return asking(pressure, (*parameters_of(hopper_vertical_pressure), "hopper_wall_friction"), doc, "x")


def outlet_force(
    *,
    unit_weight,
    hydraulic_radius,
    wall_friction,
    lateral_pressure_ratio,
    cylinder_depth,
    diameter,
    hopper_half_angle,
    outlet_width,
    perimeter,
    slot,
):
    """Downward force (N) on the outlet before flow. Source: silo_handbook, section 4.5.3."""
    x = hopper_shape.outlet_height(outlet_width, hopper_half_angle)
    stress = hopper_vertical_pressure(
        x,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        lateral_pressure_ratio=lateral_pressure_ratio,
        cylinder_depth=cylinder_depth,
        diameter=diameter,
        hopper_half_angle=hopper_half_angle,
    )
    section = hopper_shape.area(
        x,
        diameter=diameter,
        hydraulic_radius=hydraulic_radius,
        perimeter=perimeter,
        hopper_half_angle=hopper_half_angle,
        slot=slot,
    )
    return stress * section


def _switch_force(x, **given):
    """Ring force (N) on the wall while the switch stands at height x (m)."""
    initial = call(hopper_vertical_pressure, x, given) * hopper_shape.area(x, **{name: given[name] for name in SHAPE})
    return np.maximum(initial - State(flow_field, given).field_force(x), 0.0)


SWITCH = {
    "switch_force": asking(
        _switch_force,
        (*OF_STATE, *parameters_of(flow_field), *parameters_of(hopper_vertical_pressure)),
        "Ring force (N) on the wall while the switch stands at height x (m), from the straight-line initial state to the flow "
        "field. Source: silo_handbook, sections 4.5.3 (initial state) and 4.5.2 (flow field and switch).",
        "x",
    )
}
HOPPER = {
    "hopper_normal_pressure": _hopper_wall(
        lambda mu: 1.0, "Wall normal pressure (Pa) at height x (m) before flow. Source: silo_handbook, section 4.5.3."
    ),
    "hopper_friction_traction": _hopper_wall(
        lambda mu: mu, "Wall friction traction (Pa) at height x (m) before flow. Source: silo_handbook, section 4.5.3."
    ),
    "hopper_vertical_pressure": hopper_vertical_pressure,
}

ROW = PressureMethod(
    key="jenike_mass_flow",
    rank=40,
    title="Jenike, mass flow",
    source="silo_handbook",
    locator="section 4.2.2 (d)",
    phases={
        "filling": janssen.STATE,
        "switch": janssen.STATE,
        "discharge": {"wall_normal_pressure": envelope_pressure, "wall_friction_traction": envelope_traction},
    },
    initial_state="straight line (section 4.5.3)",
    hopper={"filling": HOPPER, "switch": SWITCH},
    totals={"filling": {"transition_force": janssen.transition_force, "outlet_force": outlet_force}},
    static=janssen.normal_pressure,
    plans=CONE_OR_WEDGE,
    formula="p(z_s) = [gamma b (1 - 2 nu k)(1 - sech L) + S (k + tanh(L)/M)] / (1 + k M tanh L), b = R / mu, "
    "L = (H - z_s) / (b M), M = sqrt(2 (1 - nu)), k = nu / (1 - nu), S Janssen's vertical pressure at z_s",
    validity="circular cylinder or long slot above a mass-flow hopper; in the hopper before flow the straight line of section "
    "4.5.3, at the switch from it to the flow field of section 4.5.2, masked where that does not exist; each "
    "depth at its own switch level, so the "
    "envelope is no single state (vertical pressure and axial force stay masked)",
    colour="#D55E00",
    marker="D",
    number="8",
    drawn="handbook",
    drawn_as_printed="misprint",
    as_printed={"discharge": {"wall_normal_pressure": printed_envelope}},
    equilibrium=("filling", "switch"),
)
