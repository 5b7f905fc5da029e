"""The two functions by which every Janssen-type formula saturates, exact at zero and without cancellation."""

import numpy as np
from scipy.special import exprel


def saturation(x):
    """Function (1 - exp(-x)) / x for x >= 0: 1 at x = 0, 1/x for large x."""
    return exprel(-np.asarray(x, dtype=float))


def saturation_deficit(x):
    """Function (1 - saturation(x)) / x = (exp(-x) - 1 + x) / x**2 for x >= 0: 1/2 at x = 0.

    The difference loses digits for small x, so below 1 its Taylor series serves (16 terms: remainder under 1e-16).
    """
    x = np.asarray(x, dtype=float)
    small = np.minimum(x, 1.0)
    series = np.zeros_like(small)
    for k in range(18, 1, -1):
        series = (1.0 - series * small) / k  # nested: 1/2 (1 - x/3 (1 - x/4 (...)))
    large = np.maximum(x, 1.0)
    return np.where(x < 1.0, series, (1.0 - saturation(large)) / large)


def growth(x):
    """Function (exp(x) - 1) / x for x >= 0: 1 at x = 0."""
    return exprel(np.asarray(x, dtype=float))


def growth_excess(x):
    """Function (growth(x) - 1) / x = (exp(x) - 1 - x) / x**2 for x >= 0: 1/2 at x = 0; below 1 by its Taylor series."""
    x = np.asarray(x, dtype=float)
    small = np.minimum(x, 1.0)
    series = np.zeros_like(small)
    for k in range(19, 1, -1):
        series = (1.0 + series * small) / k
    large = np.maximum(x, 1.0)
    return np.where(x < 1.0, series, (growth(large) - 1.0) / large)
