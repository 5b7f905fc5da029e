"""Walls: straight pieces with two ends, which push a disc from their nearest point; an end pushes in any direction.

The edges L and R of Kiyama & Fujimura's slit are the inner ends of the two halves of the floor (1983, section 4).
"""

from math import hypot, sqrt
from typing import Any

import numpy as np
from numba import njit
from numba.extending import register_jitable

from silostudy.dem.arrays import Walls
from silostudy.dem.cache import OPTIONS
from silostudy.dem.drive import standing
from silostudy.dem.joints import END, ENDS, FREE, JOINED, MEETS, REACH, RISE, SHUT, START, WAYS, join
from silostudy.dem.lanes import (
    DISTANCE,
    DU,
    DV,
    FIRST_TORQUE,
    FORCE_X,
    FORCE_Y,
    FX,
    FY,
    NORMAL_X,
    NORMAL_Y,
    SPIN_DIFFERENCE,
    SPIN_SUM,
    TORQUE,
    U,
    V,
    W,
    X,
    Y,
)

OUT_OF_REACH = 1e30  # m: component of a vector to what does not push
# columns of a shape
LOW = 1  # height of its line's start (m)
# columns of a wall that reaches beyond its own ends where outlets are shut
OWN = 13  # where it starts and ends itself, as it stands (m)
GROWTH = 15  # how fast it is drawn back to there (m/s)
OPENED = 17  # kinds of the ends once it is
BELT = 19  # speed (m/s) at which its face runs along it, as a belt's: it stays where it is


@register_jitable
def meets_before(shape, wall, end, dx, dy):
    """Whether a place, (dx, dy) m off an end that meets another wall, is beside that wall rather than beyond its end."""
    way = WAYS + 2 * end
    return shape[wall, ENDS + end] == MEETS and dx * shape[wall, way] + dy * shape[wall, way + 1] >= 0.0


@register_jitable
def ends_straight(shape, wall, dx, dy):
    """Whether a place, (dx, dy) m off the end of a wall that meets another there, is beside it, or that goes straight on."""
    return shape[wall, ENDS + END] == SHUT or meets_before(shape, wall, END, dx, dy)


@njit(**OPTIONS)
def nearest(shape, wall, x, y):
    """Vector (m) from the wall's nearest point to (x, y), and that point's distance (m) from the start of the wall's line.

    Beyond an end that is joined to another wall there is nothing to touch: the vector is then out of any disc's reach.
    Where two walls meet, one has the point for both: it pushes those alone that are beyond the ends of both.  Pieces of a floor
    have one line: what pushes has the same bits wherever shut outlets part them.
    """
    dx, dy, begin, end = x - shape[wall, 0], y - shape[wall, 1], shape[wall, REACH + START], shape[wall, REACH + END]
    along = dx * shape[wall, 2] + dy * shape[wall, 3]
    if along <= begin:
        dx, dy = dx - begin * shape[wall, 2], dy - begin * shape[wall, 3]
        if (along < begin and shape[wall, ENDS + START] == JOINED) or meets_before(shape, wall, START, dx, dy):
            return OUT_OF_REACH, OUT_OF_REACH, along
        return dx, dy, begin
    if along >= end:
        dx, dy = dx - end * shape[wall, 2], dy - end * shape[wall, 3]
        if (along > end and shape[wall, ENDS + END] == JOINED) or ends_straight(shape, wall, dx, dy):
            return OUT_OF_REACH, OUT_OF_REACH, along
        return dx, dy, end
    return dx - along * shape[wall, 2], dy - along * shape[wall, 3], along


@njit(**OPTIONS)
def square_apart(shape, wall, x, y):
    """Square of the distance (m2) of (x, y) from the wall and both its ends; joined ends count too.

    It changes by no more than a point moves, so that what comes over a joint was listed before.
    """
    dx, dy = x - shape[wall, 0], y - shape[wall, 1]
    along = min(max(dx * shape[wall, 2] + dy * shape[wall, 3], shape[wall, REACH + START]), shape[wall, REACH + END])
    dx, dy = dx - along * shape[wall, 2], dy - along * shape[wall, 3]
    return dx * dx + dy * dy


@register_jitable
def seam_before(shape, wall):
    """Whether a wall begins at a seam: where it goes straight on from the wall before it."""
    return wall > 0 and shape[wall - 1, ENDS + END] == SHUT


@register_jitable
def is_beyond(shape, wall, x, y):
    """Whether (x, y) is beyond the start of a wall, which then pushes there in place of the one that it goes on from."""
    along = (x - shape[wall, 0]) * shape[wall, 2] + (y - shape[wall, 1]) * shape[wall, 3]
    return along >= shape[wall, REACH + START]


@register_jitable
def gather_walls(rows, shape, disc, wall, start, count, lanes):
    """Lanes of discs near walls: the wall is at rest and does not turn."""
    for k in range(count):
        i = disc[start + k]
        dx, dy, _ = nearest(shape, wall[start + k], rows[i, X], rows[i, Y])
        distance = sqrt(dx * dx + dy * dy)
        inverse = 1.0 / distance
        lanes[NORMAL_X, k], lanes[NORMAL_Y, k], lanes[DISTANCE, k] = dx * inverse, dy * inverse, distance
        lanes[DU, k], lanes[DV, k] = rows[i, U], rows[i, V]
        lanes[SPIN_SUM, k] = lanes[SPIN_DIFFERENCE, k] = rows[i, W]


@register_jitable
def belt_at(shape, wall, normal_x, normal_y):
    """Velocity (m/s) of a wall's face along itself at a contact of this normal: an end, which faces along, stands still."""
    along = shape[wall, 2] * normal_x + shape[wall, 3] * normal_y
    return shape[wall, BELT] * (shape[wall, 2] - along * normal_x), shape[wall, BELT] * (shape[wall, 3] - along * normal_y)


@register_jitable
def gather_moving_walls(rows, shape, disc, wall, start, count, lanes):
    """Lanes of discs near walls, of which some rise, or run along themselves."""
    gather_walls(rows, shape, disc, wall, start, count, lanes)
    for k in range(count):
        q = wall[start + k]
        u, v = belt_at(shape, q, lanes[NORMAL_X, k], lanes[NORMAL_Y, k])
        lanes[DU, k] -= u
        lanes[DV, k] -= shape[q, RISE] + v


@register_jitable
def wall_power(rows, shape, i, wall, force, moment):
    """Power (W/m) that a wall which moves gives a disc that it pushes with a force (N/m)."""
    dx, dy, _ = nearest(shape, wall, rows[i, X], rows[i, Y])
    distance = sqrt(dx * dx + dy * dy)
    u, v = belt_at(shape, wall, dx / distance, dy / distance)
    return force[1] * shape[wall, RISE] + force[0] * u + force[1] * v


@register_jitable
def height_of(shape, wall):
    """Height (m) of a level wall."""
    return shape[wall, LOW]


def run(shape: np.ndarray, walls: list[int], speed: float) -> None:
    """Let the faces of walls run along them at a speed (m/s), with the solid on their left: counter-clockwise around it."""
    shape[walls, BELT] = speed


def motion_of(shape: np.ndarray) -> np.ndarray:
    """Motion of every wall (n, 3): height (m) of its start, speed upward (m/s), speed along itself (m/s)."""
    return shape[:, [LOW, RISE, BELT]].copy()


@register_jitable
def widen(shape, wall, dt):
    """Draw a wall back from outlets that open at a speed; it never goes."""
    for end in (START, END):
        if shape[wall, GROWTH + end] > 0.0:
            draw_back(shape, wall, end, shape[wall, GROWTH + end] * dt)
    return False


@register_jitable
def draw_back(shape, wall, end, way):
    """Draw a wall that reaches beyond its own end back by a way (m), at most to there."""
    now, own = shape[wall, REACH + end], shape[wall, OWN + end]
    shape[wall, REACH + end] = min(now + way, own) if end == START else max(now - way, own)
    shape[wall, ENDS + end] = FREE
    if shape[wall, REACH + end] == own:
        shape[wall, ENDS + end], shape[wall, GROWTH + end] = shape[wall, OPENED + end], 0.0


@register_jitable
def lift(shape, wall, way):
    """Move a wall up by a way (m)."""
    shape[wall, LOW] += way


@register_jitable
def scatter_walls(rows, disc, start, count, force):
    """Add the walls' forces to their discs, before the forces of all other discs."""
    for k in range(count):
        i = disc[start + k]
        rows[i, FX] += force[FORCE_X, k]
        rows[i, FY] += force[FORCE_Y, k]
        rows[i, TORQUE] += force[FIRST_TORQUE, k]


@register_jitable
def note_walls(rows, walls, near, start, count, force, record, part):
    """Note each wall contact's force: along the inner normal (pressing positive), along the wall (carrying positive).

    The back of a line has a normal and cells of its own.
    """
    for k in range(count):
        i, q, slot = near.first[start + k], near.second[start + k], start + k
        tx, ty, own = walls.shape[q, 2], walls.shape[q, 3], walls.shape[q, OWN + START]
        dx, dy, along = nearest(walls.shape, q, rows[i, X], rows[i, Y])
        along, length = along - own, walls.shape[q, OWN + END] - own
        upward = -1.0 if ty < 0.0 else 1.0
        fx, fy = force[FORCE_X, k], force[FORCE_Y, k]
        inner, back = walls.cells[q, 1], walls.cells[q, 2]
        behind = back > 0 and dy * tx - dx * ty < 0.0
        record.force[part, slot, 0] = fx * ty - fy * tx if behind else fy * tx - fx * ty
        record.force[part, slot, 1] = upward * (fx * tx + fy * ty)
        place = 0 if along <= 0.0 else inner + 1 if along >= length else 1 + min(int(along / length * inner), inner - 1)
        record.cell[part, slot] = walls.cells[q, 0] + place + (back if behind else 0)


def walls_of(walls) -> Walls:
    """The walls as arrays."""
    return Walls(shape_of(walls), np.array([wall.live for wall in walls], bool), cells_of(walls), standing(len(walls)))


def shape_of(walls) -> np.ndarray:
    """Start of its line, direction, reach (m), kinds of both ends, no speed, what the ends meet, own reach: a row a wall."""
    rows = np.zeros((len(walls), BELT + 1))
    for row, wall in zip(rows, walls, strict=True):
        (x0, y0), (x1, y1) = wall.start, wall.end
        length = hypot(x1 - x0, y1 - y0)
        row[: ENDS + 2] = (
            x0, y0, (x1 - x0) / length, (y1 - y0) / length, 0.0, length, *(JOINED if joined else FREE for joined in wall.joined)
        )  # fmt: skip
    join(rows, walls)
    rows[:, OPENED : OPENED + 2], rows[:, OWN : OWN + 2] = rows[:, ENDS : ENDS + 2], rows[:, REACH : REACH + 2]
    for row, wall in zip(rows, walls, strict=True):
        if wall.floor is not None:
            reach(row, wall)
    return rows


def reach(row: np.ndarray, wall) -> None:
    """Let a piece of a floor stand on the floor's line, and reach to the seams where it goes straight on in others."""
    floor = wall.floor
    row[:2], row[REACH : REACH + 2] = floor.origin, floor.seams
    row[OWN : OWN + 2] = [hypot(x - floor.origin[0], y - floor.origin[1]) for x, y in (wall.start, wall.end)]
    for end, kind in ((START, JOINED), (END, SHUT)):
        if floor.outlets[end]:
            row[ENDS + end] = kind


def wall_cells(model, name: str) -> np.ndarray:
    """Numbers of a wall's recorded cells: its start, its parts, its end; of its front where it has two faces."""
    first, inner, _ = cells_of(model.walls)[model.wall_number(name)]
    return np.arange(first, first + inner + 2)


def sums_by_wall(model, cells: np.ndarray, axis: int = 0) -> dict[str, np.ndarray]:
    """Sums over each wall, of all its faces, of what its cells hold, by the walls' names; `axis`: that of the cells."""
    sums = np.add.reduceat(cells, model.space.walls_of(model.walls).cells[:, 0], axis=axis)
    return {wall.name: sums.take(number, axis=axis) for number, wall in enumerate(model.walls)}


def faces(walls) -> list[tuple[str, Any]]:
    """Name and wall of each face that has cells of its own, in their order: the wall's name, or that and `_back`."""
    return [(f"{wall.name}_back" if back else wall.name, wall) for wall in walls for back in range(wall.faces)]


def cell_count(walls) -> int:
    """Number of cells of the walls."""
    return sum(wall.faces * (wall.cells + 2) for wall in walls)


def extents(walls) -> list[np.ndarray]:
    """Both ends (2, 2) of each wall, m."""
    return [np.array([wall.start, wall.end]) for wall in walls]


def beside(walls, places: np.ndarray) -> np.ndarray:
    """Mask of places (n, 2; m) that are left of all walls, or right of them; none without walls."""
    ends = np.array([end[0] for wall in walls for end in (wall.start, wall.end)])
    return (
        (places[:, 0] < ends.min(initial=np.inf)) | (places[:, 0] > ends.max(initial=-np.inf))
        if len(ends)
        else np.zeros(len(places), bool)
    )


def cells_of(walls) -> np.ndarray:
    """First cell, inner cells, and how many cells before those of its back, of each wall; 0: its back has none.

    The two ends have a cell each, before and after the inner ones.
    """
    inner, faces = np.array([(wall.cells, wall.faces) for wall in walls], np.int64).reshape(-1, 2).T
    total = faces * (inner + 2)
    return np.column_stack([np.cumsum(total) - total, inner, (inner + 2) * (faces > 1)]).reshape(-1, 3)
