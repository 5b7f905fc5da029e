"""Rival readings of Miller's section: the misprints taken at their word, so that a reader sees which reading the tests want."""

import numpy as np

from silostudy.buckling import miller1977
from silostudy.buckling.miller1977 import FORMULA, Reading, inelastic_ratio, rule


def inelastic_ratio_14b(elastic_ratio):
    """Strength over yield stress (1) from the plasticity factor eta = 1 - 1.25 sqrt(s - 0.55) put into s = eta x.

    Source: miller1977, eqs. (13), (14a) to (14c); solved for the root of s - 0.55.
    """
    x = np.asarray(elastic_ratio, dtype=float)
    root = (np.sqrt((1.25 * x) ** 2 + 4 * np.maximum(x - 0.55, 0)) - 1.25 * x) / 2
    return np.where(x <= 0.55, x, np.minimum(root**2 + 0.55, 1.0))


def inelastic_ratio_plain_6_2(elastic_ratio):
    """Strength over yield stress (1) with (15c) up to the printed "6.2", a stress too small ever to lie above 1.6 sigma_y.

    Source: miller1977, eqs. (15a) to (15d) as printed.
    """
    return inelastic_ratio(elastic_ratio, full_yield_from=1.6)


def _rival(key: str, title: str, locator: str, what: str, reading: Reading):
    return rule(
        reading,
        key=f"{miller1977.ROW.key}_{key}",
        rival_of=miller1977.ROW.key,
        title=title,
        locator=locator,
        formula=f"{FORMULA}; but {what}",
        validity="a reading that the source's own tests do not bear out or do not decide; for comparison only",
        colour="#999999",
        marker="x",
        line=":",
    )


ROWS = (
    _rival("junction_3_5", "junction at (J/C)^(3/5)", "text after eq. (7)", "M = (J/C)^(3/5)", Reading(junction_exponent=0.6)),
    _rival("natural_log", "natural logarithm", "eqs. (4) to (7)", "log to base e", Reading(logarithm=np.log)),
    _rival(
        "radius_15_in", "radius 15 in.", "text on the small tests", "R twice as large, M as printed", Reading(radius_factor=2)
    ),
    _rival(
        "diameter_7_5_in", "diameter 7.5 in.", "note to Table 2", "R half as large, M as printed", Reading(radius_factor=0.5)
    ),
    _rival("eq_14b", "plasticity by (13), (14b)", "eqs. (13), (14)", "(14) for (15)", Reading(inelastic=inelastic_ratio_14b)),
    _rival("plain_6_2", "(15c) to a plain 6.2", "eq. (15c)", "1 from x = 1.6", Reading(inelastic=inelastic_ratio_plain_6_2)),
    _rival(
        "bay_in_eq_11",
        "C of the bay in (11)",
        "eq. (11)",
        "the C in C_3 that of the bay, not of the long shell",
        Reading(ring_coefficient_from_bay=True),
    ),
)
