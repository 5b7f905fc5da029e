"""Number of fillings that a mean needs: by the scatter that they show, and the one that was expected where they are few."""

from math import ceil

import numpy as np
from scipy.special import stdtrit

SURE = 0.95  # share of means that keep the error
NORMAL = 1.96  # standard deviations within which as many lie
PRIOR = 4  # fillings that the scatter expected beforehand counts for
MOST = 512  # fillings


def mean_bound(values: np.ndarray, scatter: float, prior: int = PRIOR) -> float:
    """Relative error (1) that 95 % of means of so many values keep, by Student's t.

    scatter: relative standard deviation (1) that was expected of a value; prior: how many values that counts for.
    """
    count, mean = len(values), values.mean()
    freedom = prior + count - 1
    square = (prior * (scatter * mean) ** 2 + ((values - mean) ** 2).sum()) / freedom
    return float(stdtrit(freedom, 0.5 + SURE / 2.0) * np.sqrt(square / count) / abs(mean))


def enough(values: np.ndarray, asked: float, scatter: float, prior: int = PRIOR) -> int:
    """Number of values in all that would keep a relative error (1) by what they show, at most twice as many as there are."""
    bound = mean_bound(values, scatter, prior)
    if bound <= asked:
        return len(values)
    return min(MOST, 2 * len(values), max(len(values) + 1, ceil(len(values) * (bound / asked) ** 2)))
