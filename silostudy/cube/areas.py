"""Largest mean pressure over areas of a wall: one cell, blocks of cells, a whole ring.

On a plane silo's walls a level has two cells, left and right: there blocks are of levels of both walls.
"""

import numpy as np
import xarray as xr
from numpy.lib.stride_tricks import sliding_window_view

# name -> levels and turns of cells whose mean is one pressure; 0: all around
AVERAGED = {"1x1": (1, 1), "2x2": (2, 2), "4x4": (4, 4), "ring": (1, 0)}


def over_levels(values: np.ndarray, count: int) -> np.ndarray:
    """Mean of each level and the next ones above it (the last axis but one); NaN where there are too few above."""
    means = sliding_window_view(values, count, axis=-2).mean(axis=-1)
    gap = [(0, 0)] * values.ndim
    gap[-2] = (0, count - 1)
    return np.pad(means, gap, constant_values=np.nan)


def over_turns(values: np.ndarray, count: int) -> np.ndarray:
    """Mean of each turn and the next ones (the last axis, which closes on itself); one of all where count is 0."""
    if count == 0:
        return values.mean(axis=-1, keepdims=True)
    closed = np.concatenate([values, values[..., : count - 1]], axis=-1)
    return sliding_window_view(closed, count, axis=-1).mean(axis=-1)


def largest_mean(pressure: np.ndarray, area: str) -> np.ndarray:
    """Largest mean (Pa; ..., levels) around the wall over an area with each level as its lowest; of (..., levels, turns)."""
    levels, turns = AVERAGED[area]
    return over_turns(over_levels(pressure, levels), turns).max(axis=-1)


def of_profile(pressure: np.ndarray, area: str) -> np.ndarray:
    """Mean (Pa; ..., levels) over an area whose lowest level is each, of a pressure that is the same all around."""
    return over_levels(pressure[..., None], AVERAGED[area][0])[..., 0]


def step_of(height: xr.DataArray) -> xr.DataArray:
    """Height (m) of a level."""
    return height.isel(wall_level=1) - height.isel(wall_level=0)
