"""NASA SP-8007: a lower bound to tests of cylinders without rings (second-hand transcription)."""

import numpy as np

from silostudy.buckling.classical import capped_at_yield
from silostudy.buckling.family import (
    NO_RINGS,
    OUT_OF_RANGE,
    SUCTION,
    BucklingRule,
    classical_stress,
    under_suction,
    with_rings,
)

GREATEST_SLENDERNESS = 1500


def correlation_factor(radius_over_thickness):
    """gamma (1): 1 - 0.901 (1 - exp(-sqrt(R/t) / 16)). Source: nasa_sp8007, second-hand transcription."""
    return 1 + 0.901 * np.expm1(-np.sqrt(radius_over_thickness) / 16)


def strength(*, youngs_modulus, shell_poisson_ratio, yield_stress, shell_radius, thickness):
    """Strength (Pa): gamma times the classical stress, at most the yield stress. Source: nasa_sp8007, second-hand."""
    classical = classical_stress(
        youngs_modulus=youngs_modulus,
        shell_poisson_ratio=shell_poisson_ratio,
        shell_radius=shell_radius,
        thickness=thickness,
    )
    return capped_at_yield(correlation_factor(shell_radius / thickness) * classical, yield_stress)


def too_thin(*, shell_radius, thickness):
    """True from R/t = 1500 on. Source: nasa_sp8007, second-hand transcription."""
    return shell_radius / thickness >= GREATEST_SLENDERNESS


ROW = BucklingRule(
    key="nasa_sp8007",
    rank=30,
    title="NASA SP-8007",
    source="nasa_sp8007",
    locator="axial compression, isotropic cylinder",
    strength=strength,
    limits=((NO_RINGS, with_rings), (OUT_OF_RANGE, too_thin), (SUCTION, under_suction)),
    formula="sigma = gamma E t / (R sqrt(3 (1 - nu^2))), gamma = 1 - 0.901 (1 - exp(-sqrt(R/t) / 16)), at most yield",
    validity="R/t below 1500, no rings, elastic (yielding only as a cap); second-hand transcription",
    colour="#009E73",
    marker="^",
    line="dashdot",
)
