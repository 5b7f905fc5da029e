"""Curves over depth that jump, drawn as steps: what a code asks for from one depth on is no slope between two levels."""

from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from silostudy.figures.style import AID

STEEP = 6.0  # times as large a change as between the levels on both sides
TALL = 0.03  # of the largest value


def jumps(values: np.ndarray) -> np.ndarray:
    """Places k such that the values jump between level k and k + 1."""
    change = np.abs(np.diff(values))
    if len(change) < 3:
        return np.array([], dtype=int)
    beside = np.maximum(np.r_[change[1], change[:-1]], np.r_[change[1:], change[-2]])
    return np.flatnonzero((change > STEEP * beside) & (change > TALL * np.nanmax(np.abs(values))))


def over_depth(panel: Axes, values: np.ndarray, depth: np.ndarray, **style: Any) -> None:
    """Draws values across over depth; where they jump, the curve ends and goes on at the middle of the two levels."""
    edges = [0, *(jumps(values) + 1), len(values)]
    label = style.pop("label", None)
    for first, last in pairwise(edges):
        panel.plot(values[first:last], depth[first:last], label=label if first == 0 else None, **style)
    bare = style | {"marker": "none"}
    for k in edges[1:-1]:
        middle = 0.5 * (depth[k - 1] + depth[k])
        across, down = [values[k - 1], values[k - 1], values[k], values[k]], [depth[k - 1], middle, middle, depth[k]]
        panel.plot(across, down, gid=AID, **bare)
