"""Shear buckling of the wall by a transverse force: wind, earthquake, patch load."""

from collections.abc import Callable

import numpy as np

from silostudy.checks.capacity import IMPERFECTION, KNOWN_CLASSES, capacity
from silostudy.checks.family import SteelCheck
from silostudy.limits import Limit

LONG = 8.7  # omega over r / t beyond which a cylinder is long


def length_factor(relative_length, radius_over_thickness):
    """Length factor C_tau (1): 1, of a long cylinder sqrt(omega t/r)/3.

    Source: en1993_1_6_2007, annex D, two public programs.
    """
    long = relative_length > LONG * radius_over_thickness
    return np.where(long, np.sqrt(relative_length / radius_over_thickness) / 3, 1.0)


def critical_stress(*, youngs_modulus, inner_radius, thickness, wall_height):
    """Shear stress (Pa) at which a perfect cylinder buckles: 0.75 E C_tau sqrt(1/omega) t/r, omega = l/sqrt(r t).

    Source: en1993_1_6_2007, annex D, two public programs: C_tau 1, beyond omega = 8.7 r/t sqrt(omega t/r)/3.
    """
    r = inner_radius + thickness / 2
    relative_length = wall_height / np.sqrt(r * thickness)
    return 0.75 * youngs_modulus * length_factor(relative_length, r / thickness) * np.sqrt(1 / relative_length) * thickness / r


def stress(*, shear_wall_force, thickness):
    """Largest shear stress (Pa) round the wall: V / (pi r t). Source: en1993_1_6_2007."""
    return shear_wall_force / thickness


def alpha_2007(relative_imperfection):
    """Imperfection factor alpha_tau (1) of class B: 0.65. Source: en1993_1_6_2007, two public programs."""
    return IMPERFECTION


def alpha_2025(relative_imperfection):
    """Imperfection factor alpha_tau (1): 0.96 / (1 + 0.5 delta), delta = sqrt(r/t)/Q. Source: en1993_1_6_2025, one program."""
    return 0.96 / (1 + 0.5 * relative_imperfection)


def reduction(alpha: Callable) -> Callable:
    """Function that gives chi_tau by an edition's imperfection factor."""

    def chi(*, yield_stress, youngs_modulus, inner_radius, thickness, wall_height, fabrication_quality):
        """Reduction chi_tau (1), of lambda = sqrt(f_y / (sqrt(3) tau_cr)). Source: en1993_1_6_2007, section 8.5."""
        wall = {"inner_radius": inner_radius, "thickness": thickness}
        critical = critical_stress(youngs_modulus=youngs_modulus, wall_height=wall_height, **wall)
        delta = np.sqrt(inner_radius / thickness + 0.5) / fabrication_quality
        return capacity(np.sqrt(yield_stress / np.sqrt(3) / critical), alpha(delta))

    return chi


def strength(alpha: Callable) -> Callable:
    """Shear strength by an edition's imperfection factor."""

    def strength(*, yield_stress, youngs_modulus, inner_radius, thickness, wall_height, fabrication_quality, partial_buckling):
        """Shear stress (Pa) at which the wall buckles: chi_tau f_y/(sqrt(3) gamma_M1). Source: en1993_1_6_2007."""
        wall = {"inner_radius": inner_radius, "thickness": thickness, "wall_height": wall_height}
        chi = reduction(alpha)(
            yield_stress=yield_stress, youngs_modulus=youngs_modulus, fabrication_quality=fabrication_quality, **wall
        )
        return chi * yield_stress / np.sqrt(3) / partial_buckling

    return strength


def behind(alpha: Callable) -> Callable:
    """The numbers behind the check by an edition's imperfection factor."""
    chi = reduction(alpha)

    def numbers(*, yield_stress, youngs_modulus, inner_radius, thickness, wall_height, fabrication_quality):
        """Numbers omega, C_tau, tau_cr (Pa), delta, alpha, lambda, chi. Source: en1993_1_6_2007, as above."""
        wall = {"inner_radius": inner_radius, "thickness": thickness, "wall_height": wall_height}
        r = inner_radius + thickness / 2
        critical = critical_stress(youngs_modulus=youngs_modulus, **wall)
        relative, delta = wall_height / np.sqrt(r * thickness), np.sqrt(r / thickness) / fabrication_quality
        return {
            "relative_length": relative,
            "length_factor": length_factor(relative, r / thickness),
            "critical_stress": critical,
            "relative_imperfection": delta,
            "imperfection_factor": alpha(delta),
            "slenderness": np.sqrt(yield_stress / np.sqrt(3) / critical),
            "reduction": chi(
                yield_stress=yield_stress, youngs_modulus=youngs_modulus, fabrication_quality=fabrication_quality, **wall
            ),
        }

    return numbers


def _row(edition: str, alpha: Callable, limits: tuple[Limit, ...], formula: str, sources: str, single: bool) -> SteelCheck:
    return SteelCheck(
        key=f"shear_buckling_{edition}",
        rank=2,
        title=f"shear buckling, {edition}",
        source=f"en1993_1_6_{edition}",
        locator="annex D, shear, second-hand",
        effect=stress,
        resistance=strength(alpha),
        behind=behind(alpha),
        limits=limits,
        formula=f"V/(pi r t) <= chi f_y/(sqrt(3) gamma_M1), tau_cr = 0.75 E C_tau sqrt(1/omega) t/r, omega = l/sqrt(r t), "
        f"{formula}, lambda_0 0.4, beta 0.6, eta 1",
        validity="l the whole height with the thickness of each course in turn; the gain of short walls (omega < 10), on which "
        f"the editions disagree, is left out, which is safe; {sources}, printed standard not seen",
        one_source=single,
    )


ROWS = (
    _row("2007", alpha_2007, (KNOWN_CLASSES,), "alpha 0.65", "two public programs", False),
    _row("2025", alpha_2025, (), "alpha = 0.96/(1 + 0.5 delta), delta = sqrt(r/t)/Q", "alpha of one public program", True),
)
