"""The kernel: one compiled function that steps a scene, built from exactly the pieces that the scene calls for.

Its parts close over plain functions only (register_jitable): numba names a kept kernel by the bytes of what it closes
over, and a compiled function in there would have other bytes in every process, so that nothing would be found again.
"""

from functools import cache
from math import sqrt

import numpy as np
from numba import njit

from silostudy.dem.arrays import BLOCK, LANES
from silostudy.dem.cache import named, piece
from silostudy.dem.cells import OPTIONS
from silostudy.dem.force import force_pass
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.lanes import FX, FY, TORQUE, U, V, W, X, Y, gather, scatter
from silostudy.dem.ledger import book_pass, keep_histories
from silostudy.dem.neighbours import GHOSTS, PRESSED, allow, harvest, list_pairs, list_walls
from silostudy.dem.pieces import Laws, Pieces
from silostudy.dem.threads import meet
from silostudy.dem.walls import add_to_window, gather_walls, note_walls, scatter_walls

FRESH, STALE, REMEMBERED, SHORT_OF_ROOM, EXPLODED = range(5)  # what a thread says of its list after a step


def pair_pass(laws: Laws, unequal: bool):
    """Function that adds the contact forces of a stretch of the list to its discs."""
    forces = force_pass(laws, unequal=unequal, flat=False)
    slides, rolls = laws.slides, laws.rolls

    @piece(laws, unequal)
    def pairs_between(rows, pairs, begin, end, scratch, dt, c):
        for start in range(begin, end, LANES):
            count = min(end - start, LANES)
            gather(rows, pairs.first, pairs.second, start, count, scratch.lanes)
            stored = pairs.stored[start:] if slides else pairs.stored
            rolled = pairs.rolled[start:] if rolls else pairs.rolled
            arm = pairs.arm[start:] if unequal else pairs.arm
            other = pairs.other[start:] if unequal else pairs.other
            mass = pairs.mass[start:] if unequal else pairs.mass
            forces(scratch.lanes, scratch.force, stored, rolled, arm, other, mass, count, dt, c)
            scatter(rows, pairs.first, pairs.second, start, count, scratch.force)

    return pairs_between


def wall_pass(laws: Laws, unequal: bool, watched: bool):
    """Function that adds the walls' forces of a stretch of the list to its discs."""
    forces = force_pass(laws, unequal=unequal, flat=True)
    slides, rolls = laws.slides, laws.rolls

    @piece(laws, unequal, watched)
    def walls_between(rows, near, walls, begin, end, scratch, dt, c, record, part):
        for start in range(begin, end, LANES):
            count = min(end - start, LANES)
            gather_walls(rows, walls.shape, near.first, near.second, start, count, scratch.lanes)
            stored = near.stored[start:] if slides else near.stored
            rolled = near.rolled[start:] if rolls else near.rolled
            arm = near.arm[start:] if unequal else near.arm
            other = near.other[start:] if unequal else near.other
            mass = near.mass[start:] if unequal else near.mass
            forces(scratch.lanes, scratch.force, stored, rolled, arm, other, mass, count, dt, c)
            scatter_walls(rows, near.first, start, count, scratch.force)
            if watched:
                note_walls(rows, walls, near, start, count, scratch.force, record, part)

    return walls_between


def move_pass(integrator: str, unequal: bool, turns: bool):
    """Function that moves the discs from `begin` to `end`, clears their forces and gives the longest way (m) of any."""
    advance, holds = INTEGRATORS[integrator].advance, INTEGRATORS[integrator].holds

    @piece(integrator, unequal, turns)
    def move(discs, begin, end, gx, gy, kick, dt, motion, motion_bits):
        rows, held = discs.rows, discs.held
        im, ii = discs.inverse_mass[0], discs.inverse_inertia[0]
        hu = hv = hw = 0.0
        for i in range(begin, end):
            if unequal:
                im, ii = discs.inverse_mass[i], discs.inverse_inertia[i]
            if holds:
                hu, hv, hw = held[i, 0], held[i, 1], held[i, 2]
            u, hu, du = advance(rows[i, U], hu, rows[i, FX] * im + gx, kick, dt)
            v, hv, dv = advance(rows[i, V], hv, rows[i, FY] * im + gy, kick, dt)
            rows[i, X] += du
            rows[i, Y] += dv
            rows[i, U], rows[i, V] = u, v
            if turns:
                rows[i, W], hw, _ = advance(rows[i, W], hw, rows[i, TORQUE] * ii, kick, dt)
            if holds:
                held[i, 0], held[i, 1], held[i, 2] = hu, hv, hw
            rows[i, FX], rows[i, FY], rows[i, TORQUE] = 0.0, 0.0, 0.0
            motion[i - begin] = du * du + dv * dv
        most = np.uint64(0)
        for k in range(end - begin):
            most = motion_bits[k] if motion_bits[k] > most else most
        motion_bits[0] = most
        return sqrt(motion[0])

    return move


def sweep_pass(pieces: Pieces):
    """Function that makes one step of the discs lo to hi, block by block, and says whether their list still holds.

    A block's discs are moved as soon as the contacts that start in it are done: earlier discs never meet them again and
    later contacts do not touch them, so one pass through memory is enough.  A disc's forces add up in one order: walls,
    then discs, each by their numbers.
    """
    pairs_between = pair_pass(pieces.pair_laws, pieces.unequal)
    walls_between = wall_pass(pieces.wall_laws, pieces.unequal, pieces.watched)
    move = move_pass(pieces.integrator, pieces.unequal, pieces.turns)
    booked, book = pieces.booked, book_pass(pieces)

    @piece(pieces)
    def block_moves(discs, blocks, scratch, block, hi, gx, gy, kick, dt):
        start = block * BLOCK
        way = move(discs, start, min(start + BLOCK, hi), gx, gy, kick, dt, scratch.motion, scratch.motion_bits)
        blocks.peak[block] = way
        blocks.travel[block] += way
        return FRESH if blocks.travel[block] <= blocks.skin[block] else STALE

    @piece(pieces)
    def all_forces(discs, pairs, scratch, laws, last, dt):
        for b in range(last):
            pairs_between(discs.rows, pairs, pairs.begin[b], pairs.begin[b + 1], scratch, dt, laws[0])

    @piece(pieces)
    def sweep(
        discs, pairs, near, walls, blocks, scratch, laws, record, ledger, part, lo, hi, gx, gy, gravity, kick, dt
    ):  # fmt: skip
        last, stale = (hi - lo + BLOCK - 1) // BLOCK, FRESH
        if booked:
            keep_histories(pairs, pairs.begin[last], ledger.pair_stored, ledger.pair_rolled)
            keep_histories(near, near.begin[0], ledger.wall_stored, ledger.wall_rolled)
        walls_between(discs.rows, near, walls, 0, near.begin[0], scratch, dt, laws[1], record, part)
        pairs_between(discs.rows, pairs, pairs.begin[last], pairs.begin[last + 1], scratch, dt, laws[0])
        if booked:
            all_forces(discs, pairs, scratch, laws, last, dt)
            book(discs, pairs, near, walls, scratch, ledger, laws, hi, last, gx, gy, gravity, kick, dt)
        for b in range(last):
            if not booked:
                pairs_between(discs.rows, pairs, pairs.begin[b], pairs.begin[b + 1], scratch, dt, laws[0])
            stale = max(stale, block_moves(discs, blocks, scratch, lo // BLOCK + b, hi, gx, gy, kick, dt))
        record.counts[part] = near.begin[0]
        return stale

    return sweep


@njit(**OPTIONS)
def first_runaway(discs, lo, hi, dt):
    """First disc from lo to hi that moved more than its radius in the step or is not finite; -1 where all is well."""
    for i in range(lo, hi):
        u, v, w = discs.rows[i, U], discs.rows[i, V], discs.rows[i, W]
        radius = discs.radius[i if discs.radius.size > 1 else 0]
        if not (u * u + v * v) * dt * dt <= radius * radius or not abs(w) < np.inf:
            return i
    return -1


@njit(**OPTIONS)
def relist(discs, pairs, near, memories, walls, blocks, scratch, clock, said, part, parties, gate, n, lo, hi, base, limits):
    """Make this thread's list anew; the histories come from the old list unless the memories hold them already.

    Whoever is in the list is looked at: a disc pressed half through another body ends the run.
    """
    if said[part] == STALE:
        harvest(pairs, near, memories[0], memories[1], scratch, (hi - lo + BLOCK - 1) // BLOCK, base)
        said[part] = REMEMBERED
    allow(blocks, lo // BLOCK, (hi + BLOCK - 1) // BLOCK, limits[0], limits[1])
    meet(gate, parties)
    enough = list_pairs(discs, pairs, memories[0], blocks, scratch, n, lo, hi, base)
    enough = enough and list_walls(discs, near, memories[1], walls, blocks, scratch, lo, hi, base + scratch.ghost.size)
    said[part] = FRESH if enough else SHORT_OF_ROOM
    if scratch.counts[PRESSED] > 0:
        said[part] = EXPLODED
        clock[2 + part] = scratch.counts[PRESSED] - 1


@njit(**OPTIONS)
def worst(said):
    """The gravest word of all threads."""
    gravest = said[0]
    for word in said:
        gravest = max(gravest, word)
    return gravest


@njit(**OPTIONS)
def copy_ghosts(rows, scratch, base):
    """Copy the discs of other threads that this thread's discs may touch."""
    for k in range(scratch.counts[GHOSTS]):
        for lane in range(W + 1):
            rows[base + k, lane] = rows[scratch.ghost[k], lane]


@cache
def kernel(pieces: Pieces):
    """The compiled stepper of a scene made of these pieces.

    It steps from clock[0] to `stop` and returns with lists that hold; it leaves early, with a word in said[part], when a
    list needs room or a disc runs away (its number then is in clock[2 + part]).
    """
    sweep = sweep_pass(pieces)
    shaken, watched = pieces.shaken, pieces.watched
    half_start = INTEGRATORS[pieces.integrator].half_start

    def run(
        discs, pairs, near, memories, walls, blocks, scratch, laws, record, ledger, quake,
        clock, said, gate, part, parties, n, lo, hi, base, stop, gravity, dt, limits,
    ):  # fmt: skip
        step = clock[0]
        gx, gy = gravity
        while True:
            if worst(said) != FRESH:
                meet(gate, parties)
                if said[part] == FRESH:
                    said[part] = STALE
                relist(
                    discs, pairs, near, memories, walls, blocks, scratch, clock,
                    said, part, parties, gate, n, lo, hi, base, limits,
                )  # fmt: skip
                meet(gate, parties)
                if worst(said) != FRESH:
                    break
            if step >= stop:
                break
            copy_ghosts(discs.rows, scratch, base)
            meet(gate, parties)
            if shaken:
                at = min(step, quake.shape[0] - 1)
                gx, gy = gravity[0] - quake[at, 0], gravity[1] - quake[at, 1]
            word = sweep(
                discs, pairs, near, walls, blocks, scratch, laws, record, ledger,
                part, lo, hi, gx, gy, gravity, 0.5 * dt if half_start and step == 0 else dt, dt,
            )  # fmt: skip
            step += 1
            if word == STALE:
                runaway = first_runaway(discs, lo, hi, dt)
                if runaway >= 0:
                    word = EXPLODED
                    clock[2 + part] = runaway
            said[part] = word
            meet(gate, parties)
            if watched and part == 0:
                add_to_window(record)
            if worst(said) == EXPLODED:
                break
        meet(gate, parties)
        if part == 0:
            clock[0] = step

    return njit(**OPTIONS)(named(run, repr(pieces)))
