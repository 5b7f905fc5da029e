"""Kernels for equal spheres, written out by hand without friction and with it: what the built ones must not cost more.

Neither knows of rolling, twisting, cohesion, several sizes or kinds, recorded or moving walls.
"""

from functools import cache
from math import sqrt

import numpy as np

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.prices import without
from silostudy.dem.arrays import BLOCK
from silostudy.dem.columns import to_lanes, to_rows_of_spheres
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.space.felt import gather_walls, scatter_walls
from silostudy.dem.space.lanes import (
    CURVED,
    DU,
    DV,
    DW,
    FIRST_X,
    FIRST_Y,
    FIRST_Z,
    FORCE_X,
    FORCE_Y,
    FORCE_Z,
    FX,
    FY,
    FZ,
    NEW,
    OLD,
    PASSED,
    STRETCH,
    SUM_P,
    SUM_Q,
    SUM_R,
    TX,
    TY,
    TZ,
    P,
    Q,
    R,
    U,
    V,
    W,
    X,
    Y,
    Z,
    bring,
    gather_rolling,
    scatter_rolling,
    take,
)  # fmt: skip
from silostudy.dem.space.motion import APART, carry, cross, dot, facing, held_of
from silostudy.dem.sweep import FRESH
from tests.test_accuracy.by_hand import inlined, longest, marched, steps_of, travelled

STEPS = 300


@inlined
def push(lanes, out, a, b, m, count, dt, c, flat):
    """Hertz's force and a dashpot that may pull."""
    for k in range(count):
        (nx, ny, nz), distance = facing(lanes, k)
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
def rub(lanes, out, a, b, m, count, dt, c, flat):
    """The same, and Mindlin's spring and dashpot, their sum capped."""
    for k in range(count):
        normal, distance = facing(lanes, k)
        nx, ny, nz = normal
        overlap = a + b - distance
        depth = overlap if overlap > 0.0 else 0.0
        radius = a / (1.0 - a * lanes[0, CURVED * STRETCH + k]) if flat else a * b / (a + b)
        du, dv, dw = lanes[0, DU * STRETCH + k], lanes[0, DV * STRETCH + k], lanes[0, DW * STRETCH + k]
        closing = -(du * nx + dv * ny + dw * nz)
        arm = a if flat else a - 0.5 * depth
        spin = arm * lanes[0, SUM_P * STRETCH + k], arm * lanes[0, SUM_Q * STRETCH + k], arm * lanes[0, SUM_R * STRETCH + k]
        turning = cross(spin, normal)
        su, sv, sw = du + closing * nx - turning[0], dv + closing * ny - turning[1], dw + closing * nz - turning[2]
        wide = np.sqrt(radius * depth)
        root = np.sqrt(m * wide)
        total = c[0][0] * wide * depth + c[0][1] * root * closing
        held = carry(held_of(lanes, k), normal)
        slip, damping = c[1][0] * wide * dt, -(c[1][1] * root)
        x, y, z = damping * su, damping * sv, damping * sw
        whole = held[0] - slip * su + x, held[1] - slip * sv + y, held[2] - slip * sw + z
        cap, square = c[1][2] * (total if total > 0.0 else 0.0), dot(whole, whole)
        share = 1.0 if square <= cap * cap else cap / sqrt(square)
        fx, fy, fz = share * whole[0], share * whole[1], share * whole[2]
        out[0, NEW * STRETCH + k] = fx - x if overlap > 0.0 else 0.0
        out[0, (NEW + 1) * STRETCH + k] = fy - y if overlap > 0.0 else 0.0
        out[0, (NEW + 2) * STRETCH + k] = fz - z if overlap > 0.0 else 0.0
        total = total if overlap > 0.0 else 0.0
        drag = fx if overlap > 0.0 else 0.0, fy if overlap > 0.0 else 0.0, fz if overlap > 0.0 else 0.0
        out[0, FORCE_X * STRETCH + k], out[0, FORCE_Y * STRETCH + k] = total * nx + drag[0], total * ny + drag[1]
        out[0, FORCE_Z * STRETCH + k] = total * nz + drag[2]
        twist = cross(drag, normal)
        out[0, FIRST_X * STRETCH + k], out[0, FIRST_Y * STRETCH + k] = arm * twist[0], arm * twist[1]
        out[0, FIRST_Z * STRETCH + k] = arm * twist[2]


def lists_by_hand(rough: bool):
    """Forces of both lists, with friction or without."""
    force = rub if rough else push

    @inlined
    def of_list(contacts, start, count, scratch, dt, c, flat):
        if rough:
            bring(contacts.stored, start, count, scratch.lanes, OLD * STRETCH)
        force(scratch.lanes, scratch.force, contacts.arm[0], contacts.other[0], contacts.mass[0], count, dt, c, flat)
        if rough:
            take(scratch.force, NEW * STRETCH, contacts.stored, start, count)

    @inlined
    def pairs_of(rows, pairs, begin, end, scratch, dt, c):
        for start in range(begin, end, STRETCH):
            count = min(end - start, STRETCH)
            gather_rolling(rows, pairs.first, pairs.second, start, count, scratch.lanes)
            of_list(pairs, start, count, scratch, dt, c, False)
            scatter_rolling(rows, pairs.first, pairs.second, start, count, scratch.force)

    @inlined
    def walls_of(rows, near, walls, end, scratch, dt, c):
        for start in range(0, end, STRETCH):
            count = min(end - start, STRETCH)
            gather_walls(rows, walls.shape, near.first, near.second, start, count, scratch.lanes)
            of_list(near, start, count, scratch, dt, c, True)
            scatter_walls(rows, near.first, start, count, scratch.force)

    return pairs_of, walls_of


def moves_by_hand(rough: bool):
    """Moves of a block's spheres, which turn or do not."""

    @inlined
    def moved(rows, begin, end, im, ii, gravity, dt, scratch):
        lanes, motion = scratch.lanes.reshape(-1), scratch.motion
        to_lanes(rows, begin, end, lanes, APART)
        for k in range(end - begin):
            u = lanes[U * APART + k] + (lanes[FX * APART + k] * im + gravity[0]) * dt
            v = lanes[V * APART + k] + (lanes[FY * APART + k] * im + gravity[1]) * dt
            w = lanes[W * APART + k] + (lanes[FZ * APART + k] * im + gravity[2]) * dt
            dx, dy, dz = u * dt, v * dt, w * dt
            lanes[X * APART + k] += dx
            lanes[Y * APART + k] += dy
            lanes[Z * APART + k] += dz
            lanes[U * APART + k], lanes[V * APART + k], lanes[W * APART + k] = u, v, w
            if rough:
                lanes[P * APART + k] += lanes[TX * APART + k] * ii * dt
                lanes[Q * APART + k] += lanes[TY * APART + k] * ii * dt
                lanes[R * APART + k] += lanes[TZ * APART + k] * ii * dt
            lanes[PASSED * APART + k] += 1.0 if lanes[Z * APART + k] < 0.0 else 0.0
            motion[k] = dx * dx + dy * dy + dz * dz
        to_rows_of_spheres(lanes, APART, rows, begin, end)
        return longest(end - begin, motion, scratch.motion_bits)

    return moved


def step_by_hand(rough: bool):
    """One step with friction or without; the flag is known when it is compiled."""
    (pairs_of, walls_of), moved = lists_by_hand(rough), moves_by_hand(rough)

    @inlined
    def one_step(spheres, pairs, near, walls, blocks, scratch, laws, hi, gravity, dt):
        last, stale = (hi + BLOCK - 1) // BLOCK, FRESH
        walls_of(spheres.rows, near, walls, near.begin[0], scratch, dt, laws[1])
        pairs_of(spheres.rows, pairs, pairs.begin[last], pairs.begin[last + 1], scratch, dt, laws[0])
        for b in range(last):
            pairs_of(spheres.rows, pairs, pairs.begin[b], pairs.begin[b + 1], scratch, dt, laws[0])
            start, im, ii = b * BLOCK, spheres.inverse_mass[0], spheres.inverse_inertia[0]
            end = min(start + BLOCK, hi)
            way = moved(spheres.rows, start, end, im, ii, gravity, dt, scratch)
            stale = travelled(blocks, b, way, stale)
        return stale

    return one_step


@cache
def kernel_by_hand(rough: bool):
    """The kernel with friction or without."""
    return marched(step_by_hand(rough))


def bins(count: int = 2000) -> dict[str, Model]:
    """The bench's bin, and the same without friction, history and rotation."""
    model = bin_of_spheres(Bin(count=count, wide=0.03))
    return {"friction": model, "no friction": without(model)["friction, rotation, history"][1]}


def engines(model: Model) -> dict[str, Engine]:
    """The built kernel and the one by hand on the same model."""
    both = {"built": Engine(model), "by hand": Engine(model)}
    both["by hand"]._kernel = kernel_by_hand(model.pieces.turns)
    return both


def work():
    """Steps of all engines on spheres that stand still, for the counter of instructions."""
    return steps_of(bins(), engines, STEPS)
