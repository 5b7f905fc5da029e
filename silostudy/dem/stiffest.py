"""The stiffest motion of a network of contacts, by Lanczos' turns: springs pull at bodies, and what they pull at moves on.

One code for the plane and for space: discs are bodies in space that move level and turn about the third axis.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np
from numba import njit
from scipy.linalg import eigvalsh_tridiagonal

from silostudy.dem.cache import OPTIONS

ROUND = 8  # turns, after which the largest eigenvalue is looked at
MOST = 400  # turns


class Network(NamedTuple):
    """Contacts of bodies: first and second (-1: a wall), normals (n, 3); of each body radius (m), and what its velocity and its
    spin are over those of a unit mass and inertia of the same energy; motions (bodies, 6) that a search begins with."""

    first: np.ndarray
    second: np.ndarray
    normal: np.ndarray
    radius: np.ndarray
    rates: np.ndarray
    start: np.ndarray


@njit(**OPTIONS)
def pull(network, strength, x, y):
    """Write into y how springs of a strength (contacts, 4: along, across, rolling, twisting) pull at motions x (bodies, 6)."""
    for i in range(x.shape[0]):
        for k in range(6):
            y[i, k] = 0.0
    for c in range(network.first.size):
        i, j = network.first[c], network.second[c]
        nx, ny, nz = network.normal[c, 0], network.normal[c, 1], network.normal[c, 2]
        along, across, rolling, twisting = strength[c, 0], strength[c, 1], strength[c, 2], strength[c, 3]
        m, t, a = network.rates[i, 0], network.rates[i, 1], network.radius[i]
        u, v, w = m * x[i, 0], m * x[i, 1], m * x[i, 2]
        p, q, r = t * x[i, 3], t * x[i, 4], t * x[i, 5]
        sp, sq, sr = a * p, a * q, a * r
        if j >= 0:
            n, s, b = network.rates[j, 0], network.rates[j, 1], network.radius[j]
            u, v, w = u - n * x[j, 0], v - n * x[j, 1], w - n * x[j, 2]
            op, oq, our = s * x[j, 3], s * x[j, 4], s * x[j, 5]
            p, q, r = p - op, q - oq, r - our
            sp, sq, sr = sp + b * op, sq + b * oq, sr + b * our
        closing, turning = u * nx + v * ny + w * nz, p * nx + q * ny + r * nz
        gx = across * (u - closing * nx - sq * nz + sr * ny)
        gy = across * (v - closing * ny - sr * nx + sp * nz)
        gz = across * (w - closing * nz - sp * ny + sq * nx)
        fx, fy, fz = gx + along * closing * nx, gy + along * closing * ny, gz + along * closing * nz
        hx, hy, hz = gy * nz - gz * ny, gz * nx - gx * nz, gx * ny - gy * nx
        more = (twisting - rolling) * turning
        mx, my, mz = rolling * p + more * nx, rolling * q + more * ny, rolling * r + more * nz
        y[i, 0] += m * fx
        y[i, 1] += m * fy
        y[i, 2] += m * fz
        y[i, 3] += t * (a * hx + mx)
        y[i, 4] += t * (a * hy + my)
        y[i, 5] += t * (a * hz + mz)
        if j >= 0:
            y[j, 0] -= n * fx
            y[j, 1] -= n * fy
            y[j, 2] -= n * fz
            y[j, 3] += s * (b * hx - mx)
            y[j, 4] += s * (b * hy - my)
            y[j, 5] += s * (b * hz - mz)


@njit(**OPTIONS)
def turn(network, strength, x, before, y, diagonal, beside, begin, end):
    """Lanczos' turns from one to before another; gives how many there are by then: fewer where nothing is left to turn to."""
    for k in range(begin, end):
        pull(network, strength, x, y)
        back, on, left = beside[k - 1] if k > 0 else 0.0, 0.0, 0.0
        for i in range(x.shape[0]):
            for way in range(6):
                y[i, way] -= back * before[i, way]
                on += y[i, way] * x[i, way]
        for i in range(x.shape[0]):
            for way in range(6):
                y[i, way] -= on * x[i, way]
                left += y[i, way] * y[i, way]
        diagonal[k], beside[k] = on, sqrt(left)
        if not left > 0.0:
            return k + 1
        for i in range(x.shape[0]):
            for way in range(6):
                before[i, way], x[i, way] = x[i, way], y[i, way] / beside[k]
    return end


def stiffest(network: Network, strength: np.ndarray, close: float) -> float:
    """Largest eigenvalue (1/s2 or 1/s) of springs of a strength per mass; close: share of it by which the last round of turns
    may have changed it."""
    x = network.start / np.linalg.norm(network.start)
    before, y = np.zeros_like(x), np.zeros_like(x)
    diagonal, beside, made, top, last = np.zeros(MOST), np.zeros(MOST), 0, 0.0, -1.0
    while made % ROUND == 0 and made < MOST and top - last > close * top:
        made = turn(network, strength, x, before, y, diagonal, beside, made, made + ROUND)
        last, top = top, float(eigvalsh_tridiagonal(diagonal[:made], beside[: made - 1])[-1])
    return top
