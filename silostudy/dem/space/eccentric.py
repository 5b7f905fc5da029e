"""The wall of an eccentric cone: level circles whose middles and radii go evenly with the height, and the nearest point on it.

The nearest point on the circle of a level lies in the direction that the place has from that circle's middle, so that one
unknown is left: the level, as a share of the height, at which the square of the distance to the circle is least.
"""

from math import atan2, pi, sqrt

from numba import njit
from numba.extending import register_jitable

from silostudy.dem.cache import OPTIONS
from silostudy.dem.space.rows import (
    ALONG_R,
    ALONG_Z,
    AXIS_X,
    AXIS_Y,
    END_END,
    LEAN_X,
    LEAN_Y,
    OUT_OF_REACH,
    START_END,
    START_R,
    START_Z,
)

CLOSE = 1e-9  # of the height: the last step, after which an error of its square is left
ROUNDS = 60  # of halving a share: nothing is left of it


@register_jitable
def circle_to(shape, wall, share, x, y):
    """Unit vector and distance (m) of (x, y) from the middle of the circle at a share of the height, and its radius (m)."""
    ax, ay = x - shape[wall, AXIS_X] - share * shape[wall, LEAN_X], y - shape[wall, AXIS_Y] - share * shape[wall, LEAN_Y]
    off, radius = sqrt(ax * ax + ay * ay), shape[wall, START_R] + share * shape[wall, ALONG_R]
    if off > 0.0:
        return ax / off, ay / off, off, radius
    return 1.0, 0.0, 0.0, radius  # at the middle every direction is as near


@register_jitable
def slope(shape, wall, share, x, y, z):
    """Half the first and the second derivative (m2) by the share of the height of the square distance to the circle there."""
    ax, ay, off, radius = circle_to(shape, wall, share, x, y)
    wide, high, dx, dy = shape[wall, ALONG_R], shape[wall, ALONG_Z], shape[wall, LEAN_X], shape[wall, LEAN_Y]
    outward, sideways = -(ax * dx + ay * dy) - wide, ax * dy - ay * dx
    first = (off - radius) * outward - (z - shape[wall, START_Z] - share * high) * high
    bend = (off - radius) * sideways * sideways / off if off > 0.0 else 0.0
    return first, outward * outward + bend + high * high


@register_jitable
def nearest_level_of(shape, wall, x, y, z):
    """Share of the height of the circle nearest to (x, y, z): 0 or 1 where that is an end, and whether it is one.

    Newton's steps from the place's own level, halving what is left where they lead out of it.
    """
    low, high = 0.0, 1.0
    share = min(max((z - shape[wall, START_Z]) / shape[wall, ALONG_Z], 0.0), 1.0)
    for _ in range(ROUNDS):
        first, second = slope(shape, wall, share, x, y, z)
        if first > 0.0:
            high = share
        else:
            low = share
        if high == 0.0 or low == 1.0:
            return low if high > 0.0 else high, True
        step = first / second if second > 0.0 else 1.0
        if abs(step) <= CLOSE:
            share -= step
            break
        new = share - step
        if low < new < high:
            share = new
        elif new <= low == 0.0:
            share = 0.0 if share > 0.0 else 0.5 * high
        elif new >= high == 1.0:
            share = 1.0 if share < 1.0 else 0.5 * (low + 1.0)
        else:
            share = 0.5 * (low + high)
    return share, False


@njit(**OPTIONS)
def nearest_eccentric(shape, wall, x, y, z):
    """Vector (m) from an eccentric cone's nearest point to (x, y, z), and the mean curvature there (1/m)."""
    share, end = nearest_level_of(shape, wall, x, y, z)
    if end and shape[wall, START_END if share == 0.0 else END_END] != 0.0:  # joined, or held by a gate
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH, 0.0
    ax, ay, off, radius = circle_to(shape, wall, share, x, y)
    high, bent = shape[wall, ALONG_Z], 0.0
    if not end and radius > 0.0:
        out = ax * shape[wall, LEAN_X] + ay * shape[wall, LEAN_Y] + shape[wall, ALONG_R]
        sideways = ax * shape[wall, LEAN_Y] - ay * shape[wall, LEAN_X]
        across = high * high + out * out
        bent = 0.5 * high * (across + sideways * sideways) / (radius * across * sqrt(across))
    away = off - radius
    return away * ax, away * ay, z - shape[wall, START_Z] - share * high, bent if away <= 0.0 else -bent


@njit(**OPTIONS)
def apart_from_eccentric(shape, wall, x, y, z):
    """Square of the distance (m2) of a point from an eccentric cone and both its ends."""
    share, _ = nearest_level_of(shape, wall, x, y, z)
    _, _, off, radius = circle_to(shape, wall, share, x, y)
    height = z - shape[wall, START_Z] - share * shape[wall, ALONG_Z]
    return (off - radius) * (off - radius) + height * height


@njit(**OPTIONS)
def eccentric_frame(shape, wall, x, y, z):
    """Place on an eccentric cone: share of its height, share of a turn about the circle's middle from x, and the unit vector
    upward along it."""
    high = shape[wall, ALONG_Z]
    share = (z - shape[wall, START_Z]) / high
    ax, ay, _, _ = circle_to(shape, wall, share, x, y)
    turn = atan2(ay, ax) / (2.0 * pi)
    ux, uy = shape[wall, LEAN_X] + shape[wall, ALONG_R] * ax, shape[wall, LEAN_Y] + shape[wall, ALONG_R] * ay
    length = sqrt(ux * ux + uy * uy + high * high)
    return share, turn if turn >= 0.0 else turn + 1.0, (ux / length, uy / length, high / length)


@njit(**OPTIONS)
def eccentric_normal(shape, wall, x, y, z):
    """Unit normal of an eccentric cone towards its inside, at a place on it."""
    high = shape[wall, ALONG_Z]
    ax, ay, _, _ = circle_to(shape, wall, (z - shape[wall, START_Z]) / high, x, y)
    out = ax * shape[wall, LEAN_X] + ay * shape[wall, LEAN_Y] + shape[wall, ALONG_R]
    length = sqrt(high * high + out * out)
    return -high * ax / length, -high * ay / length, out / length
