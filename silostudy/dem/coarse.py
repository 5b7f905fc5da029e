"""Coarse-grained fields: density, velocity, stress of grains and force of walls in cells, which balance mass and momentum.

What a grain has is spread about its centre by Lucy's kernel; what a contact carries about its branch, from centre to centre or
from where a wall pushes to the centre; the force of a wall about where it pushes.  Cells hold averages of a sample: everything
is shared among points of equal weight, POINTS of the kernel times LINES along the branch.
Then sums over cells are those over grains and contacts; and where nothing is accelerated, density times gravity plus the walls'
force less the divergence of the stress is zero, as closely as cells and sample are fine.
Goldhirsch (2010); walls: Weinhart et al. (2012).
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from numba import njit
from numba.extending import register_jitable
from scipy.spatial.transform import Rotation

from silostudy.dem.cache import OPTIONS
from silostudy.dem.grid import Grid, cell_at, components
from silostudy.dem.snapshot import ContactForces, pair_contacts, wall_contacts

POINTS = 64  # of the sample that spreads what a grain has over the kernel; twice a power of two
LINES = 4  # points on a contact's branch that its force is spread along
KERNEL = "Lucy: (1 + 3 q) (1 - q)^3 up to q = 1, q the distance over twice the width"


class Instant(NamedTuple):
    """Grains and contacts of an instant, which fields are averaged from.

    Mass (kg/m, kg), volume (m2, m3), place (m) and velocity (m/s) of the grains; end (m) of every contact, branch from there to
    a grain's centre (m) and force on that grain (N/m, N); where walls push (m), and how much (N/m, N).
    """

    mass: np.ndarray
    volume: np.ndarray
    place: np.ndarray
    velocity: np.ndarray
    end: np.ndarray
    branch: np.ndarray
    force: np.ndarray
    wall_place: np.ndarray
    wall_force: np.ndarray


class Fields(NamedTuple):
    """Averages over cells.

    Density (kg/m3), solid fraction (1), velocity (m/s; NaN where nothing is), stresses (Pa), walls' force on grains (N/m3).
    Compression is positive; the first component is that of the branch, the second that of the force.
    """

    density: np.ndarray
    solid_fraction: np.ndarray
    velocity: np.ndarray
    contact_stress: np.ndarray
    kinetic_stress: np.ndarray
    wall_force: np.ndarray


def lucy(q: np.ndarray) -> np.ndarray:
    """Lucy's kernel (1) at a distance over its reach q (1), not normalised."""
    return np.where(q < 1.0, (1.0 + 3.0 * q) * (1.0 - q) ** 3, 0.0)


@cache
def sample(ways: int) -> np.ndarray:
    """Points (POINTS, 4): offset from the centre over the kernel's reach, in the plane of two components; share of a line.

    Each has its opposite, so that the centre of what is spread stays where it is.
    """
    from scipy.stats import qmc  # here: a start of a process takes a fifth longer with it

    uniform = qmc.Sobol(ways + 1, scramble=False).random(POINTS // 2) + 1.0 / POINTS
    table = np.linspace(0.0, 1.0, 2001)
    inner = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(table) * _pairs(lucy(table) * table ** (ways - 1)))])
    radius, turn = np.interp(uniform[:, 0] * inner[-1], inner, table), 2.0 * np.pi * uniform[:, 1]
    high = 2.0 * uniform[:, 2] - 1.0 if ways == 3 else np.zeros(len(turn))
    flat = np.sqrt(1.0 - high**2)
    offset = radius[:, None] * np.column_stack([flat * np.cos(turn), flat * np.sin(turn), high])
    share = uniform[:, -1:]
    return np.vstack([np.hstack([offset, share]), np.hstack([-offset, 1.0 - share])])


def _pairs(values: np.ndarray) -> np.ndarray:
    return values[1:] + values[:-1]


def fields_now(engine, grid: Grid, width: float) -> Fields:
    """Fields of the engine's grains now, by a kernel of a width (m)."""
    return fields(instant(engine), grid, width)


def instant(engine) -> Instant:
    """The engine's grains and contacts now."""
    rows, space, pairs, walls = engine.bodies.rows[: engine.n], engine.space, pair_contacts(engine), wall_contacts(engine)
    end, branch, force = branches(engine, pairs, walls)
    volume = engine.mass / np.broadcast_to(engine.model.density, engine.most)[engine.labels]
    moving = rows[:, space.place], rows[:, space.velocity]
    return Instant(engine.mass, volume, *moving, end, branch, force, walls.place, walls.force)


def branches(engine, pairs: ContactForces, walls: ContactForces) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """End (m) of every contact, branch from there to the first body's centre (m), and force on that body (N/m, N)."""
    place = engine.places
    end = np.vstack([place[pairs.second], walls.place])
    return end, place[np.concatenate([pairs.first, walls.first])] - end, np.vstack([pairs.force, walls.force])


def fields(now: Instant, grid: Grid, width: float) -> Fields:
    """Averages over cells of what is spread by a kernel of a width (m)."""
    volume, ways, reach = grid.volumes[:, None, None], now.place.shape[1], 2.0 * width
    lump, momentum, flow = spread(grid, reach, now.place, None, now.mass, now.velocity, now.velocity)
    solid, _, _ = spread(grid, reach, now.place, None, now.volume, now.velocity, now.velocity)
    _, _, stress = spread(grid, reach, now.end, now.branch, np.ones(len(now.end)), now.branch, now.force)
    _, push, _ = spread(grid, reach, now.wall_place, None, np.ones(len(now.wall_place)), now.wall_force, now.wall_force)
    there = lump[:, None] > 0.0
    mean = np.divide(momentum, lump[:, None], out=np.full_like(momentum, np.nan), where=there)
    kinetic = np.where(there[:, None], flow - momentum[:, :, None] * mean[:, None, :], 0.0) / volume
    sums = lump / volume[:, 0, 0], solid / volume[:, 0, 0], mean, stress / volume, kinetic, push / volume[:, 0]
    return Fields(*(values[(slice(None), *[slice(ways)] * (values.ndim - 1))] for values in sums))


def spread(
    grid: Grid,
    reach: float,
    start: np.ndarray,
    branch: np.ndarray | None,
    weight: np.ndarray,
    vector: np.ndarray,
    other: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Sums over cells of weights (cells), of them times a vector (cells, 3), times its dyads with another (cells, 3, 3).

    Shared along branches (m) and within a kernel's reach (m); the sample is turned and shifted at random for each that is
    spread: what lies in a row at a wall must not all miss the same.
    """
    total, (count, ways), random = np.zeros((grid.cells, 13)), start.shape, np.random.default_rng(0)
    solids = [_solid(np.zeros_like(start) if values is None else values) for values in (start, branch, vector, other)]
    turns, shifts = reach * rotations(random, count, ways), random.random(count)
    lines = 1 if branch is None else LINES
    share(*solids, weight, turns, shifts, sample(ways), lines, grid.shape, grid.round, total)
    return total[:, 0], total[:, 1:4], total[:, 4:].reshape(-1, 3, 3)


def _solid(vectors: np.ndarray) -> np.ndarray:
    """Vectors (n, d) as (n, 3)."""
    return np.pad(vectors, ((0, 0), (0, 3 - vectors.shape[1])))


def rotations(random: np.random.Generator, count: int, ways: int) -> np.ndarray:
    """Random rotations (count, 3, 3), in the plane about its normal."""
    if ways == 2:
        return Rotation.from_rotvec(np.outer(2.0 * np.pi * random.random(count), [0.0, 0.0, 1.0])).as_matrix().reshape(-1, 3, 3)
    quaternions = random.normal(size=(count, 4))
    return Rotation.from_quat(quaternions).as_matrix().reshape(-1, 3, 3) if count else np.empty((0, 3, 3))


@njit(**OPTIONS)
def share(start, branch, vector, other, weight, turns, shifts, points, lines, shape, round, total):
    """Add to each cell its share of all weights, of their products with the vector, and with its dyads with the other."""
    for i in range(len(start)):
        turn, part = turns[i], weight[i] / (len(points) * lines)
        first, second = (vector[i, 0], vector[i, 1], vector[i, 2]), (other[i, 0], other[i, 1], other[i, 2])
        for k in range(len(points)):
            dx, dy, dz = points[k, 0], points[k, 1], points[k, 2]
            x0 = start[i, 0] + turn[0, 0] * dx + turn[0, 1] * dy + turn[0, 2] * dz
            y0 = start[i, 1] + turn[1, 0] * dx + turn[1, 1] * dy + turn[1, 2] * dz
            z0 = start[i, 2] + turn[2, 0] * dx + turn[2, 1] * dy + turn[2, 2] * dz
            first_share = (points[k, 3] + shifts[i]) % 1.0
            for line in range(lines):
                along = (line + first_share) / lines
                x, y, z = x0 + along * branch[i, 0], y0 + along * branch[i, 1], z0 + along * branch[i, 2]
                cell = cell_at(shape, round, x, y, z)
                if cell >= 0:
                    add(total, cell, part, components(round, x, y, first), components(round, x, y, second))


@register_jitable
def add(total, cell, part, vector, other):
    """Add a part of a weight, of the vector and of its dyad with the other to a cell."""
    total[cell, 0] += part
    for a in range(3):
        total[cell, 1 + a] += part * vector[a]
        for b in range(3):
            total[cell, 4 + 3 * a + b] += part * vector[a] * other[b]
