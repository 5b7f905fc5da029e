"""Walls of space: surfaces of a straight line turned about an upright axis, eccentric cones, flat pieces, and level pieces with
holes; a sphere is pushed from their nearest point.

A turned line is a cylinder, a cone, a ring or a disc by where it stands; its ends are circles, which push in any direction
that they are touched from.  Flat pieces are convex polygons; those that meet in one plane are one sheet, which pushes a sphere
once and keeps its history over their joints.  A level piece is what lies inside an outline and outside its open holes, which
do not overlap: it pushes once too, from its plane or from the nearest point of a hole's rim.

Passages are smooth but for two: a joint of surfaces that differ by an angle t in direction, once a sphere is pressed in by more
than 1/cos(t) - 1 of its radius; and the corner of a rectangular hole, where the direction turns at once from one side's to the
other's at equal distances from both.
"""

from math import atan2, cos, floor, pi, sin, sqrt

import numpy as np
from numba import njit
from numba.extending import register_jitable

from silostudy.dem.cache import OPTIONS
from silostudy.dem.space.eccentric import apart_from_eccentric, nearest_eccentric
from silostudy.dem.space.flat import apart_from, nearest_flat, piece_of
from silostudy.dem.space.rows import (
    ALONG_R,
    ALONG_Z,
    AXIS_X,
    AXIS_Y,
    BELT,
    CIRCLE,
    ECCENTRIC,
    END_END,
    END_WAY,
    FLAT,
    FOLLOWS,
    HEIGHT,
    HOLES,
    JOINED,
    LENGTH,
    MEETS,
    MORE,
    OPEN,
    OUT_OF_REACH,
    OUTLINE,
    PER_HOLE,
    RECTANGLE,
    RIM,
    RISE,
    START_END,
    START_R,
    START_WAY,
    START_Z,
    TURN,
    TURNED,
)


@njit(**OPTIONS)
def nearest(shape, wall, x, y, z):
    """Vector (m) from the surface's nearest point to (x, y, z), and the surface's curvature there (1/m).

    The curvature is the mean of both directions, positive where the surface bends about the sphere as a cylinder does.
    Beyond an edge that is joined to another surface there is nothing to touch: the vector is then out of any reach.
    """
    if shape[wall, 0] == TURNED:
        return nearest_turned(shape, wall, x, y, z)
    if shape[wall, 0] == ECCENTRIC:
        return nearest_eccentric(shape, wall, x, y, z)
    if shape[wall, 0] == FLAT:
        dx, dy, dz = nearest_flat(shape, piece_of(shape, wall, x, y, z), x, y, z)
    else:
        dx, dy, dz = nearest_level(shape, wall, x, y, z)
    return dx, dy, dz, 0.0


@njit(**OPTIONS)
def square_apart(shape, wall, x, y, z):
    """Square of the distance (m2) of (x, y, z) from the surface and all its edges, or less; joined edges count too.

    It changes by no more than a point moves, so that what comes over a joint was listed before; endless of a piece that
    another stands for.
    """
    if shape[wall, 0] == TURNED:
        return apart_from_turned(shape, wall, x, y, z)
    if shape[wall, 0] == ECCENTRIC:
        return apart_from_eccentric(shape, wall, x, y, z)
    if shape[wall, 0] == FLAT:
        if shape[wall, FOLLOWS] == 1.0:
            return np.inf
        return apart_from(shape, piece_of(shape, wall, x, y, z), x, y, z)[0]
    height, beyond = z - shape[wall, HEIGHT], margin(shape, wall, OUTLINE, x, y)
    if beyond < 0.0:
        return height * height + beyond * beyond
    dx, dy, dz = nearest_level(shape, wall, x, y, z)
    return dx * dx + dy * dy + dz * dz


@njit(**OPTIONS)
def apart_from_turned(shape, wall, x, y, z):
    """Square of the distance (m2) of a point from a turned line and both its ends."""
    ax, ay = x - shape[wall, AXIS_X], y - shape[wall, AXIS_Y]
    dr, dz = sqrt(ax * ax + ay * ay) - shape[wall, START_R], z - shape[wall, START_Z]
    along = min(max(dr * shape[wall, ALONG_R] + dz * shape[wall, ALONG_Z], 0.0), shape[wall, LENGTH])
    dr, dz = dr - along * shape[wall, ALONG_R], dz - along * shape[wall, ALONG_Z]
    return dr * dr + dz * dz


@njit(**OPTIONS)
def nearest_turned(shape, wall, x, y, z):
    """Vector (m) from a turned line's nearest point, in the plane through its axis and the point, and curvature there (1/m)."""
    ax, ay = x - shape[wall, AXIS_X], y - shape[wall, AXIS_Y]
    off = sqrt(ax * ax + ay * ay)
    dr, dz = off - shape[wall, START_R], z - shape[wall, START_Z]
    along, length = dr * shape[wall, ALONG_R] + dz * shape[wall, ALONG_Z], shape[wall, LENGTH]
    inner, start = 0.0 <= along <= length, along < 0.0
    along = min(max(along, 0.0), length)
    dr, dz = dr - along * shape[wall, ALONG_R], dz - along * shape[wall, ALONG_Z]
    if not inner:
        kind, way = shape[wall, START_END if start else END_END], START_WAY if start else END_WAY
        if kind == JOINED or (kind == MEETS and dr * shape[wall, way] + dz * shape[wall, way + 1] >= 0.0):
            return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH, 0.0
    radius = shape[wall, START_R] + along * shape[wall, ALONG_R]
    if off > 0.0:
        ax, ay = ax / off, ay / off
    else:
        ax, ay = 1.0, 0.0  # on the axis every direction is as near
    bent = abs(shape[wall, ALONG_Z]) / (2.0 * radius) if inner and radius > 0.0 else 0.0
    return dr * ax, dr * ay, dz, bent if dr <= 0.0 else -bent


@njit(**OPTIONS)
def margin(shape, wall, outline, x, y):
    """Distance (m) of (x, y) inside an outline; negative outside of it, where it is no true distance for polygons."""
    sides, half = shape[wall, outline], shape[wall, outline + 3]
    x, y = x - shape[wall, outline + 1], y - shape[wall, outline + 2]
    if sides == CIRCLE:
        return half - sqrt(x * x + y * y)
    if sides == RECTANGLE:
        return min(half - abs(x), shape[wall, outline + 4] - abs(y))
    facing = side_facing(sides, x, y)
    return half - (x * cos(facing) + y * sin(facing))


@njit(**OPTIONS)
def nearest_level(shape, wall, x, y, z):
    """Vector (m) from a level piece's nearest point: on its plane, or on the rim of an open hole that the point stands over."""
    height = z - shape[wall, HEIGHT]
    if margin(shape, wall, OUTLINE, x, y) < 0.0:
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH
    for k in range(int(shape[wall, HOLES])):
        hole = MORE + PER_HOLE * k
        if shape[wall, hole + OPEN] == 1.0 and margin(shape, wall, hole + RIM, x, y) > 0.0:
            dx, dy = nearest_rim(shape, wall, hole + RIM, x, y)
            return dx, dy, height
    return 0.0, 0.0, height


@njit(**OPTIONS)
def nearest_rim(shape, wall, outline, x, y):
    """Level vector (m) from the nearest point of an outline to a point inside it."""
    inside, half = margin(shape, wall, outline, x, y), shape[wall, outline + 3]
    x, y = x - shape[wall, outline + 1], y - shape[wall, outline + 2]
    if shape[wall, outline] == RECTANGLE:
        if half - abs(x) == inside:
            return (-inside if x > 0.0 else inside), 0.0
        return 0.0, (-inside if y > 0.0 else inside)
    if shape[wall, outline] != CIRCLE:
        facing = side_facing(shape[wall, outline], x, y)
        return -inside * cos(facing), -inside * sin(facing)
    off = sqrt(x * x + y * y)
    if off > 0.0:
        return -inside * x / off, -inside * y / off
    return -inside, 0.0  # over the middle every direction is as near


@register_jitable
def side_facing(sides, x, y):
    """Direction (rad) in which the side of a regular polygon about the origin faces that is nearest to (x, y)."""
    part = 2.0 * pi / sides
    return part * floor(atan2(y, x) / part + 0.5)


@register_jitable
def height_of(shape, wall):
    """Height (m) of a level surface."""
    return shape[wall, START_Z if shape[wall, 0] == TURNED else HEIGHT]


@register_jitable
def lift(shape, wall, way):
    """Move a level surface up by a way (m)."""
    shape[wall, START_Z if shape[wall, 0] == TURNED else HEIGHT] += way


def run(shape: np.ndarray, walls: list[int], velocity: tuple[float, float, float]) -> None:
    """Let the faces of flat surfaces run along them at a velocity (m/s)."""
    shape[walls, BELT : BELT + 3] = velocity


def motion_of(shape: np.ndarray) -> np.ndarray:
    """Motion of every surface (n, 6).

    Height (m) where it is level, speed upward (m/s), spin about the upright axis (rad/s), velocity along itself (m/s).
    """
    along = [RISE, TURN, *range(BELT, BELT + 3)]
    return np.array([(height_of(shape, wall), *shape[wall, along]) for wall in range(len(shape))])
