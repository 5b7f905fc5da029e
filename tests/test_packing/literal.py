"""The source's algorithm in its own words: a transcription of eqs. (3) to (19) that shares nothing with the engine.

Incremental springs as printed, or the normal spring on the total overlap; increments of (18) or (19).  Walls are the floor
and two sides; contacts are looked for among all discs of a coarse list.  Axes as in the package: x across, y upward.
"""

from math import hypot

import numpy as np
from numba import njit


@njit
def near_pairs(x, y, reach):
    """Pairs (i, j), i < j, no further apart than reach."""
    found = []
    for i in range(len(x)):
        for j in range(i + 1, len(x)):
            if (x[i] - x[j]) ** 2 + (y[i] - y[j]) ** 2 < reach * reach:
                found.append((i, j))
    return found


@njit
def spring(e, d, es, ds, mu):
    """Normal and tangential force after the conditions (8), (12) and (13); the elastic parts that stay."""
    if e < 0.0:
        return 0.0, 0.0, 0.0, 0.0
    if abs(es) > mu * e:
        es, ds = mu * e * np.sign(es), 0.0
    return max(e + d, 0.0), es + ds, e, es


@njit
def march(x, y, r, mass, width, gravity, kn, eta, s, mu, mu_wall, dt, steps, incremental, smoothed, half_slit):
    """Step the discs in place; gives the largest normal force on a side wall (N/m) and that force at the last step.

    half_slit (m): discs within it of the middle of the floor fall through; below 0 the floor is closed.
    """
    n = len(x)
    u, v, w = np.zeros(n), np.zeros(n), np.zeros(n)  # velocities of (17)
    du, dv, dw = np.zeros(n), np.zeros(n), np.zeros(n)  # increments of (18) or (19)
    pair_e, pair_s = np.zeros((n, n)), np.zeros((n, n))
    wall_e, wall_s = np.zeros((n, 3)), np.zeros((n, 3))
    pairs, gone, peak, last = near_pairs(x, y, 2.6 * r), 0.0, 0.0, 0.0
    for _ in range(steps):
        fx, fy, m = np.zeros(n), np.full(n, -mass * gravity), np.zeros(n)
        for i, j in pairs:
            distance = hypot(x[i] - x[j], y[i] - y[j])
            if distance > 2.0 * r:
                pair_e[i, j] = pair_s[i, j] = 0.0
                continue
            c, q = (x[j] - x[i]) / distance, (y[j] - y[i]) / distance
            dn = (du[i] - du[j]) * c + (dv[i] - dv[j]) * q
            ds = -(du[i] - du[j]) * q + (dv[i] - dv[j]) * c + r * (dw[i] + dw[j])
            e = pair_e[i, j] + kn * dn if incremental else kn * (2.0 * r - distance)
            f, t, pair_e[i, j], pair_s[i, j] = spring(e, eta * dn / dt, pair_s[i, j] + s * kn * ds, s**0.5 * eta * ds / dt, mu)
            fx[i] += -f * c + t * q
            fy[i] += -f * q - t * c
            fx[j] += f * c - t * q
            fy[j] += f * q + t * c
            m[i] -= r * t
            m[j] -= r * t
        last = 0.0
        for i in range(n):
            for wall in range(3):
                c, q = (-1.0, 0.0) if wall == 0 else (1.0, 0.0) if wall == 1 else (0.0, -1.0)
                gap = x[i] if wall == 0 else width - x[i] if wall == 1 else y[i]
                open_floor = wall == 2 and (abs(x[i] - 0.5 * width) < half_slit or y[i] < 0.0)
                if gap > r or open_floor:
                    wall_e[i, wall] = wall_s[i, wall] = 0.0
                    continue
                dn, ds = du[i] * c + dv[i] * q, -du[i] * q + dv[i] * c + r * dw[i]
                e = wall_e[i, wall] + 2.0 * kn * dn if incremental else 2.0 * kn * (r - gap)
                f, t, wall_e[i, wall], wall_s[i, wall] = spring(
                    e, 2.0 * eta * dn / dt, wall_s[i, wall] + 2.0 * s * kn * ds, 2.0 * s**0.5 * eta * ds / dt, mu_wall
                )
                fx[i] += -f * c + t * q
                fy[i] += -f * q - t * c
                m[i] -= r * t
                if wall < 2:
                    last = max(last, f)
        peak = max(peak, last)
        way = 0.0
        for i in range(n):
            u[i] += fx[i] / mass * dt
            v[i] += fy[i] / mass * dt
            w[i] += m[i] / (0.5 * mass * r * r) * dt
            du[i] = 0.5 * (du[i] + u[i] * dt) if smoothed else u[i] * dt
            dv[i] = 0.5 * (dv[i] + v[i] * dt) if smoothed else v[i] * dt
            dw[i] = 0.5 * (dw[i] + w[i] * dt) if smoothed else w[i] * dt
            x[i] += du[i]
            y[i] += dv[i]
            way = max(way, hypot(du[i], dv[i]))
        gone += way
        if gone > 0.25 * r:
            pairs, gone = near_pairs(x, y, 2.6 * r), 0.0
    return peak, last
