"""Geometry of space for the stability bound: densest packing, directions across a contact, ways from surfaces to spheres."""

from math import sqrt
from typing import SupportsIndex

import numpy as np
from numba import njit

from silostudy.dem.cache import OPTIONS
from silostudy.dem.space.surfaces import nearest

CELLS = 3  # of the lattice, each way from the origin


def densest() -> np.ndarray:
    """Places (n, 3) of spheres in hexagonal layers about the origin, in radii, each layer in the hollows of the one below."""
    i, j, k = np.mgrid[-CELLS : CELLS + 1, -CELLS : CELLS + 1, -CELLS : CELLS + 1].reshape(3, -1)
    return np.c_[2.0 * i + j + k, sqrt(3.0) * (j + k / 3.0), 2.0 * sqrt(2.0 / 3.0) * k]


def all_from_wall(shape: np.ndarray, wall: SupportsIndex, places: np.ndarray) -> np.ndarray:
    """Vectors (n, 3; m) from a surface's nearest points to places."""
    ways = np.zeros((len(places), 3))
    _all_nearest(shape, wall, np.ascontiguousarray(places, float), ways)
    return ways


@njit(**OPTIONS)
def _all_nearest(shape, wall, places, ways):
    for i in range(places.shape[0]):
        ways[i, 0], ways[i, 1], ways[i, 2], _ = nearest(shape, wall, places[i, 0], places[i, 1], places[i, 2])


def bent(shape: np.ndarray, wall: int, *place: float) -> float:
    """Curvature (1/m) of a surface at its point nearest to a place."""
    return float(nearest(shape, wall, *place)[3])
