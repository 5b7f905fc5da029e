"""Hoop tension: the solid's pressure draws the wall apart, whatever the axial force."""

from silostudy.checks.family import SteelCheck


def hoop_stress(*, upper_internal_pressure, inner_radius, thickness):
    """Hoop stress (Pa), tension positive: p r / t, r = R_i + t/2. Source: en1993_4_1, membrane strength, two programs."""
    return upper_internal_pressure * (inner_radius + thickness / 2) / thickness


def strength(*, yield_stress, joint_efficiency, partial_yield):
    """Hoop stress (Pa) that the plate with its vertical welds bears: j f_y / gamma_M0. Source: en1993_4_1, two programs."""
    return joint_efficiency * yield_stress / partial_yield


def needed(*, upper_internal_pressure, inner_radius, yield_stress, joint_efficiency, partial_yield):
    """Thickness (m) at which the hoop stress meets the strength. Source: en1993_4_1, membrane strength, two programs."""
    most = strength(yield_stress=yield_stress, joint_efficiency=joint_efficiency, partial_yield=partial_yield)
    return upper_internal_pressure * inner_radius / (most - upper_internal_pressure / 2)


ROW = SteelCheck(
    key="hoop_tension",
    rank=0,
    title="hoop tension",
    source="en1993_4_1",
    locator="membrane strength of the cylinder, second-hand",
    effect=hoop_stress,
    resistance=strength,
    needed=needed,
    formula="n = p r <= j t f_y / gamma_M0, p the largest pressure times its factor, gamma_M0 = 1",
    validity="membrane force alone: the joints by the efficiency j that the user gives (codes disagree on lapped joints, EN's "
    "own table was not seen), no bending at edges and rings, no axial force beside it (`membrane_yield` counts it); two public "
    "programs, printed standard not seen",
)
