"""Settings that are worth their cost: the Pareto front, and the cheapest that reaches an error."""

import numpy as np

ROUNDING = 1e-12  # relative error below which finer settings only roll other dice


def on_front(cost, error) -> np.ndarray:
    """Whether no other rung is both cheaper and at least as accurate (or as cheap and more accurate); NaN never is."""
    cost, error = np.asarray(cost, float), np.asarray(error, float)
    worth, best = np.zeros(len(cost), bool), np.inf
    for k in np.lexsort((error, cost)):
        if error[k] < best:
            worth[k], best = True, error[k]
    return worth


def lasting_error(error) -> np.ndarray:
    """Largest error at each setting of a ladder and at all finer ones, from coarse to fine: a lucky setting does not count.

    NaN where the setting itself has none; errors of rounding size count at their own setting only.
    """
    error = np.asarray(error, float)
    lasting = np.fmax.accumulate(np.where(error < ROUNDING, 0.0, error)[::-1])[::-1]
    return np.where(np.isnan(error), np.nan, np.fmax(error, lasting))


def cheapest(cost, error, asked: float) -> int | None:
    """Number of the cheapest rung whose error is at most the asked one; None where none is."""
    cost = np.where(np.asarray(error, float) <= asked, cost, np.inf)
    return int(np.argmin(cost)) if np.isfinite(cost).any() else None
