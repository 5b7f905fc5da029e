"""Intervals of means over fillings, of their changes, and of one filling."""

import numpy as np
from scipy.stats import t as student

SURE = 0.95


def changed(values: np.ndarray, base: np.ndarray) -> tuple[float, float]:
    """Relative change (1) of a mean against another, and half its interval by Welch; NaN where fewer than two values are."""
    own, other = values[np.isfinite(values)], base[np.isfinite(base)]
    if min(len(own), len(other)) < 2:
        return np.nan, np.nan
    parts = [part.var(ddof=1) / len(part) for part in (own, other)]
    freedom = sum(parts) ** 2 / sum(part**2 / (len(of) - 1) for part, of in zip(parts, (own, other), strict=True))
    half = student.ppf(0.5 + SURE / 2, freedom) * np.sqrt(sum(parts))
    return float(own.mean() / other.mean() - 1.0), float(half / abs(other.mean()))


def reach_of_one(values: np.ndarray) -> float:
    """Relative distance (1) from the mean within which one filling lies, surely by `SURE`."""
    seen = values[np.isfinite(values)]
    return float(student.ppf(0.5 + SURE / 2, len(seen) - 1) * seen.std(ddof=1) / abs(seen.mean()))


def half_interval(values: np.ndarray) -> float:
    """Half the relative interval (1) of a mean."""
    seen = values[np.isfinite(values)]
    return float(student.ppf(0.5 + SURE / 2, len(seen) - 1) * seen.std(ddof=1) / np.sqrt(len(seen)) / abs(seen.mean()))
