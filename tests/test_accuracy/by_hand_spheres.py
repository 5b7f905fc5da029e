"""A kernel for equal spheres without friction, written out by hand: what the built one must not cost more.

It knows nothing of friction, histories, rolling, twisting, cohesion, several sizes or kinds, recorded or moving walls.
"""

from functools import cache
from math import sqrt

import numpy as np

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.prices import still, without
from silostudy.dem.arrays import BLOCK
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.space.felt import gather_walls, scatter_walls
from silostudy.dem.space.lanes import (
    CURVED,
    DU,
    DV,
    DW,
    FIRST_X,
    FIRST_Z,
    FORCE_X,
    FORCE_Y,
    FORCE_Z,
    FX,
    FY,
    FZ,
    PASSED,
    STRETCH,
    TX,
    TY,
    TZ,
    U,
    V,
    W,
    X,
    Y,
    Z,
    gather_rolling,
    scatter_rolling,
)  # fmt: skip
from silostudy.dem.space.motion import face, faced
from silostudy.dem.sweep import FRESH, STALE
from silostudy.dem.vectors import fetch_rows
from tests.test_accuracy.by_hand import inlined, marched

STEPS = 300


@inlined
def push(lanes, out, a, b, m, count, dt, c, flat):
    """Hertz's force and a dashpot that may pull."""
    face(lanes, count)
    for k in range(count):
        (nx, ny, nz), distance = faced(lanes, k)
        overlap = a + b - distance
        depth = overlap if overlap > 0.0 else 0.0
        radius = a / (1.0 - a * lanes[0, CURVED * STRETCH + k]) if flat else a * b / (a + b)
        closing = -(lanes[0, DU * STRETCH + k] * nx + lanes[0, DV * STRETCH + k] * ny + lanes[0, DW * STRETCH + k] * nz)
        wide = np.sqrt(radius * depth)
        total = c[0][0] * wide * depth + c[0][1] * np.sqrt(m * wide) * closing
        total = total if overlap > 0.0 else 0.0
        out[0, FORCE_X * STRETCH + k], out[0, FORCE_Y * STRETCH + k] = total * nx, total * ny
        out[0, FORCE_Z * STRETCH + k] = total * nz
        for lane in range(FIRST_X, FIRST_Z + 1):
            out[0, lane * STRETCH + k] = 0.0


@inlined
def pairs_of(rows, pairs, begin, end, scratch, dt, c):
    for start in range(begin, end, STRETCH):
        count = min(end - start, STRETCH)
        gather_rolling(rows, pairs.first, pairs.second, start, count, scratch.lanes)
        push(scratch.lanes, scratch.force, pairs.arm[0], pairs.other[0], pairs.mass[0], count, dt, c, False)
        scatter_rolling(rows, pairs.first, pairs.second, start, count, scratch.force)


@inlined
def walls_of(rows, near, walls, end, scratch, dt, c):
    for start in range(0, end, STRETCH):
        count = min(end - start, STRETCH)
        gather_walls(rows, walls.shape, near.first, near.second, start, count, scratch.lanes)
        push(scratch.lanes, scratch.force, near.arm[0], near.other[0], near.mass[0], count, dt, c, True)
        scatter_walls(rows, near.first, start, count, scratch.force)


@inlined
def moved(rows, begin, end, im, gravity, dt, motion, motion_bits):
    for i in range(begin, end):
        u = rows[i, U] + (rows[i, FX] * im + gravity[0]) * dt
        v = rows[i, V] + (rows[i, FY] * im + gravity[1]) * dt
        w = rows[i, W] + (rows[i, FZ] * im + gravity[2]) * dt
        dx, dy, dz = u * dt, v * dt, w * dt
        rows[i, X] += dx
        rows[i, Y] += dy
        rows[i, Z] += dz
        rows[i, U], rows[i, V], rows[i, W] = u, v, w
        rows[i, PASSED] += 1.0 if rows[i, Z] < 0.0 else 0.0
        rows[i, FX] = rows[i, FY] = rows[i, FZ] = rows[i, TX] = rows[i, TY] = rows[i, TZ] = 0.0
        motion[i - begin] = dx * dx + dy * dy + dz * dz
    most = np.uint64(0)
    for k in range(end - begin):
        most = motion_bits[k] if motion_bits[k] > most else most
    motion_bits[0] = most
    return sqrt(motion[0])


@inlined
def one_step(spheres, pairs, near, walls, blocks, scratch, laws, hi, gravity, dt):
    last, stale = (hi + BLOCK - 1) // BLOCK, FRESH
    walls_of(spheres.rows, near, walls, near.begin[0], scratch, dt, laws[1])
    pairs_of(spheres.rows, pairs, pairs.begin[last], pairs.begin[last + 1], scratch, dt, laws[0])
    for b in range(last):
        fetch_rows(spheres.rows, pairs.beyond[min(b + 1, last)], pairs.beyond[min(b + 2, last)])
        pairs_of(spheres.rows, pairs, pairs.begin[b], pairs.begin[b + 1], scratch, dt, laws[0])
        start = b * BLOCK
        end = min(start + BLOCK, hi)
        way = moved(spheres.rows, start, end, spheres.inverse_mass[0], gravity, dt, scratch.motion, scratch.motion_bits)
        blocks.peak[b] = way
        blocks.travel[b] += way
        if blocks.travel[b] > blocks.skin[b]:
            stale = STALE
    return stale


@cache
def kernel_by_hand():
    """The kernel of these steps."""
    return marched(one_step)


def smooth_spheres(count: int = 2000) -> Model:
    """A bin of spheres without friction, history and rotation."""
    return without(bin_of_spheres(Bin(count=count, wide=0.03)))["friction, rotation, history"][1]


def engines(model: Model) -> dict[str, Engine]:
    """The built kernel and the one by hand on the same model."""
    both = {"built": Engine(model), "by hand": Engine(model)}
    both["by hand"]._kernel = kernel_by_hand()
    return both


def work():
    """Steps of both engines on spheres that stand still, for the counter of instructions."""

    def steps(engine):
        return lambda: engine.step_to(engine.step + STEPS)

    return {f"spheres, {how}": steps(engine) for how, engine in engines(still(smooth_spheres())).items()}
