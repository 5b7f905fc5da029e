"""Classical theory: a perfect, elastic cylinder of medium length.  No shell reaches it; the others are measured against it."""

import numpy as np

from silostudy.buckling.family import (
    LOCAL_ELASTIC,
    YIELDING,
    BucklingRule,
    Strength,
    classical_stress,
)
from silostudy.buckling.limits import NO_SUCTION, NOT_THICK, WITHOUT_RINGS


def capped_at_yield(elastic, yield_stress) -> Strength:
    """The elastic stress (Pa), at most the yield stress: for rules that do not speak of yielding."""
    mode = np.where(elastic < yield_stress, LOCAL_ELASTIC, YIELDING)
    return Strength(elastic, np.nan, elastic, np.minimum(elastic, yield_stress), mode)


def strength(*, youngs_modulus, shell_poisson_ratio, yield_stress, shell_radius, thickness):
    """Strength (Pa): the classical stress, at most the yield stress. Source: classical_buckling, textbook result."""
    elastic = classical_stress(
        youngs_modulus=youngs_modulus,
        shell_poisson_ratio=shell_poisson_ratio,
        shell_radius=shell_radius,
        thickness=thickness,
    )
    return capped_at_yield(elastic, yield_stress)


ROW = BucklingRule(
    key="classical",
    rank=20,
    title="classical, perfect shell",
    source="classical_buckling",
    locator="textbook result",
    strength=strength,
    limits=(WITHOUT_RINGS, NOT_THICK, NO_SUCTION),
    formula="sigma_cl = E t / (R sqrt(3 (1 - nu^2))), at most the yield stress",
    validity="perfect elastic cylinder, whatever its length; no measure of a real shell's strength",
    colour="#999999",
    marker="_",
    line="dotted",
)
