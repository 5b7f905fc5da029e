"""Membrane yield: axial compression beside hoop tension yields the wall sooner than either alone."""

import numpy as np

from silostudy.checks.family import SteelCheck
from silostudy.checks.hoop_tension import hoop_stress


def equivalent_stress(axial, hoop, shear=0.0):
    """Equivalent stress (Pa), axial compression and hoop tension positive: sqrt(s_x^2 + s_h^2 + s_x s_h + 3 tau^2).

    Source: en1993_4_1, membrane strength, two programs: the sign is minus with tension positive in both.
    """
    return np.sqrt(axial**2 + hoop**2 + axial * hoop + 3 * shear**2)


def acting(*, axial_wall_force, wall_above, shear_wall_force, upper_internal_pressure, inner_radius, thickness):
    """Equivalent membrane stress (Pa). Source: en1993_4_1, membrane strength, two programs."""
    hoop = hoop_stress(upper_internal_pressure=upper_internal_pressure, inner_radius=inner_radius, thickness=thickness)
    return equivalent_stress(axial_wall_force / thickness + wall_above, hoop, shear_wall_force / thickness)


def strength(*, yield_stress, partial_yield):
    """Stress (Pa) at which the plate yields: f_y / gamma_M0. Source: en1993_4_1, membrane strength, two programs."""
    return yield_stress / partial_yield


def needed(
    *, axial_wall_force, wall_above, shear_wall_force, upper_internal_pressure, inner_radius, yield_stress, partial_yield
):
    """Thickness (m) at which the equivalent stress meets the yield stress. Source: en1993_4_1, membrane strength, two programs.

    With u = 1/t both stresses are straight in u, and the square of the equivalent one is a u^2 + b u + c; infinite where
    the wall above yields it at any thickness.
    """
    n, w, most = axial_wall_force, wall_above, strength(yield_stress=yield_stress, partial_yield=partial_yield)
    m, h = upper_internal_pressure * inner_radius, upper_internal_pressure / 2
    a = n**2 + m**2 + n * m + 3 * shear_wall_force**2
    b, c = 2 * n * w + 2 * m * h + n * h + m * w, w**2 + h**2 + w * h - most**2
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(b**2 - 4 * a * c)
        return np.where(c >= 0, np.inf, (b + root) / (-2 * c))


ROW = SteelCheck(
    key="membrane_yield",
    rank=0,
    title="membrane yield",
    source="en1993_4_1",
    locator="membrane strength of the cylinder, second-hand",
    effect=acting,
    resistance=strength,
    needed=needed,
    formula="sqrt(n_x^2 + n_h^2 + n_x n_h + 3 n_xh^2) <= t f_y / gamma_M0, n_x the axial compression, n_h = p r, p the largest "
    "pressure, all times their factors, gamma_M0 = 1",
    validity="membrane forces alone: no joints, no bending at edges and rings; shear in the stage of the checks only; the "
    "largest force of any phase beside the largest pressure of any phase, which is safe; two public programs, printed standard "
    "not seen",
)
