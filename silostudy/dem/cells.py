"""Cell grid: which discs lie near a point."""

from typing import Any

import numpy as np
from numba import njit

from silostudy.dem.lanes import X, Y

# No fastmath: bits must not depend on the place in an array. No counting of references to arrays (_nrt): it took two
# thirds of a step; all compiled functions go without it, since one that counts must not meet one that does not.
OPTIONS: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy", "_nrt": False}


@njit(**OPTIONS)
def cell_of(value, low, size, count):
    """Index of the cell that holds a coordinate, the outer cells taking whatever lies beyond."""
    index = int((value - low) / size)
    return min(max(index, 0), count - 1)


@njit(**OPTIONS)
def box_of(rows, n):
    """Least and largest x and y (m) of the first n discs."""
    x0, y0, x1, y1 = rows[0, X], rows[0, Y], rows[0, X], rows[0, Y]
    for i in range(n):
        x0, x1 = min(x0, rows[i, X]), max(x1, rows[i, X])
        y0, y1 = min(y0, rows[i, Y]), max(y1, rows[i, Y])
    return x0, y0, x1, y1


@njit(**OPTIONS)
def bin_discs(rows, n, size, cell_begin, order):
    """Sort the first n discs into square cells; gives the corner, the size and the numbers of cells each way.

    Cells grow where the discs are so scattered that there would be more cells than room for them.
    """
    x0, y0, x1, y1 = box_of(rows, n)
    nx, ny = int((x1 - x0) / size) + 1, int((y1 - y0) / size) + 1
    while nx * ny + 1 > cell_begin.size:
        size *= 1.5
        nx, ny = int((x1 - x0) / size) + 1, int((y1 - y0) / size) + 1
    cell_begin[: nx * ny + 1] = 0
    for i in range(n):
        cell_begin[cell_of(rows[i, Y], y0, size, ny) * nx + cell_of(rows[i, X], x0, size, nx)] += 1
    total = np.int32(0)
    for c in range(nx * ny + 1):
        total += cell_begin[c]
        cell_begin[c] = total
    for i in range(n - 1, -1, -1):
        c = cell_of(rows[i, Y], y0, size, ny) * nx + cell_of(rows[i, X], x0, size, nx)
        cell_begin[c] -= 1
        order[cell_begin[c]] = i
    return x0, y0, size, nx, ny
