"""Kernels for discs of one size, written out by hand without friction and with it: what the built ones must not cost more.

Neither knows of several sizes, recorded wall forces, shaking, an energy balance, rolling resistance or cohesion.
"""

from functools import cache
from math import sqrt

import numpy as np
from numba import njit
from numba.extending import register_jitable

from silostudy.accuracy.prices import still, without
from silostudy.accuracy.silo import silo_of_rows
from silostudy.dem.arrays import BLOCK
from silostudy.dem.cache import OPTIONS
from silostudy.dem.columns import to_lanes, to_rows_of_discs
from silostudy.dem.engine import Engine
from silostudy.dem.kernel import first_runaway, relist, worst
from silostudy.dem.lanes import (
    DISTANCE,
    DU,
    DV,
    FX,
    FY,
    NORMAL_X,
    NORMAL_Y,
    SPIN_SUM,
    STRETCH,
    TORQUE,
    U,
    V,
    W,
    X,
    Y,
    gather_rolling,
    scatter_rolling,
)
from silostudy.dem.model import Model
from silostudy.dem.sweep import EXPLODED, FRESH, STALE
from silostudy.dem.walls import gather_walls, scatter_walls

PLAIN = {**OPTIONS, "cache": False}
inlined = register_jitable(forceinline=True)  # as the pieces of the built kernel are
STEPS = 2000


@inlined
def push(lanes, out, stored, a, b, count, dt, c, damping, drag_damping):
    """Normal forces only: spring and dashpot that never pull."""
    reach, stiffness = a + b, c[0][0]
    for k in range(count):
        nx, ny, overlap = lanes[NORMAL_X, k], lanes[NORMAL_Y, k], reach - lanes[DISTANCE, k]
        depth = overlap if overlap > 0.0 else 0.0
        total = stiffness * depth + damping * -(lanes[DU, k] * nx + lanes[DV, k] * ny)
        total = total if total > 0.0 else 0.0
        total = total if overlap > 0.0 else 0.0
        out[0, k], out[1, k], out[2, k] = total * nx, total * ny, 0.0


@inlined
def rub(lanes, out, stored, a, b, count, dt, c, damping, drag_damping):
    """The same, and Cundall and Strack's slider."""
    reach, stiffness, slip, friction = a + b, c[0][0], c[1][0] * dt, c[1][3]
    for k in range(count):
        nx, ny, du, dv = lanes[NORMAL_X, k], lanes[NORMAL_Y, k], lanes[DU, k], lanes[DV, k]
        overlap = reach - lanes[DISTANCE, k]
        depth = overlap if overlap > 0.0 else 0.0
        total = stiffness * depth + damping * -(du * nx + dv * ny)
        total = total if total > 0.0 else 0.0
        sliding = dv * nx - du * ny - lanes[SPIN_SUM, k] * a
        dashpot = -drag_damping * sliding
        most = friction * total
        drag = stored[k] - slip * sliding + dashpot
        drag = drag if drag > -most else -most
        drag = drag if drag < most else most
        held = drag - dashpot
        total = total if overlap > 0.0 else 0.0
        drag = drag if overlap > 0.0 else 0.0
        stored[k] = held if overlap > 0.0 else 0.0
        out[0, k], out[1, k] = total * nx - drag * ny, total * ny + drag * nx
        out[2, k] = -drag * a


@inlined
def longest(count, motion, motion_bits):
    """Longest way (m) of so many bodies, from its squares and their bits."""
    most = np.uint64(0)
    for k in range(count):
        most = motion_bits[k] if motion_bits[k] > most else most
    motion_bits[0] = most
    return sqrt(motion[0])


@inlined
def travelled(blocks, b, way, stale):
    """Note the longest way of a block's bodies; whether the lists still hold."""
    blocks.peak[b] = way
    blocks.travel[b] += way
    return STALE if blocks.travel[b] > blocks.skin[b] else stale


def lists_by_hand(rough: bool):
    """Forces of both lists, with friction or without."""
    force = rub if rough else push

    @inlined
    def of_list(contacts, start, count, scratch, dt, c):
        root = sqrt(contacts.mass[0])
        drag_damping = c[1][1] + c[1][2] * root if rough else 0.0
        stored = contacts.stored[start:] if rough else contacts.stored
        force(
            scratch.lanes, scratch.force, stored, contacts.arm[0], contacts.other[0], count, dt, c,
            c[0][1] + c[0][2] * root, drag_damping,
        )  # fmt: skip

    @inlined
    def pairs_of(rows, pairs, begin, end, scratch, dt, c):
        for start in range(begin, end, STRETCH):
            count = min(end - start, STRETCH)
            gather_rolling(rows, pairs.first, pairs.second, start, count, scratch.lanes)
            of_list(pairs, start, count, scratch, dt, c)
            scatter_rolling(rows, pairs.first, pairs.second, start, count, scratch.force)

    @inlined
    def walls_of(rows, near, walls, end, scratch, dt, c):
        for start in range(0, end, STRETCH):
            count = min(end - start, STRETCH)
            gather_walls(rows, walls.shape, near.first, near.second, start, count, scratch.lanes)
            of_list(near, start, count, scratch, dt, c)
            scatter_walls(rows, near.first, start, count, scratch.force)

    return pairs_of, walls_of


def moves_by_hand(rough: bool):
    """Moves of a block's discs, which turn or do not."""

    @inlined
    def moved(rows, begin, end, im, ii, gx, gy, dt, scratch):
        lanes, motion = scratch.lanes.reshape(-1), scratch.motion
        to_lanes(rows, begin, end, lanes, STRETCH)
        for k in range(end - begin):
            u = lanes[U * STRETCH + k] + (lanes[FX * STRETCH + k] * im + gx) * dt
            v = lanes[V * STRETCH + k] + (lanes[FY * STRETCH + k] * im + gy) * dt
            du, dv = u * dt, v * dt
            lanes[X * STRETCH + k] += du
            lanes[Y * STRETCH + k] += dv
            lanes[U * STRETCH + k], lanes[V * STRETCH + k] = u, v
            if rough:
                lanes[W * STRETCH + k] += lanes[TORQUE * STRETCH + k] * ii * dt
            motion[k] = du * du + dv * dv
        to_rows_of_discs(lanes, STRETCH, rows, begin, end)
        return longest(end - begin, motion, scratch.motion_bits)

    return moved


def step_by_hand(rough: bool):
    """One step with friction or without; the flag is known when it is compiled."""
    (pairs_of, walls_of), moved = lists_by_hand(rough), moves_by_hand(rough)

    @inlined
    def one_step(discs, pairs, near, walls, blocks, scratch, laws, hi, gravity, dt):
        last, stale = (hi + BLOCK - 1) // BLOCK, FRESH
        walls_of(discs.rows, near, walls, near.begin[0], scratch, dt, laws[1])
        pairs_of(discs.rows, pairs, pairs.begin[last], pairs.begin[last + 1], scratch, dt, laws[0])
        for b in range(last):
            pairs_of(discs.rows, pairs, pairs.begin[b], pairs.begin[b + 1], scratch, dt, laws[0])
            start, im, ii = b * BLOCK, discs.inverse_mass[0], discs.inverse_inertia[0]
            end = min(start + BLOCK, hi)
            way = moved(discs.rows, start, end, im, ii, gravity[0], gravity[1], dt, scratch)
            stale = travelled(blocks, b, way, stale)
        return stale

    return one_step


def marched(one_step):
    """A kernel of steps: takes the built kernel's arguments; for one thread only."""

    @njit(**PLAIN)
    def run(shared, share, march):
        clock, said, number = shared.clock, shared.said, share.number
        step, laws = clock[0], (march.pair_coefficients, march.wall_coefficients)
        while True:
            if worst(said) != FRESH:
                if said[number] == FRESH:
                    said[number] = STALE
                relist(shared, share, march)
                if worst(said) != FRESH:
                    break
            if step >= march.stop:
                break
            word = one_step(
                shared.bodies, share.pairs, share.near, shared.walls, shared.blocks, share.scratch, laws, share.hi,
                march.gravity, march.dt,
            )  # fmt: skip
            step += 1
            if word == STALE:
                runaway = first_runaway(shared.bodies, share.lo, share.hi, march.dt)
                if runaway >= 0:
                    word = EXPLODED
                    clock[2 + number] = runaway
            said[number] = word
            if word == EXPLODED:
                break
        clock[0] = step

    return run


@cache
def kernel_by_hand(rough: bool):
    """The kernel with friction or without."""
    return marched(step_by_hand(rough))


def silos(across: int = 18, levels: int = 20) -> dict[str, Model]:
    """The bench's silo, and the same without friction, history and rotation."""
    model, _ = silo_of_rows(across, levels)
    return {"friction": model, "no friction": without(model)["friction, rotation, history"][1]}


def engines(model: Model) -> dict[str, Engine]:
    """The built kernel and the one by hand on the same model."""
    found = {"built": Engine(model), "by hand": Engine(model)}
    found["by hand"]._kernel = kernel_by_hand(model.pieces.turns)
    return found


def steps_of(models, engines, steps):
    """Steps of all engines on models that stand still, by name."""

    def stepping(engine):
        return lambda: engine.step_to(engine.step + steps)

    return {
        f"{name}, {how}": stepping(engine) for name, model in models.items() for how, engine in engines(still(model)).items()
    }


def work():
    """Steps of all engines on discs that stand still, for the counter of instructions."""
    return steps_of(silos(), engines, STEPS)
