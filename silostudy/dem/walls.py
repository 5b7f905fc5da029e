"""Walls: straight pieces with two ends, which push a disc from their nearest point; an end pushes in any direction.

The edges L and R of Kiyama & Fujimura's slit are the inner ends of the two halves of the floor (1983, section 4).
"""

from math import hypot

import numpy as np
from numba import njit
from numba.extending import register_jitable

from silostudy.dem.arrays import Walls
from silostudy.dem.cache import OPTIONS
from silostudy.dem.drive import standing
from silostudy.dem.lanes import (
    DU,
    DV,
    DX,
    DY,
    FIRST_TORQUE,
    FORCE_X,
    FORCE_Y,
    FX,
    FY,
    SPIN_DIFFERENCE,
    SPIN_SUM,
    TORQUE,
    U,
    V,
    W,
    X,
    Y,
)

JOINED, OUT_OF_REACH = 1.0, 1e30
LOW, RISE = 1, 7  # columns of a shape: height of its start, speed of rise


@njit(**OPTIONS)
def nearest(shape, wall, x, y):
    """Vector (m) from the wall's nearest point to (x, y), and that point's distance (m) from the wall's start.

    Beyond an end that is joined to another wall there is nothing to touch: the vector is then out of any disc's reach.
    """
    dx, dy = x - shape[wall, 0], y - shape[wall, 1]
    along = dx * shape[wall, 2] + dy * shape[wall, 3]
    if (along < 0.0 and shape[wall, 5] == JOINED) or (along > shape[wall, 4] and shape[wall, 6] == JOINED):
        return OUT_OF_REACH, OUT_OF_REACH, along
    along = min(max(along, 0.0), shape[wall, 4])
    return dx - along * shape[wall, 2], dy - along * shape[wall, 3], along


@njit(**OPTIONS)
def square_apart(shape, wall, x, y):
    """Square of the distance (m2) of (x, y) from the wall and both its ends; joined ends count too.

    It changes by no more than a point moves, so that what comes over a joint was listed before.
    """
    dx, dy = x - shape[wall, 0], y - shape[wall, 1]
    along = min(max(dx * shape[wall, 2] + dy * shape[wall, 3], 0.0), shape[wall, 4])
    dx, dy = dx - along * shape[wall, 2], dy - along * shape[wall, 3]
    return dx * dx + dy * dy


@register_jitable
def gather_walls(rows, shape, disc, wall, start, count, lanes):
    """Lanes of discs near walls: the wall is at rest and does not turn."""
    for k in range(count):
        i = disc[start + k]
        dx, dy, _ = nearest(shape, wall[start + k], rows[i, X], rows[i, Y])
        lanes[DX, k], lanes[DY, k] = dx, dy
        lanes[DU, k], lanes[DV, k] = rows[i, U], rows[i, V]
        lanes[SPIN_SUM, k] = lanes[SPIN_DIFFERENCE, k] = rows[i, W]


@register_jitable
def gather_moving_walls(rows, shape, disc, wall, start, count, lanes):
    """Lanes of discs near walls, of which some rise."""
    gather_walls(rows, shape, disc, wall, start, count, lanes)
    for k in range(count):
        lanes[DV, k] -= shape[wall[start + k], RISE]


@register_jitable
def wall_power(rows, shape, i, wall, force, moment):
    """Power (W/m) that a wall which moves gives a disc that it pushes with a force (N/m)."""
    return force[1] * shape[wall, RISE]


@register_jitable
def height_of(shape, wall):
    """Height (m) of a level wall."""
    return shape[wall, LOW]


def motion_of(shape: np.ndarray) -> np.ndarray:
    """Of every wall (n, 2): height (m) of its start, speed upward (m/s)."""
    return shape[:, [LOW, RISE]].copy()


@register_jitable
def widen(shape, wall, dt):
    """Widen the holes of a wall that grow: none do."""
    return False


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
    """Note each wall contact's force: along the inner normal (pressing positive), along the wall (carrying positive)."""
    for k in range(count):
        i, q, at = near.first[start + k], near.second[start + k], start + k
        tx, ty, length = walls.shape[q, 2], walls.shape[q, 3], walls.shape[q, 4]
        _, _, along = nearest(walls.shape, q, rows[i, X], rows[i, Y])
        upward = -1.0 if ty < 0.0 else 1.0
        fx, fy = force[FORCE_X, k], force[FORCE_Y, k]
        record.force[part, at, 0] = fy * tx - fx * ty
        record.force[part, at, 1] = upward * (fx * tx + fy * ty)
        inner = walls.cells[q, 1]
        place = 0 if along <= 0.0 else inner + 1 if along >= length else 1 + min(int(along / length * inner), inner - 1)
        record.cell[part, at] = walls.cells[q, 0] + place


def walls_of(walls) -> Walls:
    """The walls as arrays."""
    return Walls(shape_of(walls), np.array([wall.live for wall in walls], bool), cells_of(walls), standing(len(walls)))


def shape_of(walls) -> np.ndarray:
    """Start, unit direction, length (m), the kinds of both ends and a speed of none, a row a wall."""
    rows = []
    for wall in walls:
        (x0, y0), (x1, y1) = wall.start, wall.end
        length = hypot(x1 - x0, y1 - y0)
        ends = [JOINED if joined else 0.0 for joined in wall.joined]
        rows.append([x0, y0, (x1 - x0) / length, (y1 - y0) / length, length, *ends, 0.0])
    return np.array(rows, float).reshape(-1, RISE + 1)


def wall_cells(model, name: str) -> np.ndarray:
    """Numbers of a wall's recorded cells: its start, its parts, its end."""
    first, inner = cells_of(model.walls)[model.wall_number(name)]
    return np.arange(first, first + inner + 2)


def sums_by_wall(model, cells: np.ndarray, axis: int = 0) -> dict[str, np.ndarray]:
    """Sums over each wall of what its cells hold, by the walls' names; `axis`: that of the cells."""
    sums = np.add.reduceat(cells, model.space.walls_of(model.walls).cells[:, 0], axis=axis)
    return {wall.name: sums.take(number, axis=axis) for number, wall in enumerate(model.walls)}


def cell_count(walls) -> int:
    """How many cells the walls have."""
    return sum(wall.cells + 2 for wall in walls)


def extents(walls) -> list[np.ndarray]:
    """Both ends (2, 2) of each wall, m."""
    return [np.array([wall.start, wall.end]) for wall in walls]


def beside(walls, places: np.ndarray) -> np.ndarray:
    """Which places (n, 2; m) are left of all walls, or right of them; none without walls."""
    ends = np.array([end[0] for wall in walls for end in (wall.start, wall.end)])
    return (
        (places[:, 0] < ends.min(initial=np.inf)) | (places[:, 0] > ends.max(initial=-np.inf))
        if len(ends)
        else np.zeros(len(places), bool)
    )


def cells_of(walls) -> np.ndarray:
    """First cell and number of inner cells of each wall; the two ends have a cell each, before and after the inner ones."""
    inner = np.array([wall.cells for wall in walls], np.int64)
    first = np.cumsum(inner + 2) - (inner + 2)
    return np.column_stack([first, inner]).reshape(-1, 2)
