"""The capacity curve of EN 1993-1-6:2007 for hoop compression and shear, which share its numbers."""

import numpy as np

from silostudy.limits import Limit, Measure

SQUASH_LIMIT = 0.4  # lambda_0
PLASTIC_RANGE = 0.6  # beta; the interaction exponent eta is 1
IMPERFECTION = 0.65  # alpha of class B: two public programs; 0.75 for A and 0.50 for C are remembered only
KNOWN_CLASSES = Limit(
    measure=Measure("Q", "1", lambda *, fabrication_quality: fabrication_quality),
    least=25.0,
    why="alpha 0.65 of class B, taken for A too, which is safe; that of class C is remembered only",
)


def capacity(slenderness, alpha=IMPERFECTION):
    """Strength over yield stress, chi (1), from lambda. Source: en1993_1_6_2007, section 8.5, two public programs.

    1 up to lambda_0 = 0.4, alpha / lambda^2 from lambda_p = sqrt(alpha / 0.4), straight between.
    """
    plastic_limit = np.sqrt(alpha / (1 - PLASTIC_RANGE))
    between = 1 - PLASTIC_RANGE * (slenderness - SQUASH_LIMIT) / (plastic_limit - SQUASH_LIMIT)
    with np.errstate(divide="ignore"):
        inelastic = np.where(slenderness <= SQUASH_LIMIT, 1.0, between)
        return np.where(slenderness >= plastic_limit, alpha / slenderness**2, inelastic)
