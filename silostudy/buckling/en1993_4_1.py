"""EN 1993-4-1: what the stored solid's pressure does to the wall of a silo, with either edition of EN 1993-1-6.

The pressure first smooths the imperfections (smallest guaranteed pressure), then makes the foot of the wall yield
("elephant's foot", largest pressure); the smaller imperfection factor counts.  Second-hand transcription.
"""

from collections.abc import Callable
from inspect import signature
from types import ModuleType

import numpy as np

from silostudy.buckling import en1993_1_6_2007, en1993_1_6_2025
from silostudy.buckling.family import (
    ELEPHANTS_FOOT,
    BucklingRule,
    Strength,
)
from silostudy.buckling.limits import BELOW_HOOP_YIELD, NO_SUCTION, THIN_SHELLS

FOOT_SHAPE = 400  # s = r / (400 t)


def pressurised_elastic_factor(alpha, relative_pressure):
    """Factor alpha_pe (1): alpha + (1 - alpha) p_s / (p_s + 0.3 / sqrt(alpha)), p_s = p r / (t sigma_Rcr).

    Source: en1993_4_1, second-hand transcription.
    """
    return alpha + (1 - alpha) * relative_pressure / (relative_pressure + 0.3 / np.sqrt(alpha))


def elephants_foot_factor(slenderness, radius_over_thickness, relative_pressure):
    """Elephant's-foot factor alpha_pp (1), s = r / (400 t).

    (1 - (p_g/lambda^2)^2) (1 - 1/(1.12 + s^1.5)) (s^2 + 1.21 lambda^2) / (s (s + 1)).
    Source: en1993_4_1, second-hand transcription.
    """
    s, squared = radius_over_thickness / FOOT_SHAPE, slenderness**2
    hoop = 1 - (relative_pressure / squared) ** 2
    return hoop * (1 - 1 / (1.12 + s**1.5)) * (s**2 + 1.21 * squared) / (s * (s + 1))


def parts(edition: ModuleType) -> Callable[..., dict]:
    """Function that gives the parts of the strength with one edition of EN 1993-1-6."""

    def parts(
        *,
        youngs_modulus,
        yield_stress,
        shell_radius,
        thickness,
        fabrication_quality,
        lower_internal_pressure,
        upper_internal_pressure,
    ):
        critical = en1993_1_6_2007.critical_stress(
            youngs_modulus=youngs_modulus,
            shell_radius=shell_radius,
            thickness=thickness,
        )
        slenderness, hoop = np.sqrt(yield_stress / critical), shell_radius / (thickness * critical)
        lower, upper = lower_internal_pressure * hoop, upper_internal_pressure * hoop
        delta = en1993_1_6_2007.relative_imperfection(shell_radius, thickness, fabrication_quality)
        unpressed = edition.imperfection_factor(delta)
        helped = pressurised_elastic_factor(unpressed, lower)
        foot = elephants_foot_factor(slenderness, shell_radius / thickness, upper)
        alpha = np.minimum(helped, foot)
        return {
            "critical_stress": critical,
            "relative_imperfection": delta,
            "imperfection_factor": unpressed,
            "relative_lower_pressure": lower,
            "relative_upper_pressure": upper,
            "foot_shape": shell_radius / (FOOT_SHAPE * thickness),
            "pressurised_factor": helped,
            "foot_factor": foot,
            "reduced_factor": alpha,
            "slenderness": slenderness,
            "reduction": edition.capacity(slenderness, alpha, delta),
        }

    return parts


def strength(edition: ModuleType) -> Callable[..., Strength]:
    """The rule's function with one edition of EN 1993-1-6."""
    own = parts(edition)

    def pressurised(**given):
        own_parts = own(**given)
        strength = en1993_1_6_2007.buckles(
            own_parts["critical_stress"], own_parts["reduced_factor"], own_parts["reduction"], given["yield_stress"]
        )
        mode = np.where(own_parts["foot_factor"] < own_parts["pressurised_factor"], ELEPHANTS_FOOT, strength.mode)
        return Strength(strength.elastic_local, strength.elastic_general, strength.elastic, strength.strength, mode)

    pressurised.__doc__ = f"Strength (Pa) with internal pressure. Source: en1993_4_1 on {edition.ROW.title}, second-hand."
    pressurised.__signature__ = signature(own)  # type: ignore[attr-defined]
    return pressurised


def behind(edition: ModuleType) -> Callable[..., dict]:
    """Function that gives the numbers of BEHIND with one edition of EN 1993-1-6."""
    own = parts(edition)

    def numbers(**given):
        shell = own(**given)
        return en1993_1_6_2007.with_range(shell, shell["reduced_factor"], edition.capacity_range)

    numbers.__signature__ = signature(own)  # type: ignore[attr-defined]
    return numbers


def _row(edition: ModuleType, year: str, title: str, mixed: str = "", **looks) -> BucklingRule:
    return BucklingRule(
        key=f"en1993_4_1_{year}",
        rank=60,
        title=title,
        source="en1993_4_1",
        locator="axial compression with internal pressure",
        strength=strength(edition),
        behind=behind(edition),
        limits=(THIN_SHELLS, NO_SUCTION, BELOW_HOOP_YIELD),
        formula=f"EN 1993-1-6:{year} with C_x = 1 and the smaller of "
        "alpha_pe = alpha + (1 - alpha) p_s / (p_s + 0.3 / sqrt(alpha)) and "
        "alpha_pp = (1 - (p_g/lambda^2)^2) (1 - 1/(1.12 + s^1.5)) (s^2 + 1.21 lambda^2) / (s (s + 1)), s = r / (400 t), in "
        "place of alpha; p = p r / (t sigma_Rcr), smallest guaranteed in p_s, largest in p_g",
        validity=f"{mixed}second-hand transcription, printed standard not seen; no factor for the length (one public program "
        "and memory), so rings change nothing; psi = 1, the stress is taken as even round the wall; the elephant's foot is "
        "taken to threaten every depth, not only the foot",
        pressurised=True,
        **looks,
    )


ROWS = (
    _row(en1993_1_6_2007, "2007", "EN 1993-4-1 on 1-6:2007", colour="#56B4E9", marker="P", line="dashed"),
    _row(
        en1993_1_6_2025,
        "2025",
        "EN 1993-4-1 on 1-6:2025 (a mix)",
        "a mix of editions: no source joins these pressure factors to the strengths of 2025, shown for comparison; ",
        excludes=en1993_1_6_2025.ROW.excludes,
        colour="#CC79A7",
        marker="X",
        line="solid",
    ),
)
