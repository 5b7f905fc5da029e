"""Geometry of the plane for the stability bound: densest packing, directions across a contact, ways from walls to discs."""

from math import sqrt

import numpy as np

CELLS = 3  # of the lattice, each way from the origin


def densest() -> np.ndarray:
    """Places (n, 2) of discs in hexagonal order about the origin, in radii."""
    i, j = np.mgrid[-CELLS : CELLS + 1, -CELLS : CELLS + 1].reshape(2, -1)
    return np.c_[2.0 * (i + 0.5 * j), sqrt(3.0) * j]


def all_from_wall(shape: np.ndarray, wall: int, places: np.ndarray) -> np.ndarray:
    """Vectors (n, 2; m) from a wall's nearest points, those of its ends among them, to places."""
    x, y, tx, ty, length = shape[wall, :5]
    along = np.clip((places[:, 0] - x) * tx + (places[:, 1] - y) * ty, 0.0, length)
    return places - np.c_[x + along * tx, y + along * ty]
