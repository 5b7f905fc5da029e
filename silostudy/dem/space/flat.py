"""Flat pieces of a scene of spheres, and the sheets that they are: what of them is nearest to a point."""

import numpy as np
from numba import njit

from silostudy.dem.cache import OPTIONS
from silostudy.dem.space.rows import (
    ACROSS,
    BOX,
    COUNT,
    FRONT,
    JOINED,
    LAST,
    MEETS,
    MORE,
    NEXT,
    NORMAL,
    OUT_OF_REACH,
    PER_SIDE,
    SIDE,
    SIDE_WAY,
    UPWARD,
)

SURE = 1.0 - 1e-9  # of a square: what is farther by less may be the nearest but for rounding
NEAR = 1e-24  # m2: the same


@njit(**OPTIONS)
def piece_of(shape, wall, x, y, z):
    """Number of the piece nearest to a point, in a sheet that begins with this piece.

    Pieces and groups of them that are surely farther than others are passed over.
    """
    if shape[wall, NEXT] == 0.0:
        return wall
    nearer, piece, least, joined, most = wall, wall, np.inf, False, least_of_a_group(shape, wall, x, y, z)
    while True:
        if shape[piece, LAST] > 0.0 and SURE * apart_from_group(shape, piece, x, y, z) > most + NEAR:
            piece = int(shape[piece, LAST])
        elif SURE * apart_from_rectangle(shape, piece, x, y, z) <= most + NEAR:
            square, ends = apart_from(shape, piece, x, y, z)
            if square < least or (square == least and ends and not joined):
                nearer, least, joined, most = piece, square, ends, min(most, square)
        if shape[piece, NEXT] == 0.0:
            return nearer
        piece = int(shape[piece, NEXT])


@njit(**OPTIONS)
def least_of_a_group(shape, wall, x, y, z):
    """Square of the distance (m2) of a point from the pieces of a sheet's nearest group; endless where it has none."""
    if shape[wall, LAST] == 0.0:
        return np.inf
    group, head, most, least = wall, wall, np.inf, np.inf
    while group >= 0:
        square, last = apart_from_group(shape, group, x, y, z), int(shape[group, LAST])
        if square < most:
            head, most = group, square
        group = int(shape[last, NEXT]) if shape[last, NEXT] > 0.0 else -1
    piece, last = head, int(shape[head, LAST])
    while True:
        if apart_from_rectangle(shape, piece, x, y, z) < least:
            least = min(least, apart_from(shape, piece, x, y, z)[0])
        if piece == last:
            return least
        piece = int(shape[piece, NEXT])


@njit(**OPTIONS)
def apart_from_group(shape, piece, x, y, z):
    """Square of the distance (m2) of a point from the box around the group that begins with a piece."""
    dx = max(shape[piece, BOX] - x, x - shape[piece, BOX + 3], 0.0)
    dy = max(shape[piece, BOX + 1] - y, y - shape[piece, BOX + 4], 0.0)
    dz = max(shape[piece, BOX + 2] - z, z - shape[piece, BOX + 5], 0.0)
    return dx * dx + dy * dy + dz * dz


@njit(**OPTIONS)
def apart_from_rectangle(shape, wall, x, y, z):
    """Square of the distance (m2) of a point from the rectangle around a flat piece in its plane."""
    height = facing(shape, wall, x - shape[wall, MORE], y - shape[wall, MORE + 1], z - shape[wall, MORE + 2])
    across, upward = beside(shape, wall, ACROSS, x, y, z), beside(shape, wall, UPWARD, x, y, z)
    return height * height + across * across + upward * upward


@njit(**OPTIONS)
def beside(shape, wall, way, x, y, z):
    """Distance (m) by which a point is beyond the ends of a flat piece along one of its directions."""
    along = x * shape[wall, way] + y * shape[wall, way + 1] + z * shape[wall, way + 2] - shape[wall, way + 3]
    return max(-along, along - shape[wall, way + 4], 0.0)


@njit(**OPTIONS)
def apart_from(shape, wall, x, y, z):
    """Square of the distance (m2) of a point from a flat piece, and whether what is nearest is joined to another surface."""
    side, dx, dy, dz = side_of(shape, wall, x, y, z)
    return dx * dx + dy * dy + dz * dz, passes_on(shape, wall, side, dx, dy, dz)


@njit(**OPTIONS)
def passes_on(shape, wall, side, dx, dy, dz):
    """Whether what is nearest to a point, on a side of a flat piece, is another surface's to push from."""
    if side < 0:
        return False
    kind, way = shape[wall, MORE + PER_SIDE * side + SIDE], MORE + PER_SIDE * side + SIDE_WAY
    over = dx * shape[wall, way] + dy * shape[wall, way + 1] + dz * shape[wall, way + 2] >= 0.0
    return kind == JOINED or (kind == MEETS and over)


@njit(**OPTIONS)
def nearest_flat(shape, wall, x, y, z):
    """Vector (m) from a convex polygon's nearest point: in its plane where the point stands over it, else on a side."""
    side, dx, dy, dz = side_of(shape, wall, x, y, z)
    behind = shape[wall, FRONT] == 1.0 and facing(shape, wall, dx, dy, dz) < 0.0
    if behind or passes_on(shape, wall, side, dx, dy, dz):
        return OUT_OF_REACH, OUT_OF_REACH, OUT_OF_REACH
    return dx, dy, dz


@njit(**OPTIONS)
def side_of(shape, wall, x, y, z):
    """Number of a polygon's side that is nearest to a point, -1 where that stands over it, and the vector (m) from there.

    A corner of a joined side and another is the joined side's.
    """
    count, best, nearer, way = int(shape[wall, COUNT]), np.inf, -1, (0.0, 0.0, 0.0)
    nx, ny, nz = shape[wall, NORMAL], shape[wall, NORMAL + 1], shape[wall, NORMAL + 2]
    for k in range(count):
        a, b = MORE + PER_SIDE * k, MORE + PER_SIDE * ((k + 1) % count)
        sx, sy, sz = (
            shape[wall, b] - shape[wall, a],
            shape[wall, b + 1] - shape[wall, a + 1],
            shape[wall, b + 2] - shape[wall, a + 2],
        )
        px, py, pz = x - shape[wall, a], y - shape[wall, a + 1], z - shape[wall, a + 2]
        inward = nx * (sy * pz - sz * py) + ny * (sz * px - sx * pz) + nz * (sx * py - sy * px)
        if inward >= 0.0:
            continue
        share = min(max((px * sx + py * sy + pz * sz) / (sx * sx + sy * sy + sz * sz), 0.0), 1.0)
        dx, dy, dz = px - share * sx, py - share * sy, pz - share * sz
        if share == 1.0:  # to the bit as the next side says it, or one corner would have two distances
            dx, dy, dz = x - shape[wall, b], y - shape[wall, b + 1], z - shape[wall, b + 2]
        square = dx * dx + dy * dy + dz * dz
        if square < best or (square == best and shape[wall, a + SIDE] == JOINED):
            best, nearer, way = square, k, (dx, dy, dz)
    if nearer >= 0:
        return nearer, way[0], way[1], way[2]
    px, py, pz = x - shape[wall, MORE], y - shape[wall, MORE + 1], z - shape[wall, MORE + 2]
    height = px * nx + py * ny + pz * nz
    return nearer, height * nx, height * ny, height * nz


@njit(**OPTIONS)
def facing(shape, wall, dx, dy, dz):
    """Component (m) towards a flat piece's front of a vector from its nearest point."""
    return dx * shape[wall, NORMAL] + dy * shape[wall, NORMAL + 1] + dz * shape[wall, NORMAL + 2]
