"""EN 1993-1-6:2007: elastic critical stress, imperfection factor and capacity curve under axial compression.

Second-hand transcription, checked against two open programs; the printed standard was not seen.
"""

from inspect import signature

import numpy as np

from silostudy.buckling.family import (
    LOCAL_ELASTIC,
    LOCAL_INELASTIC,
    YIELDING,
    BucklingRule,
    Strength,
)
from silostudy.buckling.limits import NO_SUCTION, RINGS_THAT_COUNT, THIN_SHELLS, between_supports, ring_share

SHORT = 1.7  # omega up to which a shell is short
SQUASH_LIMIT = 0.2  # lambda_0
PLASTIC_RANGE = 0.6  # beta; the interaction exponent eta is 1


def short_factor(relative_length):
    """Length factor C_x (1) of a short shell, omega = l / sqrt(r t) up to 1.7: 1.36 - 1.83/omega + 2.07/omega^2.

    Both edges must be held radially and against turning. Source: en1993_1_6_2007.
    """
    return 1.36 - 1.83 / relative_length + 2.07 / relative_length**2


def length_factor(relative_length, radius_over_thickness, end_factor):
    """Length factor C_x (1) from omega = l / sqrt(r t): short, medium or long.

    Source: en1993_1_6_2007, annex D, second-hand.
    """
    long = np.maximum(0.6, 1 + 0.2 / end_factor * (1 - 2 * relative_length / radius_over_thickness))
    medium_or_long = np.where(relative_length <= 0.5 * radius_over_thickness, 1.0, long)
    return np.where(relative_length <= SHORT, short_factor(relative_length), medium_or_long)


def critical_stress(*, youngs_modulus, shell_radius, thickness, factor=1.0):
    """Elastic critical stress sigma_Rcr (Pa) of the perfect shell: 0.605 E C_x t / r. Source: en1993_1_6_2007, annex D."""
    return 0.605 * youngs_modulus * factor * thickness / shell_radius


def held_length(*, bay_length, total_length, ring_area, shell_radius, thickness):
    """Length (m) between edges held radially: a ring ends a bay only where it is large enough (buckling/limits)."""
    share = ring_share(ring_area=ring_area, bay_length=bay_length, shell_radius=shell_radius, thickness=thickness)
    counts = share >= 1 - RINGS_THAT_COUNT.tolerance
    return between_supports(bay_length=bay_length, total_length=total_length, ring_area=ring_area, counts=counts)


def relative_imperfection(shell_radius, thickness, fabrication_quality):
    """Characteristic imperfection over thickness, delta (1): sqrt(r/t) / Q. Source: en1993_1_6_2007, annex D."""
    return np.sqrt(shell_radius / thickness) / fabrication_quality


def imperfection_factor(delta):
    """Imperfection factor alpha (1): 0.62 / (1 + 1.91 delta^1.44). Source: en1993_1_6_2007, annex D, second-hand."""
    return 0.62 / (1 + 1.91 * delta**1.44)


def capacity(slenderness, alpha, delta):
    """Strength over yield stress, chi (1), from lambda = sqrt(f_y / sigma_Rcr). Source: en1993_1_6_2007, section 8.5.

    Between lambda_0 and lambda_p = sqrt(alpha / (1 - beta)) straight in lambda; delta plays no part in this edition.
    """
    plastic_limit = np.sqrt(alpha / (1 - PLASTIC_RANGE))
    between = 1 - PLASTIC_RANGE * (slenderness - SQUASH_LIMIT) / (plastic_limit - SQUASH_LIMIT)
    inelastic = np.where(slenderness <= SQUASH_LIMIT, 1.0, between)
    return np.where(slenderness >= plastic_limit, alpha / slenderness**2, inelastic)


def capacity_range(slenderness, alpha, delta):
    """Parameters beta, lambda_p, eta (1) of the capacity curve; eta 1. Source: en1993_1_6_2007, section 8.5."""
    return PLASTIC_RANGE, np.sqrt(alpha / (1 - PLASTIC_RANGE)), 1.0


def with_range(shell, alpha, capacity_range):
    """Numbers of BEHIND with those of the capacity curve for an imperfection factor alpha."""
    numbers = capacity_range(shell["slenderness"], alpha, shell["relative_imperfection"])
    return {**shell, **dict(zip(("plastic_range", "plastic_limit", "interaction_exponent"), numbers, strict=True))}


def buckles(critical, alpha, chi, yield_stress, length=np.nan, factor=np.nan) -> Strength:
    """Strength (Pa) from the capacity chi; elastic where chi lambda^2 reaches alpha, yielding where chi reaches 1."""
    elastic = alpha * critical
    mode = np.where(chi >= 1, YIELDING, np.where(chi * yield_stress >= elastic * (1 - 1e-12), LOCAL_ELASTIC, LOCAL_INELASTIC))
    return Strength(elastic, np.nan, elastic, chi * yield_stress, mode, length, factor)


def parts_by(length_factor, imperfection_factor, capacity):
    """Function that gives the parts of the strength by an edition's length factor, imperfection factor and capacity curve."""

    def parts(
        *,
        youngs_modulus,
        yield_stress,
        shell_radius,
        thickness,
        bay_length,
        total_length,
        ring_area,
        fabrication_quality,
        end_factor,
    ):
        """The parts of the strength (Pa) without pressure. Source: en1993_1_6_2007, annex D and section 8.5, second-hand."""
        wall = {"shell_radius": shell_radius, "thickness": thickness}
        length = held_length(bay_length=bay_length, total_length=total_length, ring_area=ring_area, **wall)
        relative = length / np.sqrt(shell_radius * thickness)
        factor = length_factor(relative, shell_radius / thickness, end_factor)
        factor = np.where(np.asarray(ring_area) > 0, np.minimum(factor, 1.0), factor)  # a ring does not stop the wall turning
        critical = critical_stress(youngs_modulus=youngs_modulus, factor=factor, **wall)
        delta = relative_imperfection(shell_radius, thickness, fabrication_quality)
        alpha = imperfection_factor(delta)
        slenderness = np.sqrt(yield_stress / critical)
        return {
            "supported_length": length,
            "relative_length": relative,
            "length_factor": factor,
            "critical_stress": critical,
            "relative_imperfection": delta,
            "imperfection_factor": alpha,
            "slenderness": slenderness,
            "reduction": capacity(slenderness, alpha, delta),
        }

    return parts


def strength_by(parts):
    """Function that gives the strength (Pa) by its parts."""

    def strength(**given):
        """Strength (Pa) without internal pressure. Source: en1993_1_6_2007, annex D and section 8.5, second-hand."""
        shell, yield_stress = parts(**given), given["yield_stress"]
        return buckles(
            shell["critical_stress"], shell["imperfection_factor"], shell["reduction"], yield_stress,
            shell["supported_length"], shell["length_factor"],
        )  # fmt: skip

    strength.__signature__ = signature(parts)  # type: ignore[attr-defined]
    return strength


def behind_by(parts, capacity_range):
    """Function that gives the numbers behind a strength by its parts and an edition's capacity curve."""

    def behind(**given):
        """The numbers of BEHIND, stresses (Pa). Source: en1993_1_6_2007, annex D and section 8.5, second-hand."""
        shell = parts(**given)
        return with_range(shell, shell["imperfection_factor"], capacity_range)

    behind.__signature__ = signature(parts)  # type: ignore[attr-defined]
    return behind


PARTS = parts_by(length_factor, imperfection_factor, capacity)
RINGS_FORMULA = "a ring ends a bay where A_r >= (0.06 + 2/Z^2) l t, Z = l^2 sqrt(1 - nu^2)/(r t), and then C_x <= 1; "
RINGS_TOLD = (
    "of what makes a ring count two sources back the 0.06, one the 2/Z^2; rings do not stop the wall turning, so they give no "
    "C_x of a short shell; smaller ones are left out and the length is the whole one; buckling together with rings is not "
    "covered; internal pressure is left out"
)
ROW = BucklingRule(
    key="en1993_1_6_2007",
    rank=40,
    title="EN 1993-1-6:2007",
    source="en1993_1_6_2007",
    locator="annex D and section 8.5, axial compression",
    strength=strength_by(PARTS),
    behind=behind_by(PARTS, capacity_range),
    limits=(THIN_SHELLS, RINGS_THAT_COUNT, NO_SUCTION),
    formula=f"{RINGS_FORMULA}sigma_Rcr = 0.605 E C_x t / r; C_x from omega = l / sqrt(r t): 1.36 - 1.83/omega + 2.07/omega^2 "
    "to 1.7, 1 to 0.5 r/t, then max(0.6, 1 + 0.2/C_xb (1 - 2 omega t/r)); "
    "alpha = 0.62 / (1 + 1.91 delta^1.44), delta = sqrt(r/t) / Q; "
    "lambda = sqrt(f_y / sigma_Rcr); chi = 1 to 0.2, straight to lambda_p = sqrt(alpha / 0.4), then alpha / lambda^2",
    validity=f"second-hand transcription, checked against two open programs, printed standard not seen; {RINGS_TOLD}",
    colour="#0072B2",
    marker="s",
    line="dashed",
)
