"""Ensembles of a packing study: names of packings, spreads over runs, chances with their confidence intervals."""

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from scipy.stats import binomtest

from silostudy.figures.style import BLUE, VERMILION

LOW = 0.1  # lower quantile of a band
HIGH = 0.9  # upper quantile of it
COLOURS = {False: BLUE, True: VERMILION}


def name(across: float) -> str:
    """A packing as the source writes it."""
    return f"{int(across) - 1}/{int(across)}"


def runs(values: xr.DataArray) -> np.ndarray:
    """The runs with offsets, without the ideal start; runs come first."""
    return values.isel(run=slice(1, None)).transpose("run", ...).values


def spread(values: np.ndarray) -> np.ndarray:
    """Tenth, median and nine tenths over the runs, which come first."""
    return np.quantile(values, [LOW, 0.5, HIGH], axis=0)


def chance(hits: np.ndarray) -> tuple[float, float, float]:
    """Share of the runs, with the 95 % interval of Clopper and Pearson."""
    known = hits[np.isfinite(hits)]
    if not len(known):
        return np.nan, np.nan, np.nan
    interval = binomtest(int(known.sum()), len(known)).proportion_ci(method="exact")
    return float(known.mean()), float(interval.low), float(interval.high)


def bundle(panel: Axes, time: np.ndarray, values: np.ndarray, *, faint: bool = True, **look: Any) -> None:
    """Single runs in grey, their band, their median."""
    low, middle, high = spread(values)
    if faint:
        panel.plot(time, values.T, color="0.8", linewidth=0.3)
    panel.fill_between(time, low, high, color=look["color"], alpha=0.18, linewidth=0)
    panel.plot(time, middle, linewidth=1.8, **look)


def first(cube: xr.Dataset) -> xr.Dataset:
    """The cases without the remedy."""
    return cube.isel(removal=0) if "removal" in cube.dims else cube
