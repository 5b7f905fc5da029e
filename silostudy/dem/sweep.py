"""One step of one thread's discs: forces of its lists, moves of its blocks; the passes of which a kernel is built."""

from math import sqrt

import numpy as np

from silostudy.dem.arrays import BLOCK
from silostudy.dem.book import book_pass, keep_histories, of_pairs, of_walls
from silostudy.dem.cache import piece
from silostudy.dem.dimension import Dimension
from silostudy.dem.force import force_pass
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.pieces import Laws, Pieces
from silostudy.dem.vectors import fetch_rows

FRESH, STALE, REMEMBERED, SHORT_OF_ROOM, EXPLODED = range(5)  # what a thread says of its list after a step
CACHED = 100_000  # rows up to which neighbours mostly wait in the cache of a core; of more they are fetched a stretch ahead


def contact_pass(
    space: Dimension, laws: Laws, *, unequal: bool, flat: bool, varied: bool, watched: bool = False, moving: bool = False
):
    """Function that adds the forces of a stretch of a list to its discs, and notes what walls feel where they are watched."""
    forces = force_pass(space, laws, unequal=unequal, flat=flat, varied=varied, moving=moving)
    note_walls, scatter_walls, stretch = space.note_walls, space.scatter_walls, space.stretch
    scatter = space.scatter(unequal or laws.brakes)
    fetches = space.ways > 2 and not flat  # rows of discs come in time

    @piece(space, laws, unequal, flat, varied, watched, moving)
    def contacts_between(shared, contacts, begin, end, scratch, dt, c, number):
        rows = shared.bodies.rows
        for start in range(begin, end, stretch):
            count = min(end - start, stretch)
            if fetches and rows.shape[0] > CACHED:
                fetch_rows(rows, contacts.second, start + count, min(start + count + stretch, contacts.second.size))
            forces(
                rows, contacts, shared.walls.shape, start, count, scratch.lanes, scratch.force,
                contacts.stored, contacts.rolled, dt, c,
            )  # fmt: skip
            if flat:
                scatter_walls(rows, contacts.first, start, count, scratch.force)
            else:
                scatter(rows, contacts.first, contacts.second, start, count, scratch.force)
            if watched:
                note_walls(rows, shared.walls, contacts, start, count, scratch.force, shared.record, number)

    return contacts_between


def move_pass(space: Dimension, integrator: str, unequal: bool, turns: bool):
    """Function that moves the discs from `begin` to `end`, clears their forces and gives the longest way (m) of any."""
    row = INTEGRATORS[integrator]
    moved = space.move(row.advance, row.holds, turns, unequal, integrator)

    @piece(space, integrator, unequal, turns)
    def move(bodies, begin, end, pull, kick, dt, scratch):
        moved(bodies, begin, end, pull, kick, dt, scratch)
        motion, bits, most = scratch.motion, scratch.motion_bits, np.uint64(0)
        for k in range(end - begin):
            most = bits[k] if bits[k] > most else most
        bits[0] = most
        return sqrt(motion[0])

    return move


def sweep_pass(pieces: Pieces):
    """Function that makes one step of a thread's discs, block by block, and says whether their list still holds.

    A block's discs are moved as soon as the contacts that start in it are done: earlier discs never meet them again and
    later contacts do not touch them, so one pass through memory is enough.  A disc's forces add up in one order: walls,
    then discs, each by their numbers.
    """
    space, unequal, (pairs_vary, walls_vary) = pieces.space, pieces.unequal, pieces.varied
    pairs_between = contact_pass(space, pieces.pair_laws, unequal=unequal, flat=False, varied=pairs_vary)
    walls_between = contact_pass(
        space, pieces.wall_laws, unequal=unequal, flat=True, varied=walls_vary, watched=pieces.watched, moving=pieces.moving
    )
    move = move_pass(space, pieces.integrator, unequal, pieces.turns)
    booked, book = pieces.booked, book_pass(pieces)

    @piece(pieces)
    def block_moves(shared, scratch, block, hi, pull, kick, dt):
        blocks, start = shared.blocks, block * BLOCK
        way = move(shared.bodies, start, min(start + BLOCK, hi), pull, kick, dt, scratch)
        blocks.peak[block] = way
        blocks.travel[block] += way
        return FRESH if blocks.travel[block] <= blocks.skin[block] else STALE

    @piece(pieces)
    def block_forces(shared, share, block, march):
        begin, end = share.pairs.begin[block], share.pairs.begin[block + 1]
        pairs_between(shared, share.pairs, begin, end, share.scratch, march.past, march.pair_coefficients, share.number)

    @piece(pieces)
    def all_forces(shared, share, last, march):
        for b in range(last):
            block_forces(shared, share, b, march)

    @piece(pieces)
    def sweep(shared, share, march, pull, kick):
        pairs, near = share.pairs, share.near
        last, stale = (share.hi - share.lo + BLOCK - 1) // BLOCK, FRESH
        if booked:
            keep_histories(pairs, pairs.begin[last], of_pairs(shared.ledger))
            keep_histories(near, near.begin[0], of_walls(shared.ledger))
        walls_between(shared, near, 0, near.begin[0], share.scratch, march.past, march.wall_coefficients, share.number)
        block_forces(shared, share, last, march)
        if booked:
            all_forces(shared, share, last, march)
            book(shared, share, march, last, pull, kick)
        for b in range(last):
            if not booked:
                block_forces(shared, share, b, march)
            stale = max(stale, block_moves(shared, share.scratch, share.lo // BLOCK + b, share.hi, pull, kick, march.dt))
        shared.record.counts[share.number] = near.begin[0]
        return stale

    return sweep
