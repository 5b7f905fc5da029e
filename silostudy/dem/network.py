"""Geometry of the plane for the stability bound: densest packing, directions across a contact, ways from walls to discs."""

from math import sqrt

import numpy as np

from silostudy.dem.joints import REACH
from silostudy.dem.walls import OUT_OF_REACH, seam_before

CELLS = 3  # of the lattice, each way from the origin


def densest() -> np.ndarray:
    """Places (n, 2) of discs in hexagonal order about the origin, in radii."""
    i, j = np.mgrid[-CELLS : CELLS + 1, -CELLS : CELLS + 1].reshape(2, -1)
    return np.c_[2.0 * (i + 0.5 * j), sqrt(3.0) * j]


def all_from_wall(shape: np.ndarray, wall: int, places: np.ndarray) -> np.ndarray:
    """Vectors (n, 2; m) from a wall's nearest points, those of its ends among them, to places; none across a seam."""
    x, y, tx, ty, begin, end = shape[wall, : REACH + 2]
    along = (places[:, 0] - x) * tx + (places[:, 1] - y) * ty
    nearest = np.clip(along, begin, end)
    ways = places - np.c_[x + nearest * tx, y + nearest * ty]
    across = (along >= end) & seam_before(shape, wall + 1) | (along < begin) & seam_before(shape, wall)
    ways[across] = OUT_OF_REACH
    return ways
