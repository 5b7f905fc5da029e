"""Geometry of space for the stability bound: densest packing, directions across a contact, ways from surfaces to spheres."""

from math import sqrt
from typing import SupportsIndex

import numpy as np

from silostudy.dem.space.surfaces import nearest

CELLS = 3  # of the lattice, each way from the origin


def densest() -> np.ndarray:
    """Places (n, 3) of spheres in hexagonal layers about the origin, in radii, each layer in the hollows of the one below."""
    i, j, k = np.mgrid[-CELLS : CELLS + 1, -CELLS : CELLS + 1, -CELLS : CELLS + 1].reshape(3, -1)
    return np.c_[2.0 * i + j + k, sqrt(3.0) * (j + k / 3.0), 2.0 * sqrt(2.0 / 3.0) * k]


def tangents(normals: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
    """Pair of directions across each normal (n, 3), each with the turn (n, 3) of a spin that moves the contact along it."""
    least = np.eye(3)[np.argmin(np.abs(normals), axis=1)]
    first = np.cross(normals, least)
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normals, first)
    return [(first, second), (second, -first)]


def all_from_wall(shape: np.ndarray, wall: SupportsIndex, places: np.ndarray) -> np.ndarray:
    """Vectors (n, 3; m) from a surface's nearest points to places."""
    return np.array([nearest(shape, wall, *place)[:3] for place in places]).reshape(-1, 3)


def bent(shape: np.ndarray, wall: int, *place: float) -> float:
    """Curvature (1/m) of a surface at its point nearest to a place."""
    return float(nearest(shape, wall, *place)[3])
