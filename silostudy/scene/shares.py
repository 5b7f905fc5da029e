"""Whole numbers of grains from their shares."""

import numpy as np


def whole(weights: np.ndarray, count: int) -> np.ndarray:
    """So many shared out by weights as whole numbers, those with the largest remainders rounded up."""
    exact = weights / weights.sum() * count
    low = np.floor(exact).astype(int)
    low[np.argsort(low - exact, kind="stable")[: count - low.sum()]] += 1
    return low
