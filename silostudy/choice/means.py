"""Number of fillings that a mean needs: by the scatter that they show, and the one that was expected where they are few."""

from math import ceil

import numpy as np
from scipy.special import stdtrit

SURE = 0.95  # share of means that keep the error
NORMAL = 1.96  # standard deviations within which as many lie
PRIOR = 6  # fillings that the scatter expected beforehand counts for
CENTRE = 0.84  # of its square: with it 95 % of the means of scenes made up keep what is asked, and no more do
AT_ONCE = 0.1  # of the fillings there are, that many more are added before the scatter is looked at again; one at least
MOST = 512  # fillings


def mean_bound(values: np.ndarray, scatter: float, prior: int = PRIOR) -> float:
    """Relative error (1) that 95 % of means of so many values keep, by Student's t.

    scatter: relative standard deviation (1) that was expected of a value; prior: how many values that counts for.
    """
    count, mean = len(values), values.mean()
    freedom = prior + count - 1
    square = (prior * CENTRE * (scatter * mean) ** 2 + ((values - mean) ** 2).sum()) / freedom
    return float(stdtrit(freedom, 0.5 + SURE / 2.0) * np.sqrt(square / count) / abs(mean))


def enough(values: np.ndarray, asked: float, scatter: float, prior: int = PRIOR) -> int:
    """Number of values after which to look again, as many as there are where they keep a relative error (1)."""
    count, bound = len(values), mean_bound(values, scatter, prior)
    if bound <= asked:
        return count
    wanted = min(ceil(count * (bound / asked) ** 2), count + int(AT_ONCE * count))
    return min(MOST, max(wanted, count + 1))
