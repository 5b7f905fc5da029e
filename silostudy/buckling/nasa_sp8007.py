"""NASA SP-8007: a lower bound to tests of cylinders without rings (second-hand transcription)."""

import numpy as np

from silostudy.buckling.classical import capped_at_yield
from silostudy.buckling.family import (
    OUT_OF_RANGE,
    BucklingRule,
    ShellLimit,
    classical_stress,
)
from silostudy.buckling.limits import NO_SUCTION, NOT_THICK, SLENDERNESS, WITHOUT_RINGS

GREATEST_SLENDERNESS = 1500  # R/t up to which the source's tests go


def correlation_factor(radius_over_thickness):
    """Correlation factor gamma (1): 1 - 0.901 (1 - exp(-sqrt(R/t) / 16)). Source: nasa_sp8007, second-hand transcription."""
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


NOT_TOO_THIN = ShellLimit(measure=SLENDERNESS, below=GREATEST_SLENDERNESS, why="range of the tests", reason=OUT_OF_RANGE)
ROW = BucklingRule(
    key="nasa_sp8007",
    rank=30,
    title="NASA SP-8007",
    source="nasa_sp8007",
    locator="axial compression, isotropic cylinder",
    strength=strength,
    limits=(WITHOUT_RINGS, NOT_TOO_THIN, NOT_THICK, NO_SUCTION),
    formula="sigma = gamma E t / (R sqrt(3 (1 - nu^2))), gamma = 1 - 0.901 (1 - exp(-sqrt(R/t) / 16)), at most yield",
    validity="elastic (yielding only as a cap); second-hand transcription",
    colour="#009E73",
    marker="^",
    line="dashdot",
)
