"""Jenike, Johanson and Carson (1973): mass flow, minimum recoverable strain energy in the cylinder below the switch.

Initial state: Janssen.  Discharge: the locus of the peak pressure at the switch level, over all switch levels.
Below the switch level z_s the mean vertical stress S follows S'' = (S - 2 nu gamma b) / (2 (1 - nu) b^2), b = R / mu,
with S = Janssen's at z_s and p = nu / (1 - nu) S at the transition.  Solving for p(z_s) and cancelling the terms in
2 nu gamma b by hand leaves only terms of one sign, with L = (H - z_s) / (b M), M = sqrt(2 (1 - nu)), k = nu / (1 - nu):

    p(z_s) = [ gamma b (1 - 2 nu k) (1 - sech L) + S (k + tanh(L) / M) ] / (1 + k M tanh L)

It neither overflows in deep silos nor cancels in shallow ones, and holds for mu -> 0 and nu -> 0.5.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod
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
    m, k = np.sqrt(2 * (1 - poisson_ratio)), poisson_ratio / (1 - poisson_ratio)
    below = cylinder_depth - z
    length = wall_friction * below / (hydraulic_radius * m)
    # b (1 - sech L), with the two small differences taken in closed form: (1 - sech L) / L = L sat(L)^2 / (1 + e^-2L)
    bulge = below / m * length * saturation(length) ** 2 / (1 + np.exp(-2 * length))
    tanh = np.tanh(length)
    weight_term = unit_weight * (1 - 2 * poisson_ratio * k) * bulge
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
    )


ROW = PressureMethod(
    key="jenike_mass_flow",
    title="Jenike, mass flow",
    source="silo_handbook",
    locator="section 4.2.2 (d)",
    phases={
        "filling": janssen.STATE,
        "discharge": {"wall_normal_pressure": envelope_pressure, "wall_friction_traction": envelope_traction},
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p(z_s) = [gamma b (1 - 2 nu k)(1 - sech L) + S (k + tanh(L)/M)] / (1 + k M tanh L), b = R / mu, "
    "L = (H - z_s) / (b M), M = sqrt(2 (1 - nu)), k = nu / (1 - nu), S Janssen's vertical pressure at z_s",
    validity="circular cylinder above a mass-flow hopper; each depth at its own switch level, so the envelope is no "
    "single state (vertical pressure and axial force stay masked)",
    colour="#D55E00",
    marker="D",
    number="8",
    as_printed={"discharge": {"wall_normal_pressure": printed_envelope}},
    equilibrium=("filling",),
)
