"""EN 1993-1-6:2025: no factor for long shells, another imperfection factor and a curved capacity with strain hardening.

Second-hand transcription; the printed standard was not seen.
"""

import numpy as np

from silostudy.buckling.en1993_1_6_2007 import (
    RINGS_FORMULA,
    RINGS_TOLD,
    SHORT,
    behind_by,
    held_length,
    parts_by,
    short_factor,
    strength_by,
)
from silostudy.buckling.family import LONG, BucklingRule, ShellLimit
from silostudy.buckling.limits import NO_SUCTION, RINGS_THAT_COUNT, THIN_SHELLS
from silostudy.limits import Measure

SQUASH_LIMIT = 0.10  # lambda_0
HARDENING_LIMIT = 1.10  # chi_h


def length_factor(relative_length, radius_over_thickness, end_factor):
    """Length factor C_x (1): short as in 2007, 1 beyond omega = 1.7.

    Source: en1993_1_6_2025, second-hand (one public program).
    """
    return np.where(relative_length <= SHORT, short_factor(relative_length), 1.0)


def _relative_length(*, bay_length, total_length, ring_area, shell_radius, thickness):
    """Relative length omega t / r (1) between held edges."""
    wall = {"shell_radius": shell_radius, "thickness": thickness}
    length = held_length(bay_length=bay_length, total_length=total_length, ring_area=ring_area, **wall)
    return length / np.sqrt(shell_radius * thickness) * thickness / shell_radius


NOT_LONG = ShellLimit(
    measure=Measure("omega t/r", "1", _relative_length),
    most=1.43,
    why="factor of longer shells not known for this edition; the range by one public program",
    reason=LONG,
)


def imperfection_factor(delta):
    """Imperfection factor alpha (1): 0.83 / (1 + 2.2 delta^0.75). Source: en1993_1_6_2025, second-hand transcription."""
    return 0.83 / (1 + 2.2 * delta**0.75)


def plastic_range(delta):
    """Plastic range beta (1): 1 - 0.75 / (1 + 1.1 delta). Source: en1993_1_6_2025, second-hand transcription."""
    return 1 - 0.75 / (1 + 1.1 * delta)


def interaction_exponent(share, delta):
    """Exponent eta (1) at a share of the way from lambda_0 to lambda_p, straight from eta_0 to eta_p.

    Source: en1993_1_6_2025, second-hand transcription: eta_0 = 1.35 - 0.10 delta, eta_p = 1 / (0.45 + 0.72 delta).
    """
    start, stop = 1.35 - 0.10 * delta, 1 / (0.45 + 0.72 * delta)
    return start + (stop - start) * share


def capacity_range(slenderness, alpha, delta):
    """Parameters beta, lambda_p, eta (1) of the capacity curve. Source: en1993_1_6_2025, second-hand."""
    beta = plastic_range(delta)
    plastic_limit = np.sqrt(alpha / (1 - beta))
    share = np.clip((slenderness - SQUASH_LIMIT) / (plastic_limit - SQUASH_LIMIT), 0, 1)
    return beta, plastic_limit, interaction_exponent(share, delta)


def capacity(slenderness, alpha, delta):
    """Strength over yield stress, chi (1); up to 1.10 for stocky shells. Source: en1993_1_6_2025, second-hand."""
    beta, plastic_limit, eta = capacity_range(slenderness, alpha, delta)
    between = 1 - beta * np.clip((slenderness - SQUASH_LIMIT) / (plastic_limit - SQUASH_LIMIT), 0, 1) ** eta
    hardened = HARDENING_LIMIT - slenderness / SQUASH_LIMIT * (HARDENING_LIMIT - 1)
    inelastic = np.where(slenderness <= SQUASH_LIMIT, hardened, between)
    return np.where(slenderness >= plastic_limit, alpha / slenderness**2, inelastic)


PARTS = parts_by(length_factor, imperfection_factor, capacity)
ROW = BucklingRule(
    key="en1993_1_6_2025",
    rank=50,
    title="EN 1993-1-6:2025",
    source="en1993_1_6_2025",
    locator="axial compression",
    strength=strength_by(PARTS),
    behind=behind_by(PARTS, capacity_range),
    limits=(THIN_SHELLS, RINGS_THAT_COUNT, NOT_LONG, NO_SUCTION),
    formula=f"{RINGS_FORMULA}sigma_Rcr and delta as in 2007, C_x = 1 beyond omega = 1.7; "
    "alpha = 0.83 / (1 + 2.2 delta^0.75), beta = 1 - 0.75 / (1 + 1.1 delta); "
    "chi = 1.1 - lambda to 0.1, 1 - beta ((lambda - 0.1) / (lambda_p - 0.1))^eta to lambda_p = sqrt(alpha / (1 - beta)), "
    "then alpha / lambda^2; eta straight from 1.35 - 0.10 delta to 1 / (0.45 + 0.72 delta)",
    validity=f"second-hand transcription, printed standard not seen; {RINGS_TOLD}",
    excludes="seismic and dynamic loading (its published scope, one source)",
    colour="#D55E00",
    marker="D",
    line="solid",
)
