"""The list of near contacts: sieved anew from the wide list when a body has moved beyond its allowance, histories carried over.

What the list holds beyond the touching contacts never changes a result: forces of contacts that do not touch are zero,
and the order of the others is fixed by the numbers of the bodies.
"""

import numpy as np
from numba import njit

from silostudy.dem import history
from silostudy.dem.arrays import BEHIND, BLOCK
from silostudy.dem.body import goes_on_from, place, square_gap
from silostudy.dem.cache import OPTIONS
from silostudy.dem.varied import set_at_wall, set_of_pair
from silostudy.dem.vectors import WIDTH
from silostudy.dem.wide import GHOSTS, KEPT_PAIRS, KEPT_WALLS, PRESSED, SEAMS, SHIFT, WIDE_WALLS

LOW = (1 << SHIFT) - 1  # bits of a key that hold the second body's number
TOO_DEEP = 0.5  # of the smaller radius: discs or walls that overlap by more are no longer in touch but pressed through


@njit(**OPTIONS)
def remember(contacts, begin, end, base, ghost, memory, count):
    """Append the histories of a stretch of the list that are not nothing to the memory; gives the new count.

    All are written and those counted that stay: a branch that nobody can foresee would cost more.
    """
    if memory.key.size == 0:
        return count
    spot = np.uint64(count)
    for k in range(begin, end):
        first, second = np.int64(contacts.first[k]), np.int64(contacts.second[k])
        first = np.int64(ghost[first - base]) if first >= base else first
        second = np.int64(ghost[second - base]) if second >= base else second
        held, turned = history.entry(contacts.stored, k), history.entry(contacts.rolled, k)
        twisted, touched = history.entry(contacts.twisted, k), history.entry(contacts.touched, k)
        memory.key[spot] = (first << SHIFT) | second
        history.enter(memory.stored, spot, held)
        history.enter(memory.rolled, spot, turned)
        history.enter(memory.twisted, spot, twisted)
        history.enter(memory.touched, spot, touched)
        spot += np.uint64(history.holds(held) | history.holds(turned) | history.holds(twisted) | history.holds(touched))
    memory.key[spot] = BEHIND
    return np.int64(spot)


@njit(**OPTIONS)
def hand_over(old, spot, new, place, same):
    """Give an entry of a list what the memory holds at a place, or nothing where it is of another contact."""
    history.enter(new, place, history.where(same, history.entry(old, spot)))


@njit(**OPTIONS)
def recall(contacts, place, key, memory, spot):
    """Give a new list entry the history of its key, or none; gives where the search for the next key, a larger one, begins."""
    if memory.key.size == 0:
        return spot
    row, place = np.uint64(spot), np.uint64(place)
    while memory.key[row] < key:
        row += np.uint64(1)
    same = memory.key[row] == key
    hand_over(memory.stored, row, contacts.stored, place, same)
    hand_over(memory.rolled, row, contacts.rolled, place, same)
    hand_over(memory.twisted, row, contacts.twisted, place, same)
    hand_over(memory.touched, row, contacts.touched, place, same)
    return np.int64(row + np.uint64(same))


@njit(**OPTIONS)
def pad(contacts, fill, first, second):
    """Fill up to a multiple of the lane width with pairs that never touch, so that a block is whole vectors."""
    while fill % WIDTH:
        contacts.first[fill], contacts.second[fill] = first, second
        history.forget(contacts.stored, fill)
        history.forget(contacts.rolled, fill)
        history.forget(contacts.twisted, fill)
        history.forget(contacts.touched, fill)
        fill += 1
    return fill


@njit(**OPTIONS)
def ghost_of(j, scratch, base):
    """Place in the rows of this thread's copy of a disc that belongs to another thread."""
    if scratch.slot[j] < 0:
        count = scratch.counts[GHOSTS]
        if count >= scratch.ghost.size:
            return -1
        scratch.slot[j] = count
        scratch.ghost[count] = j
        scratch.counts[GHOSTS] = count + 1
    return base + scratch.slot[j]


@njit(**OPTIONS)
def enter(bodies, contacts, fill, i, j):
    """Write radii and reduced mass of a pair of the list where bodies differ, and which coefficients where those do."""
    if contacts.arm.size > 1:
        contacts.arm[fill], contacts.other[fill] = bodies.radius[i], bodies.radius[j]
        contacts.mass[fill] = 1.0 / (bodies.inverse_mass[i] + bodies.inverse_mass[j])
    if contacts.which.size > 1:
        contacts.which[fill] = set_of_pair(bodies.kind[i], bodies.kind[j])


@njit(**OPTIONS)
def is_near(bodies, skin, gap, i, j, scratch):
    """Whether bodies i and j are within reach of each other; notes one more than i where they are pressed half through."""
    (x, y, z), (xj, yj, zj) = place(bodies, i), place(bodies, j)
    own, other = bodies.radius[i if bodies.radius.size > 1 else 0], bodies.radius[j if bodies.radius.size > 1 else 0]
    square = (xj - x) * (xj - x) + (yj - y) * (yj - y) + (zj - z) * (zj - z)
    reach, least = own + other + skin[i // BLOCK] + skin[j // BLOCK] + gap, own + other - TOO_DEEP * min(own, other)
    if square < least * least:
        scratch.counts[PRESSED] = i + 1
    return square < reach * reach


@njit(**OPTIONS)
def sieve(bodies, contacts, skin, gap, i, scratch, begin, end, fill):
    """Write body i and each of its bodies of the wide list from `fill` on, and keep the near ones; gives the new end.

    Branches that nobody can foresee would cost more than writing those that are not kept.
    """
    (x, y, z), wide, equal = place(bodies, i), scratch.wide, bodies.radius.size == 1
    own, slot, pressed = bodies.radius[0 if equal else i], np.uint64(fill), scratch.counts[PRESSED]
    allowed = own + skin[i // BLOCK] + gap
    for t in range(np.uint64(begin), np.uint64(end)):
        j = np.uint64(wide[t])
        xj, yj, zj = place(bodies, j)
        other = bodies.radius[np.uint64(0) if equal else j]
        square = (xj - x) * (xj - x) + (yj - y) * (yj - y) + (zj - z) * (zj - z)
        reach, least = allowed + other + skin[j // np.uint64(BLOCK)], own + other - TOO_DEEP * min(own, other)
        pressed = i + 1 if square < least * least else pressed
        contacts.first[slot], contacts.second[slot] = i, j
        slot += np.uint64(square < reach * reach)
    scratch.counts[PRESSED] = pressed
    return np.int64(slot)


@njit(**OPTIONS)
def list_pairs(bodies, contacts, memory, blocks, scratch, gap, lo, hi, base):
    """List the near pairs of bodies lo to hi, then the pairs that reach back to earlier threads; False if room is short."""
    room, dummy = contacts.first.size - WIDTH, base + scratch.ghost.size
    scratch.slot[:] = -1
    scratch.counts[GHOSTS] = 0
    scratch.counts[PRESSED] = 0
    fill, spot, differ = 0, 0, contacts.arm.size > 1 or contacts.which.size > 1
    for i in range(lo, hi):
        if (i - lo) % BLOCK == 0:
            fill = pad(contacts, fill, dummy, dummy + 1)
            contacts.begin[(i - lo) // BLOCK] = fill
        begin, end = scratch.wide_begin[i - lo], scratch.wide_begin[i - lo + 1]
        if fill + end - begin > room:
            return False
        after = sieve(bodies, contacts, blocks.skin, gap, i, scratch, begin, end, fill)
        for k in range(fill, after):
            j = np.int64(contacts.second[k])
            if j >= hi:
                contacts.second[k] = ghost_of(j, scratch, base)
                if contacts.second[k] < 0:
                    return False
            if differ:
                enter(bodies, contacts, k, i, j)
            spot = recall(contacts, k, (np.int64(i) << SHIFT) | j, memory, spot)
        fill = after
    last = (hi - lo + BLOCK - 1) // BLOCK
    fill = pad(contacts, fill, dummy, dummy + 1)
    contacts.begin[last] = fill
    fill = list_crossing(bodies, contacts, memory, blocks, scratch, gap, fill, base)
    contacts.begin[last + 1] = pad(contacts, fill, dummy, dummy + 1)
    return fill >= 0


@njit(**OPTIONS)
def list_crossing(bodies, contacts, memory, blocks, scratch, gap, fill, base):
    """List the pairs whose first body belongs to an earlier thread; -1 if room is short."""
    crossing = scratch.cross[0]
    if fill + crossing > contacts.first.size - WIDTH:
        return -1
    spot = 0
    for k in range(1, crossing + 1):
        key = scratch.cross[k]
        i, j = key >> SHIFT, key & LOW
        if not is_near(bodies, blocks.skin, gap, i, j, scratch):
            continue
        first = ghost_of(i, scratch, base)
        if first < 0:
            return -1
        contacts.first[fill], contacts.second[fill] = first, j
        enter(bodies, contacts, fill, i, j)
        spot = recall(contacts, fill, key, memory, spot)
        fill += 1
    return fill


@njit(**OPTIONS)
def list_walls(bodies, near, memory, walls, blocks, scratch, gap, dummy):
    """List the bodies near each live wall, in the order (body, wall); False if room is short."""
    fill, spot, seams = 0, 0, 0
    for t in range(scratch.counts[WIDE_WALLS]):
        i, q = scratch.wide_body[t], scratch.wide_wall[t]
        radius = bodies.radius[i if bodies.radius.size > 1 else 0]
        reach, least = radius + blocks.skin[i // BLOCK] + gap, (1.0 - TOO_DEEP) * radius
        square = square_gap(bodies, walls.shape, q, i)
        if not walls.live[q] or square >= reach * reach:
            continue
        if square < least * least:
            scratch.counts[PRESSED] = i + 1
        if fill >= near.first.size - WIDTH:
            return False
        near.first[fill], near.second[fill] = i, q
        if near.arm.size > 1:
            near.arm[fill], near.mass[fill] = bodies.radius[i], bodies.mass[i]
        if near.which.size > 1:
            near.which[fill] = set_at_wall(bodies.kind[i if bodies.kind.size > 1 else 0], q, walls.live.size)
        spot = recall(near, fill, (np.int64(i) << SHIFT) | q, memory, spot)
        if fill > 0 and near.first[fill - 1] == i and goes_on_from(bodies, walls.shape, q, near.second[fill - 1]):
            scratch.seams[seams] = fill
            seams += 1
        fill += 1
    scratch.counts[SEAMS] = seams
    near.begin[0] = pad(near, fill, dummy, 0)
    return True


@njit(**OPTIONS)
def harvest(contacts, near, pair_memory, wall_memory, scratch, last, base):
    """Take the histories out of both lists into sorted memories; `last` is the number of blocks."""
    begin = contacts.begin
    count = remember(contacts, begin[last], begin[last + 1], base, scratch.ghost, pair_memory, 0)
    scratch.counts[KEPT_PAIRS] = remember(contacts, 0, begin[last], base, scratch.ghost, pair_memory, count)
    scratch.counts[KEPT_WALLS] = remember(near, 0, near.begin[0], BEHIND, scratch.ghost, wall_memory, 0)
