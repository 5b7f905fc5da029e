"""Whole numbers of grains from their shares."""

import numpy as np


def whole(weights: np.ndarray, count: int) -> np.ndarray:
    """Whole numbers that sum to a count, shared out by weights; those with the largest remainders are rounded up."""
    exact = weights / weights.sum() * count
    low = np.floor(exact).astype(int)
    low[np.argsort(low - exact, kind="stable")[: count - low.sum()]] += 1
    return low
