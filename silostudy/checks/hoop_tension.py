"""Hoop tension: the solid's pressure draws the wall apart, whatever the axial force."""

from silostudy.checks.family import SteelCheck


def hoop_stress(*, upper_internal_pressure, inner_radius, thickness):
    """Hoop stress (Pa), tension positive: p r / t, r = R_i + t/2. Source: en1993_4_1, membrane strength, two programs."""
    return upper_internal_pressure * (inner_radius + thickness / 2) / thickness


def utilisation(*, upper_internal_pressure, inner_radius, thickness, yield_stress):
    """Hoop stress over yield stress (1). Source: en1993_4_1, membrane strength, two programs."""
    wall = {"inner_radius": inner_radius, "thickness": thickness}
    return hoop_stress(upper_internal_pressure=upper_internal_pressure, **wall) / yield_stress


def needed(*, upper_internal_pressure, inner_radius, yield_stress):
    """Thickness (m) at which the hoop stress meets the yield stress. Source: en1993_4_1, membrane strength, two programs."""
    return upper_internal_pressure * inner_radius / (yield_stress - upper_internal_pressure / 2)


ROW = SteelCheck(
    key="hoop_tension",
    title="hoop tension",
    source="en1993_4_1",
    locator="membrane strength of the cylinder, second-hand",
    utilisation=utilisation,
    needed=needed,
    formula="n = p r <= t f_y, p the largest pressure times the safety factor, gamma_M0 = 1",
    validity="membrane force alone: no joints, no bending at edges and rings, no axial force beside it (`membrane_yield` "
    "counts it); two public programs, printed standard not seen",
)
