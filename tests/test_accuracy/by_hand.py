"""A kernel for frictionless discs of one size, written out by hand: what the built one must not cost more than."""

from dataclasses import replace
from functools import cache
from math import sqrt

import numpy as np
from numba import njit
from numba.extending import register_jitable

from silostudy.accuracy.prices import still
from silostudy.accuracy.silo import scene
from silostudy.dem.arrays import BLOCK, LANES
from silostudy.dem.cells import OPTIONS
from silostudy.dem.engine import Engine
from silostudy.dem.kernel import EXPLODED, FRESH, STALE, first_runaway, relist, worst
from silostudy.dem.lanes import FX, FY, TORQUE, U, V, X, Y, gather, scatter
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.walls import gather_walls, scatter_walls

PLAIN = {**OPTIONS, "cache": False}
inlined = register_jitable(forceinline=True)  # as the pieces of the built kernel are
STEPS = 2000


@inlined
def push(lanes, out, reach, count, stiffness, damping):
    """Normal forces only: spring and dashpot that never pull."""
    for k in range(count):
        dx, dy = lanes[0, k], lanes[1, k]
        distance = sqrt(dx * dx + dy * dy)
        inverse = 1.0 / distance
        nx, ny = dx * inverse, dy * inverse
        overlap = reach - distance
        depth = overlap if overlap > 0.0 else 0.0
        total = stiffness * depth + damping * -(lanes[2, k] * nx + lanes[3, k] * ny)
        total = total if total > 0.0 else 0.0
        total = total if overlap > 0.0 else 0.0
        out[0, k], out[1, k], out[2, k], out[3, k] = total * nx, total * ny, 0.0, 0.0


@inlined
def pairs_of(rows, pairs, begin, end, scratch, c):
    reach, damping = pairs.arm[0] + pairs.other[0], c[0][1] + c[0][2] * sqrt(pairs.mass[0])
    for start in range(begin, end, LANES):
        count = min(end - start, LANES)
        gather(rows, pairs.first, pairs.second, start, count, scratch.lanes)
        push(scratch.lanes, scratch.force, reach, count, c[0][0], damping)
        scatter(rows, pairs.first, pairs.second, start, count, scratch.force)


@inlined
def walls_of(rows, near, walls, end, scratch, c):
    reach, damping = near.arm[0] + near.other[0], c[0][1] + c[0][2] * sqrt(near.mass[0])
    for start in range(0, end, LANES):
        count = min(end - start, LANES)
        gather_walls(rows, walls.shape, near.first, near.second, start, count, scratch.lanes)
        push(scratch.lanes, scratch.force, reach, count, c[0][0], damping)
        scatter_walls(rows, near.first, start, count, scratch.force)


@inlined
def moved(rows, begin, end, im, gx, gy, dt, motion, motion_bits):
    for i in range(begin, end):
        u = rows[i, U] + (rows[i, FX] * im + gx) * dt
        v = rows[i, V] + (rows[i, FY] * im + gy) * dt
        du, dv = u * dt, v * dt
        rows[i, X] += du
        rows[i, Y] += dv
        rows[i, U], rows[i, V] = u, v
        rows[i, FX], rows[i, FY], rows[i, TORQUE] = 0.0, 0.0, 0.0
        motion[i - begin] = du * du + dv * dv
    most = np.uint64(0)
    for k in range(end - begin):
        most = motion_bits[k] if motion_bits[k] > most else most
    motion_bits[0] = most
    return sqrt(motion[0])


@inlined
def one_step(discs, pairs, near, walls, blocks, scratch, laws, hi, gx, gy, dt):
    last, stale = (hi + BLOCK - 1) // BLOCK, FRESH
    walls_of(discs.rows, near, walls, near.begin[0], scratch, laws[1])
    pairs_of(discs.rows, pairs, pairs.begin[last], pairs.begin[last + 1], scratch, laws[0])
    for b in range(last):
        pairs_of(discs.rows, pairs, pairs.begin[b], pairs.begin[b + 1], scratch, laws[0])
        start = b * BLOCK
        way = moved(
            discs.rows, start, min(start + BLOCK, hi), discs.inverse_mass[0], gx, gy, dt, scratch.motion, scratch.motion_bits
        )
        blocks.peak[b] = way
        blocks.travel[b] += way
        if blocks.travel[b] > blocks.skin[b]:
            stale = STALE
    return stale


@cache
def kernel_by_hand():
    """Takes the built kernel's arguments; for one thread only."""

    @njit(**PLAIN)
    def run(
        discs, pairs, near, memories, walls, blocks, scratch, laws, record, ledger, quake,
        clock, said, gate, part, parties, n, lo, hi, base, stop, gravity, dt, limits,
    ):  # fmt: skip
        step = clock[0]
        while True:
            if worst(said) != FRESH:
                if said[part] == FRESH:
                    said[part] = STALE
                relist(
                    discs, pairs, near, memories, walls, blocks, scratch, clock,
                    said, part, parties, gate, n, lo, hi, base, limits,
                )  # fmt: skip
                if worst(said) != FRESH:
                    break
            if step >= stop:
                break
            word = one_step(discs, pairs, near, walls, blocks, scratch, laws, hi, gravity[0], gravity[1], dt)
            step += 1
            if word == STALE:
                runaway = first_runaway(discs, lo, hi, dt)
                if runaway >= 0:
                    word = EXPLODED
                    clock[2 + part] = runaway
            said[part] = word
            if word == EXPLODED:
                break
        clock[0] = step

    return run


def frictionless(across: int = 18, levels: int = 20):
    """The bench's silo without friction, history and rotation."""
    model, _ = scene(across, levels)

    def bare(contact: Contact) -> Contact:
        names = ("normal_stiffness", "normal_damping", "normal_damping_root")
        return Contact(Laws(), {name: contact.coefficients[name] for name in names})

    return replace(model, pair=bare(model.pair), wall=bare(model.wall))


def engines(model) -> dict[str, Engine]:
    """The built kernel and the one by hand on the same model."""
    found = {"built": Engine(model), "by hand": Engine(model)}
    found["by hand"]._kernel = kernel_by_hand()
    return found


def work():
    """Steps of both engines on discs that stand still, for the counter of instructions."""

    def steps(engine):
        return lambda: engine.step_to(engine.step + STEPS)

    return {name: steps(engine) for name, engine in engines(still(frictionless())).items()}
