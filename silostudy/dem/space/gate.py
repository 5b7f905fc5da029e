"""Outlets that open at a speed: their holes grow, and in the gate of a hopper one comes to the edges of the hopper's surfaces.

One edge pushes there: the gate's rim as long as it stands, from then on those edges.
"""

from numba import njit
from numba.extending import register_jitable

from silostudy.dem.cache import OPTIONS
from silostudy.dem.space.rows import (
    AXIS_X,
    AXIS_Y,
    CIRCLE,
    COUNT,
    ECCENTRIC,
    FLAT,
    FULL,
    GROWTH,
    HEIGHT,
    HOLES,
    LEVEL,
    MEETS,
    MORE,
    OUTLINE,
    PER_HOLE,
    PER_SIDE,
    RECTANGLE,
    RIM,
    SIDE,
    SIDE_WAY,
    START_END,
    START_R,
    START_WAY,
    START_Z,
    TURNED,
)
from silostudy.dem.space.surfaces import margin

NEAR = 1e-9  # of an outline's half width: an edge so near to it runs along it


@register_jitable
def widen(shape, wall, dt):
    """Widen the holes of a level piece that grow, by a step (s); whether one has taken the whole piece away.

    The piece recedes and stands still: it drags nothing with it, and what has not touched it does not come to.
    """
    if shape[wall, 0] != LEVEL:
        return False
    gone = False
    for k in range(int(shape[wall, HOLES])):
        hole = MORE + PER_HOLE * k
        if shape[wall, hole + GROWTH] > 0.0:
            before, full = shape[wall, hole + RIM + 3], shape[wall, hole + FULL]
            half, gate = min(before + shape[wall, hole + GROWTH] * dt, full), full == shape[wall, OUTLINE + 3]
            shape[wall, hole + RIM + 3] = half
            if half == full:
                shape[wall, hole + GROWTH] = 0.0
                gone = gone or gate
            if gate and (before == 0.0 or half == full):
                hold_edges(shape, wall, half < full)
    return gone


@njit(**OPTIONS)
def hold_edges(shape, gate, held):
    """Let free edges that a gate's rim comes to push no more, or those that were held so push again.

    A held edge meets a surface that is on all sides of it.
    """
    for q in range(shape.shape[0]):
        if shape[q, 0] in (TURNED, ECCENTRIC) and rings(shape, gate, q):
            hold_edge(shape, q, START_END, START_WAY, 2, held)
        elif shape[q, 0] == FLAT:
            for k in range(int(shape[q, COUNT])):
                if borders(shape, gate, q, k):
                    side = MORE + PER_SIDE * k
                    hold_edge(shape, q, side + SIDE, side + SIDE_WAY, 3, held)


@njit(**OPTIONS)
def hold_edge(shape, wall, kind, way, ways, held):
    """Let one edge push no more, or again; one that is joined to another surface, or meets one, stays what it is."""
    for k in range(ways):
        if shape[wall, way + k] != 0.0:
            return
    if shape[wall, kind] == (0.0 if held else MEETS):
        shape[wall, kind] = MEETS if held else 0.0


@njit(**OPTIONS)
def rings(shape, gate, wall):
    """Whether a turned line or an eccentric cone starts at a gate's rim as it will be."""
    middle = shape[wall, AXIS_X] == shape[gate, OUTLINE + 1] and shape[wall, AXIS_Y] == shape[gate, OUTLINE + 2]
    along = shape[wall, START_R] == shape[gate, OUTLINE + 3] and shape[wall, START_Z] == shape[gate, HEIGHT]
    return shape[gate, OUTLINE] == CIRCLE and middle and along


@njit(**OPTIONS)
def borders(shape, gate, wall, k):
    """Whether a side of a flat piece runs along a gate's rim as it will be; that of a rectangle moves along x alone."""
    here, there, half = MORE + PER_SIDE * k, MORE + PER_SIDE * ((k + 1) % int(shape[wall, COUNT])), shape[gate, OUTLINE + 3]
    if shape[wall, here + 2] != shape[gate, HEIGHT] or shape[wall, there + 2] != shape[gate, HEIGHT]:
        return False
    x, y = 0.5 * (shape[wall, here] + shape[wall, there]), 0.5 * (shape[wall, here + 1] + shape[wall, there + 1])
    if abs(margin(shape, gate, OUTLINE, x, y)) > NEAR * half:
        return False
    return shape[gate, OUTLINE] != RECTANGLE or abs(abs(x - shape[gate, OUTLINE + 1]) - half) <= NEAR * half
