"""Cell grid: which bodies lie near a point."""

import numpy as np
from numba import njit

from silostudy.dem.body import place
from silostudy.dem.cache import OPTIONS


@njit(**OPTIONS)
def cell_of(value, low, size, count):
    """Index of the cell that holds a coordinate, the outer cells taking whatever lies beyond."""
    index = int((value - low) / size)
    return min(max(index, 0), count - 1)


@njit(**OPTIONS)
def box_of(bodies, n):
    """Least and largest x, y and z (m) of the first n bodies."""
    x0, y0, z0 = place(bodies, 0)
    x1, y1, z1 = x0, y0, z0
    for i in range(n):
        x, y, z = place(bodies, i)
        x0, x1 = min(x0, x), max(x1, x)
        y0, y1 = min(y0, y), max(y1, y)
        z0, z1 = min(z0, z), max(z1, z)
    return (x0, y0, z0), (x1, y1, z1)


@njit(**OPTIONS)
def counts_of(low, high, size):
    """Numbers of cells each way."""
    return (
        int((high[0] - low[0]) / size) + 1,
        int((high[1] - low[1]) / size) + 1,
        int((high[2] - low[2]) / size) + 1,
    )


@njit(**OPTIONS)
def cell_index(bodies, i, grid):
    """Number of the cell of body i: along x first, then y, then z."""
    (x0, y0, z0), size, (nx, ny, nz) = grid
    x, y, z = place(bodies, i)
    return (cell_of(z, z0, size, nz) * ny + cell_of(y, y0, size, ny)) * nx + cell_of(x, x0, size, nx)


@njit(**OPTIONS)
def bin_bodies(bodies, n, size, cell_begin, order):
    """Sort the first n bodies into equal cells; gives the corner, the size and the numbers of cells each way.

    Cells grow where the bodies are so scattered that there would be more cells than room for them.  Discs fill one layer.
    """
    low, high = box_of(bodies, n)
    counts = counts_of(low, high, size)
    while float(counts[0]) * counts[1] * counts[2] + 1.0 > cell_begin.size:
        size *= 1.5
        counts = counts_of(low, high, size)
    grid, cells = (low, size, counts), counts[0] * counts[1] * counts[2]
    cell_begin[: cells + 1] = 0
    for i in range(n):
        cell_begin[cell_index(bodies, i, grid)] += 1
    total = np.int32(0)
    for c in range(cells + 1):
        total += cell_begin[c]
        cell_begin[c] = total
    for i in range(n - 1, -1, -1):
        c = cell_index(bodies, i, grid)
        cell_begin[c] -= 1
        order[cell_begin[c]] = i
    return grid
