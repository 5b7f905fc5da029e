"""Walls of space: surfaces of a straight line turned about an upright axis, flat pieces, level pieces and their rims; a sphere
is pushed from their nearest point.

A turned line is a cylinder, a cone, a ring or a disc by where it stands; its ends are circles, which push in any direction
that they are touched from.  Flat pieces are convex polygons of three or four corners.  A level piece is what lies inside an
outline and outside a hole; each side of a rectangular hole is a rim of its own, since a sphere may lie on two of them.

Passages are smooth but for two: a joint of surfaces that differ by an angle t in direction, once a sphere is pressed in by more
than 1/cos(t) - 1 of its radius; and a corner of a rectangular hole, where a sphere that comes from the level piece finds the
second rim at once if that is nearer than the radius of its contact.
"""

from math import atan2, cos, floor, pi, sin, sqrt

import numpy as np
from numba import njit

from silostudy.dem.cache import OPTIONS

TURNED, FLAT, LEVEL, RIM = 0.0, 1.0, 2.0, 3.0  # kinds of surface, in the first column of their shapes
JOINED, OUT_OF_REACH = 1.0, 1e30
AXIS_X, AXIS_Y, START_R, START_Z, ALONG_R, ALONG_Z, LENGTH, START_END, END_END = range(1, 10)  # columns of a turned line
COUNT, NORMAL, CORNERS, SIDES = 1, 2, 5, 17  # columns of a flat piece: corners, unit normal, their places, joined sides
ACROSS, UPWARD = 21, 26  # of a flat piece: unit vectors in its plane, each followed by its least coordinate and its length
HEIGHT, OUTLINE, HOLE = 1, 4, 9  # of a level piece: its height, then outlines of five numbers; of a rim: height, hole
WAY = 14  # of a rim: unit vector (x, y) from the hole's middle across it, and its distance from there
RISE, TURN = 31, 32  # of any surface: its speed upward (m/s), and its spin about the upright axis x = y = 0 (rad/s)
COLUMNS = 33
CIRCLE, RECTANGLE, NO_HOLE = 0.0, 4.0, -1.0  # numbers of sides of an outline; others are regular polygons, one side facing x


@njit(**OPTIONS)
def nearest(shape, wall, x, y, z):
    """Vector (m) from the surface's nearest point to (x, y, z), and the surface's curvature there (1/m).

    The curvature is the mean of both directions, positive where the surface bends about the sphere as a cylinder does.
    Beyond an edge that is joined to another surface there is nothing to touch: the vector is then out of any reach.
    """
    if shape[wall, 0] == TURNED:
        return nearest_turned(shape, wall, x, y, z)
    if shape[wall, 0] == FLAT:
        dx, dy, dz = nearest_flat(shape, wall, x, y, z)
    elif shape[wall, 0] == LEVEL:
        dx, dy, dz = nearest_level(shape, wall, x, y, z)
    else:
        dx, dy, dz = nearest_rim(shape, wall, x, y, z)
    return dx, dy, dz, 0.0


@njit(**OPTIONS)
def nearest_turned(shape, wall, x, y, z):
    """Of a turned line: the plane through the axis and the point holds the nearest point."""
    ax, ay = x - shape[wall, AXIS_X], y - shape[wall, AXIS_Y]
    off = sqrt(ax * ax + ay * ay)
    dr, dz = off - shape[wall, START_R], z - shape[wall, START_Z]
    along, length = dr * shape[wall, ALONG_R] + dz * shape[wall, ALONG_Z], shape[wall, LENGTH]
    if (along < 0.0 and shape[wall, START_END] == JOINED) or (along > length and shape[wall, END_END] == JOINED):
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH, 0.0
    inner = 0.0 <= along <= length
    along = min(max(along, 0.0), length)
    dr, dz = dr - along * shape[wall, ALONG_R], dz - along * shape[wall, ALONG_Z]
    radius = shape[wall, START_R] + along * shape[wall, ALONG_R]
    if off > 0.0:
        ax, ay = ax / off, ay / off
    else:
        ax, ay = 1.0, 0.0  # on the axis every direction is as near
    bent = abs(shape[wall, ALONG_Z]) / (2.0 * radius) if inner and radius > 0.0 else 0.0
    return dr * ax, dr * ay, dz, bent if dr <= 0.0 else -bent


@njit(**OPTIONS)
def nearest_flat(shape, wall, x, y, z):
    """Of a convex polygon: its plane where the point stands over it, else the nearest of its sides.

    A corner of a joined side and another is the joined side's: it does not push.
    """
    count, best, found = int(shape[wall, COUNT]), np.inf, (OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH)
    nx, ny, nz = shape[wall, NORMAL], shape[wall, NORMAL + 1], shape[wall, NORMAL + 2]
    over = True
    for k in range(count):
        a, b = CORNERS + 3 * k, CORNERS + 3 * ((k + 1) % count)
        sx, sy, sz = (
            shape[wall, b] - shape[wall, a],
            shape[wall, b + 1] - shape[wall, a + 1],
            shape[wall, b + 2] - shape[wall, a + 2],
        )
        px, py, pz = x - shape[wall, a], y - shape[wall, a + 1], z - shape[wall, a + 2]
        inward = nx * (sy * pz - sz * py) + ny * (sz * px - sx * pz) + nz * (sx * py - sy * px)
        if inward >= 0.0:
            continue
        over = False
        share = min(max((px * sx + py * sy + pz * sz) / (sx * sx + sy * sy + sz * sz), 0.0), 1.0)
        dx, dy, dz = px - share * sx, py - share * sy, pz - share * sz
        if share == 1.0:  # to the bit as the next side says it, or one corner would have two distances
            dx, dy, dz = x - shape[wall, b], y - shape[wall, b + 1], z - shape[wall, b + 2]
        square, joined = dx * dx + dy * dy + dz * dz, shape[wall, SIDES + k] == JOINED
        if square < best or (square == best and joined):
            best = square
            found = (OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH) if joined else (dx, dy, dz)
    if over:
        px, py, pz = x - shape[wall, CORNERS], y - shape[wall, CORNERS + 1], z - shape[wall, CORNERS + 2]
        height = px * nx + py * ny + pz * nz
        return height * nx, height * ny, height * nz
    return found


@njit(**OPTIONS)
def margin(shape, wall, outline, x, y):
    """How far (m) inside an outline (x, y) stands; negative outside of it, where it is no distance for polygons."""
    sides, half = shape[wall, outline], shape[wall, outline + 3]
    x, y = x - shape[wall, outline + 1], y - shape[wall, outline + 2]
    if sides == CIRCLE:
        return half - sqrt(x * x + y * y)
    if sides == RECTANGLE:
        return min(half - abs(x), shape[wall, outline + 4] - abs(y))
    part = 2.0 * pi / sides
    facing = part * floor(atan2(y, x) / part + 0.5)
    return half - (x * cos(facing) + y * sin(facing))


@njit(**OPTIONS)
def nearest_level(shape, wall, x, y, z):
    """Of a level piece, whose outline is joined: its plane, or the circle of its hole where the point stands over that.

    The sides of a rectangular hole are rims.
    """
    height = z - shape[wall, HEIGHT]
    if margin(shape, wall, OUTLINE, x, y) < 0.0:
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH
    inside = margin(shape, wall, HOLE, x, y) if shape[wall, HOLE] != NO_HOLE else 0.0
    if inside <= 0.0:
        return 0.0, 0.0, height
    if shape[wall, HOLE] != CIRCLE:
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH
    x, y = x - shape[wall, HOLE + 1], y - shape[wall, HOLE + 2]
    off = sqrt(x * x + y * y)
    if off > 0.0:
        return -inside * x / off, -inside * y / off, height
    return -inside, 0.0, height  # over the middle every direction is as near


@njit(**OPTIONS)
def nearest_rim(shape, wall, x, y, z):
    """Of a rim: its line, for points over the hole; others stand over the level piece about it."""
    if margin(shape, wall, HOLE, x, y) <= 0.0:
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH
    across, along = shape[wall, WAY], shape[wall, WAY + 1]
    off = (x - shape[wall, HOLE + 1]) * across + (y - shape[wall, HOLE + 2]) * along - shape[wall, WAY + 2]
    return off * across, off * along, z - shape[wall, HEIGHT]


@njit(**OPTIONS)
def height_of(shape, wall):
    """Height (m) of a level surface."""
    return shape[wall, START_Z if shape[wall, 0] == TURNED else HEIGHT]


@njit(**OPTIONS)
def lift(shape, wall, way):
    """Move a level surface up by a way (m)."""
    shape[wall, START_Z if shape[wall, 0] == TURNED else HEIGHT] += way


def motion_of(shape: np.ndarray) -> np.ndarray:
    """Of every surface (n, 3): height (m) where it is level, speed upward (m/s), spin about the upright axis (rad/s)."""
    return np.array([(height_of(shape, wall), *shape[wall, [RISE, TURN]]) for wall in range(len(shape))])
