"""The curves of Miller's figures 1 to 7, tabulated for the cube of a study of his tests."""

import numpy as np

from silostudy.buckling.miller1977 import (
    inelastic_ratio,
    local_coefficient,
    long_coefficient,
    ring_coefficient,
    short_coefficient,
)

SLENDER = np.geomspace(100, 3000, 60)  # R/t
LENGTH = np.geomspace(0.5, 100, 90)  # M, relative length
RING_RATIO = np.linspace(0, 0.4, 81)  # area of a ring over that of its bay's wall
ELASTIC_RATIO = np.geomspace(0.1, 10, 120)  # elastic buckling stress over yield stress
MAKING = ("manufactured", "fabricated")


def charts() -> dict[str, np.ndarray]:
    """Chart variables and their coordinates: Miller's coefficients over R/t, M, ring area ratio, and his plasticity curve."""
    fabricated = np.array([False, True])[:, None]
    with np.errstate(invalid="ignore"):
        long = long_coefficient(SLENDER, fabricated, False)
        long = np.where(long > 0, long, np.nan)
        short = np.where(np.isnan(long), np.nan, short_coefficient(SLENDER, fabricated, False))
        local = local_coefficient(LENGTH, long[..., None], short[..., None])
    ring = np.where(np.isnan(long)[..., None], np.nan, ring_coefficient(RING_RATIO, long[..., None]))
    return {
        "chart_long_coefficient": long,
        "chart_short_coefficient": short,
        "chart_local_coefficient": local,
        "chart_ring_coefficient": ring,
        "chart_strength_ratio": inelastic_ratio(ELASTIC_RATIO),
        "chart_making": np.array(MAKING),
        "chart_slenderness": SLENDER,
        "chart_relative_length": LENGTH,
        "chart_ring_area_ratio": RING_RATIO,
        "chart_elastic_ratio": ELASTIC_RATIO,
    }
