"""Miller (1977): axially compressed steel cylinders with and without rings, from tests.

Local buckling between the rings and general buckling with them, each elastic stress reduced by yielding; the smaller
counts.  The logarithm is to base 10.  Manufactured shells follow formulas that fall below zero at R/t = 2329: beyond it
the rule does not speak.  Fabricated ones have a floor, C = 0.125 and J = 0.50, which is also the safe choice at any R/t.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from silostudy.buckling.family import (
    GENERAL_ELASTIC,
    GENERAL_INELASTIC,
    LOCAL_ELASTIC,
    LOCAL_INELASTIC,
    OUT_OF_RANGE,
    SMALL_RINGS,
    YIELDING,
    BucklingRule,
    ShellLimit,
    Strength,
)
from silostudy.buckling.limits import LEAST_RING_RATIO, NO_SUCTION, NOT_THICK, between_supports
from silostudy.limits import Measure


def long_coefficient(radius_over_thickness, fabricated, safe_constants, logarithm=np.log10):
    """Coefficient C (1), sigma R / (E t) of a long unstiffened shell. Source: miller1977, eqs. (4), (5)."""
    term = 0.286 * logarithm(radius_over_thickness)
    floor = np.where(safe_constants, 0.125, np.maximum(0.125, 0.919 - term))
    return np.where(fabricated, floor, np.minimum(0.34, 0.963 - term))


def short_coefficient(radius_over_thickness, fabricated, safe_constants, logarithm=np.log10):
    """Coefficient J (1) of the short shell's C = J M^-0.6. Source: miller1977, eqs. (6), (7)."""
    term = 0.5 * logarithm(radius_over_thickness)
    floor = np.where(safe_constants, 0.50, np.maximum(0.50, 1.88 - term))
    return np.where(fabricated, floor, np.maximum(0.76, 2.29 - term))


def local_coefficient(relative_length, long, short, junction_exponent=5 / 3):
    """Coefficient C (1) of a shell of relative length M = L / sqrt(R t): long from M = (J/C)^(5/3) on, else J M^-0.6.

    Source: miller1977, text after eq. (7), its printed exponent 3/5 mended.
    """
    junction = (short / long) ** junction_exponent
    return np.where(relative_length >= junction, long, short * relative_length**-0.6)


def ring_coefficient(ring_area_ratio, long):
    """Coefficient C_3 (1) of general buckling: the unstiffened C, up to 0.4 at A_r / (L t) = 0.2.

    Source: miller1977, (11), (12).
    """
    return np.where(ring_area_ratio < 0.2, (2 - 5 * long) * ring_area_ratio + long, 0.4)


def effective_thickness(thickness, ring_area_ratio):
    """Effective thickness t_e (m): t sqrt(1 + A_r / (L t)). Source: miller1977, eq. (9)."""
    return thickness * np.sqrt(1 + ring_area_ratio)


def inelastic_ratio(elastic_ratio, full_yield_from=6.2):
    """Strength over yield stress (1) from elastic stress over yield stress. Source: miller1977, eqs. (15a) to (15d)."""
    x = elastic_ratio
    branches = [x, 0.45 + 0.18 * x, 1.31 / (1.15 + 1 / x)]
    return np.select([x <= 0.55, x <= 1.6, x < full_yield_from], branches, 1.0)


@dataclass(frozen=True)
class Reading:
    """Reading of the source.  The defaults are what its own tests settle; miller1977_rivals holds the others."""

    logarithm: Callable = np.log10
    junction_exponent: float = 5 / 3
    inelastic: Callable = inelastic_ratio
    ring_coefficient_from_bay: bool = False
    radius_factor: float = 1.0  # on the radius, with R/t so changed and M kept


def strength(reading: Reading) -> Callable[..., Strength]:
    """The rule's function in one reading of the source."""

    def read(
        *,
        youngs_modulus,
        yield_stress,
        shell_radius,
        thickness,
        bay_length,
        total_length,
        ring_area,
        fabricated,
        safe_constants,
    ):
        slender = shell_radius * reading.radius_factor / thickness
        counts = rings_count(ring_area=ring_area, bay_length=bay_length, thickness=thickness)
        free = between_supports(bay_length=bay_length, total_length=total_length, ring_area=ring_area, counts=counts)
        length = free / np.sqrt(shell_radius * thickness)
        long = long_coefficient(slender, fabricated, safe_constants, reading.logarithm)
        short = short_coefficient(slender, fabricated, safe_constants, reading.logarithm)
        bay = local_coefficient(length, long, short, reading.junction_exponent)
        ratio = np.where(counts, ring_area / (bay_length * np.sqrt(reading.radius_factor) * thickness), 0.0)
        local = bay * youngs_modulus / slender
        ring = ring_coefficient(ratio, bay if reading.ring_coefficient_from_bay else long)
        general = np.where(ratio > 0, ring * youngs_modulus * effective_thickness(1.0, ratio) / slender, np.nan)
        return _smaller(local, general, yield_stress, reading.inelastic, free)

    read.__doc__ = "Strength (Pa) as the source's section 4.5.4 is read."
    return read


def _smaller(local, general, yield_stress, inelastic, length) -> Strength:
    """The smaller of the local and the general strength, each reduced by yielding."""
    smaller = np.fmin(local, general)
    reduced = inelastic(smaller / yield_stress)
    is_local = ~(general < local)
    elastic = smaller / yield_stress <= 0.55
    mode = np.select(
        [reduced >= 1, is_local & elastic, is_local, elastic],
        [YIELDING, LOCAL_ELASTIC, LOCAL_INELASTIC, GENERAL_ELASTIC],
        GENERAL_INELASTIC,
    )
    return Strength(local, general, smaller, reduced * yield_stress, mode, length)


def rings_count(*, ring_area, bay_length, thickness):
    """True where rings are large enough to count: A_r / (L t) of 0.06 or more. Source: miller1977, text after eq. (12)."""
    return ring_area / (bay_length * thickness) >= LEAST_RING_RATIO * (1 - 1e-9)  # 0.06 itself counts


def _small_ring_ratio(*, ring_area, bay_length, thickness, total_length):
    """Ratio A_r / (L t) (1); NaN without rings, and where the whole length is known and small rings are left out."""
    asked = (np.asarray(ring_area) > 0) & np.isnan(total_length)
    return np.where(asked, ring_area / (bay_length * thickness), np.nan)


RINGS_THAT_COUNT = ShellLimit(
    measure=Measure("A_r/(L t), whole length unknown", "1", _small_ring_ratio),
    least=LEAST_RING_RATIO,
    tolerance=1e-9,
    why="smaller rings do not count",
    reason=SMALL_RINGS,
)


def with_strength(reading: Reading) -> ShellLimit:
    """The limit of a reading: where its C is no longer positive."""

    def coefficient(*, thickness, shell_radius, fabricated, safe_constants):
        slender = shell_radius * reading.radius_factor / thickness
        return long_coefficient(slender, fabricated, safe_constants, reading.logarithm)

    measure = Measure("C of a long shell", "1", coefficient)
    return ShellLimit(measure=measure, above=0.0, why="manufactured shells: R/t up to 2329", reason=OUT_OF_RANGE)


def rule(reading: Reading, **looks) -> BucklingRule:
    """A catalogue row for one reading of the source."""
    return BucklingRule(
        source="miller1977",
        strength=strength(reading),
        limits=(with_strength(reading), NOT_THICK, RINGS_THAT_COUNT, NO_SUCTION),
        **looks,
    )


FORMULA = (
    "local sigma_ec = C E t / R, C = min(0.34, 0.963 - 0.286 log R/t) manufactured, max(0.125, 0.919 - 0.286 log R/t) "
    "fabricated, for M = L / sqrt(R t) >= (J/C)^(5/3), else C = J M^-0.6, J = max(0.76, 2.29 - 0.5 log R/t) or "
    "max(0.50, 1.88 - 0.5 log R/t); general sigma_ec = C_3 E t_e / R, t_e = t sqrt(1 + A_r/(L t)), "
    "C_3 = min(0.4, (2 - 5 C) A_r/(L t) + C); sigma_cr / sigma_y = x to x = sigma_ec / sigma_y = 0.55, "
    "0.45 + 0.18 x to 1.6, 1.31 / (1.15 + 1/x) to 6.2, then 1"
)
ROW = rule(
    Reading(),
    key="miller1977",
    rank=10,
    title="Miller (1977)",
    locator="eqs. (1) to (15)",
    formula=FORMULA,
    validity="from tests of R/t 242 to 504 (manufactured); where the whole length is known, rings that do not count are left "
    "out and the bay is the whole length; internal pressure is left out",
    colour="#882255",
    marker="o",
    line="-",
)
