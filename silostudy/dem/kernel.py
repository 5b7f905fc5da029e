"""The kernel: one compiled function that steps a scene, built from exactly the pieces that the scene calls for.

Its parts close over plain functions only (register_jitable): numba names a kept kernel by the bytes of what it closes
over, and a compiled function in there would have other bytes in every process, so that nothing would be found again.
"""

from functools import cache

import numpy as np
from numba import njit

from silostudy.dem.arrays import BLOCK
from silostudy.dem.body import motion, spin, square_speed
from silostudy.dem.cache import OPTIONS, named
from silostudy.dem.drive import drive_pass
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.neighbours import harvest, list_pairs, list_walls
from silostudy.dem.pieces import Pieces
from silostudy.dem.seams import carry_over
from silostudy.dem.sweep import EXPLODED, FRESH, REMEMBERED, SHORT_OF_ROOM, STALE, sweep_pass
from silostudy.dem.threads import meet
from silostudy.dem.watch import add_to_window
from silostudy.dem.wide import GHOSTS, PRESSED, SEAMS, allow, allow_wide, list_wide, wide_holds


@njit(**OPTIONS)
def first_runaway(bodies, lo, hi, dt):
    """First body from lo to hi that moved more than its radius in the step or is not finite; -1 where all is well."""
    for i in range(lo, hi):
        radius = bodies.radius[i if bodies.radius.size > 1 else 0]
        if not square_speed(bodies, i) * dt * dt <= radius * radius or not spin(bodies, i) < np.inf:
            return i
    return -1


@njit(**OPTIONS)
def relist(shared, share, march):
    """Make this thread's list anew; the histories come from the old list unless the memories hold them already.

    Whoever is in the list is looked at: a body pressed half through another body ends the run.
    """
    bodies, blocks, scratch, said = shared.bodies, shared.blocks, share.scratch, shared.said
    number, lo, hi, base = share.number, share.lo, share.hi, share.base
    if said[number] == STALE:
        last = (hi - lo + BLOCK - 1) // BLOCK
        harvest(share.pairs, share.near, share.pair_memory, share.wall_memory, scratch, last, base)
        said[number] = REMEMBERED
    own, after = lo // BLOCK, (hi + BLOCK - 1) // BLOCK
    allow(blocks, own, after, march.ahead, march.smallest, march.skin)
    meet(shared.gate, march.parties)
    enough, stays = True, wide_holds(blocks, (march.bodies + BLOCK - 1) // BLOCK)  # all threads find the same
    meet(shared.gate, march.parties)
    if not stays:
        allow_wide(blocks, own, after, march.smallest)
        meet(shared.gate, march.parties)
        enough = list_wide(bodies, shared.walls, blocks, scratch, march.gap, march.bodies, lo, hi)
    enough = enough and list_pairs(bodies, share.pairs, share.pair_memory, blocks, scratch, march.gap, lo, hi, base)
    dummy = base + scratch.ghost.size
    enough = enough and list_walls(bodies, share.near, share.wall_memory, shared.walls, blocks, scratch, march.gap, dummy)
    said[number] = FRESH if enough else SHORT_OF_ROOM
    if scratch.counts[PRESSED] > 0:
        said[number] = EXPLODED
        shared.clock[2 + number] = scratch.counts[PRESSED] - 1


@njit(**OPTIONS)
def worst(said):
    """The gravest word of all threads."""
    gravest = said[0]
    for word in said:
        gravest = max(gravest, word)
    return gravest


@njit(**OPTIONS)
def copy_ghosts(bodies, scratch, base):
    """Copy the bodies of other threads that this thread's bodies may touch."""
    for k in range(scratch.counts[GHOSTS]):
        for lane in range(motion(bodies, k)):
            bodies.rows[base + k, lane] = bodies.rows[scratch.ghost[k], lane]


@njit(**OPTIONS)
def pass_way_on(blocks, count, way):
    """Let a way (m) of a wall count as one of every block's bodies; says whether the lists still hold."""
    word = FRESH
    for b in range(count):
        blocks.travel[b] += way
        blocks.peak[b] += way
        word = FRESH if blocks.travel[b] <= blocks.skin[b] and word == FRESH else STALE
    return word


@cache
def kernel(pieces: Pieces):
    """The compiled stepper of a scene made of these pieces: run(shared, share, march).

    It steps from clock[0] to the march's stop, or over it by a part of a step, and returns with lists that hold; it leaves
    early, with a word in said[number], when a list needs room or a disc runs away (its number then is in clock[2 + number]).
    """
    sweep = sweep_pass(pieces)
    shaken, watched, pushed, moving = pieces.shaken, pieces.watched, pieces.space.pushed, pieces.moving
    drive_walls = drive_pass(pieces)
    half_start, seamed = INTEGRATORS[pieces.integrator].half_start, pieces.space.ways == 2 and pieces.wall_laws.stores

    def run(shared, share, march):
        clock, said, gate, number, parties = shared.clock, shared.said, shared.gate, share.number, march.parties
        step, pull = clock[0], march.gravity
        while True:
            if worst(said) != FRESH:
                meet(gate, parties)
                if said[number] == FRESH:
                    said[number] = STALE
                relist(shared, share, march)
                meet(gate, parties)
                if worst(said) != FRESH:
                    break
            if seamed and share.scratch.counts[SEAMS] > 0:
                carry_over(shared.bodies.rows, shared.walls.shape, share.near, share.scratch)
            if step >= march.stop:
                break
            copy_ghosts(shared.bodies, share.scratch, share.base)
            meet(gate, parties)
            if shaken:
                row = min(step, shared.quake.shape[0] - 1)
                pull = pushed(march.gravity, shared.quake, row)
            word = sweep(shared, share, march, pull, 0.5 * march.dt if half_start and step == 0 else march.kick)
            step += march.ticks
            if word == STALE:
                runaway = first_runaway(shared.bodies, share.lo, share.hi, march.dt)
                if runaway >= 0:
                    word = EXPLODED
                    clock[2 + number] = runaway
            said[number] = word
            meet(gate, parties)
            if watched and number == 0:
                add_to_window(shared.record)
            if moving:
                if number == 0:
                    way = drive_walls(shared.walls, shared.record, march.dt)
                    said[0] = max(said[0], pass_way_on(shared.blocks, (march.bodies + BLOCK - 1) // BLOCK, way))
                meet(gate, parties)
            if worst(said) == EXPLODED:
                break
        meet(gate, parties)
        if number == 0:
            clock[0] = step

    return njit(**OPTIONS)(named(run, repr(pieces)))
