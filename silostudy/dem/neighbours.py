"""The list of near contacts: made anew when a disc has moved beyond its allowance, carrying the histories over.

What the list holds beyond the touching contacts never changes a result: forces of contacts that do not touch are zero,
and the order of the others is fixed by the numbers of the bodies.
"""

import numpy as np
from numba import njit

from silostudy.dem import history
from silostudy.dem.arrays import BLOCK
from silostudy.dem.body import place, square_gap
from silostudy.dem.cache import OPTIONS
from silostudy.dem.cells import bin_bodies, cell_of
from silostudy.dem.vectors import WIDTH

SHIFT = 32  # key = first << SHIFT | second
LOW = (1 << SHIFT) - 1
LOOK_AHEAD = 48.0  # steps that a list should last at the speed of its discs
MOST, LEAST = 0.4, 0.004  # of the smallest radius: limits of a disc's allowance
TOO_DEEP = 0.5  # of the smaller radius: discs or walls that overlap by more are no longer in touch but pressed through
GHOSTS, KEPT_PAIRS, KEPT_WALLS, PRESSED = range(4)  # places in Scratch.counts


@njit(**OPTIONS)
def allow(blocks, block_from, block_to, smallest, fixed_skin):
    """Choose the distance (m) that the discs of each block may travel before the next list: from their speed now."""
    for b in range(block_from, block_to):
        foreseen = min(LOOK_AHEAD * blocks.peak[b] + LEAST * smallest, MOST * smallest)
        blocks.skin[b] = 0.5 * fixed_skin if fixed_skin > 0.0 else foreseen
        blocks.travel[b] = 0.0


@njit(**OPTIONS)
def remember(contacts, begin, end, base, ghost, memory, kept):
    """Append the histories of a stretch of the list that are not zero to the memory; gives the new count."""
    for k in range(begin, end):
        held, turned = history.entry(contacts.stored, k), history.entry(contacts.rolled, k)
        if history.holds(held) or history.holds(turned):
            first, second = np.int64(contacts.first[k]), np.int64(contacts.second[k])
            first = np.int64(ghost[first - base]) if first >= base else first
            second = np.int64(ghost[second - base]) if second >= base else second
            memory.key[kept] = (first << SHIFT) | second
            history.enter(memory.stored, kept, held)
            history.enter(memory.rolled, kept, turned)
            kept += 1
    return kept


@njit(**OPTIONS)
def hand_over(old, at, new, place, same):
    """Give an entry of a list what the memory holds at a place, or nothing where it is of another contact."""
    if same:
        history.enter(new, place, history.entry(old, at))
    else:
        history.forget(new, place)


@njit(**OPTIONS)
def recall(contacts, place, key, memory, kept, at):
    """Give a new list entry the history of its key, or none; the keys come in order, so the search goes on from `at`."""
    while at < kept and memory.key[at] < key:
        at += 1
    same = at < kept and memory.key[at] == key
    hand_over(memory.stored, at, contacts.stored, place, same)
    hand_over(memory.rolled, at, contacts.rolled, place, same)
    return at


@njit(**OPTIONS)
def pad(contacts, fill, first, second):
    """Fill up to a multiple of the lane width with pairs that never touch, so that a block is whole vectors."""
    while fill % WIDTH:
        contacts.first[fill], contacts.second[fill] = first, second
        history.forget(contacts.stored, fill)
        history.forget(contacts.rolled, fill)
        fill += 1
    return fill


@njit(**OPTIONS)
def near_bodies(bodies, skin, i, lo, grid, scratch):
    """Bodies after i within reach of it, in order; pairs with a body before `lo` go to scratch.cross. Gives how many.

    A body that another is pressed half through is noted, one more than its number.
    """
    (x0, y0, z0), size, (nx, ny, nz) = grid
    found, radius = scratch.found, bodies.radius
    x, y, z = place(bodies, i)
    cx, cy, cz = cell_of(x, x0, size, nx), cell_of(y, y0, size, ny), cell_of(z, z0, size, nz)
    own = radius[i if radius.size > 1 else 0]
    reach_i = own + skin[i // BLOCK]
    count, crossing = 0, scratch.cross[0]
    rows, layers = min(cy + 2, ny) - max(cy - 1, 0), min(cz + 2, nz) - max(cz - 1, 0)
    for turn in range(layers * rows):
        row = (max(cz - 1, 0) + turn // rows) * ny + max(cy - 1, 0) + turn % rows
        begin = scratch.cell_begin[row * nx + max(cx - 1, 0)]
        end = scratch.cell_begin[row * nx + min(cx + 2, nx)]
        for t in range(begin, end):
            j = scratch.order[t]
            if lo <= j <= i:
                continue
            other = radius[j if radius.size > 1 else 0]
            reach = reach_i + other + skin[j // BLOCK]
            xj, yj, zj = place(bodies, j)
            square = (xj - x) * (xj - x) + (yj - y) * (yj - y) + (zj - z) * (zj - z)
            if square >= reach * reach:
                continue
            least = own + other - TOO_DEEP * min(own, other)
            if square < least * least:
                scratch.counts[PRESSED] = i + 1
            if j < lo:
                crossing += 1
                if crossing < scratch.cross.size:
                    scratch.cross[crossing] = (np.int64(j) << SHIFT) | i
            elif count < found.size:
                k = count
                while k > 0 and found[k - 1] > j:
                    found[k] = found[k - 1]
                    k -= 1
                found[k] = j
                count += 1
    scratch.cross[0] = crossing
    return count


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
def enter(bodies, contacts, fill, i, j, first, second):
    """Write one pair of the list, with its radii and reduced mass where discs differ."""
    contacts.first[fill], contacts.second[fill] = first, second
    if contacts.arm.size > 1:
        contacts.arm[fill], contacts.other[fill] = bodies.radius[i], bodies.radius[j]
        contacts.mass[fill] = 1.0 / (bodies.inverse_mass[i] + bodies.inverse_mass[j])


@njit(**OPTIONS)
def largest_of(values, count):
    """Largest of the first values."""
    most = values[0]
    for k in range(count):
        most = max(most, values[k])
    return most


@njit(**OPTIONS)
def sort(keys, begin, end):
    """Sort a stretch of keys in place (Shell's method: nothing is allocated while a scene runs)."""
    gap = (end - begin) // 2
    while gap > 0:
        for k in range(begin + gap, end):
            key, at = keys[k], k
            while at >= begin + gap and keys[at - gap] > key:
                keys[at] = keys[at - gap]
                at -= gap
            keys[at] = key
        gap //= 2


@njit(**OPTIONS)
def list_pairs(bodies, contacts, memory, blocks, scratch, n, lo, hi, base):
    """List the near pairs of discs lo to hi, then the pairs that reach back to earlier threads; False if room is short."""
    widest = largest_of(blocks.skin, (n + BLOCK - 1) // BLOCK)
    largest = largest_of(bodies.radius, min(n, bodies.radius.size))
    grid = bin_bodies(bodies, n, 2.0 * (largest + widest), scratch.cell_begin, scratch.order)
    kept, room, dummy = scratch.counts[KEPT_PAIRS], contacts.first.size - WIDTH, base + scratch.ghost.size
    scratch.slot[:] = -1
    scratch.counts[GHOSTS] = 0
    scratch.counts[PRESSED] = 0
    scratch.cross[0] = 0
    fill, at = 0, 0
    for i in range(lo, hi):
        if (i - lo) % BLOCK == 0:
            fill = pad(contacts, fill, dummy, dummy + 1)
            contacts.begin[(i - lo) // BLOCK] = fill
        count = near_bodies(bodies, blocks.skin, i, lo, grid, scratch)
        if fill + count > room or count == scratch.found.size:
            return False
        for c in range(count):
            j = scratch.found[c]
            second = j if j < hi else ghost_of(j, scratch, base)
            if second < 0:
                return False
            enter(bodies, contacts, fill, i, j, i, second)
            at = recall(contacts, fill, (np.int64(i) << SHIFT) | j, memory, kept, at)
            fill += 1
    last = (hi - lo + BLOCK - 1) // BLOCK
    fill = pad(contacts, fill, dummy, dummy + 1)
    contacts.begin[last] = fill
    fill = list_crossing(bodies, contacts, memory, scratch, fill, base)
    contacts.begin[last + 1] = pad(contacts, fill, dummy, dummy + 1)
    return fill >= 0


@njit(**OPTIONS)
def list_crossing(bodies, contacts, memory, scratch, fill, base):
    """List the pairs whose first disc belongs to an earlier thread; -1 if room is short."""
    crossing = scratch.cross[0]
    if crossing >= scratch.cross.size or fill + crossing > contacts.first.size - WIDTH:
        return -1
    sort(scratch.cross, 1, crossing + 1)
    at = 0
    for k in range(1, crossing + 1):
        key = scratch.cross[k]
        i, j = key >> SHIFT, key & 0xFFFFFFFF
        first = ghost_of(i, scratch, base)
        if first < 0:
            return -1
        enter(bodies, contacts, fill, i, j, first, j)
        at = recall(contacts, fill, key, memory, scratch.counts[KEPT_PAIRS], at)
        fill += 1
    return fill


@njit(**OPTIONS)
def list_walls(bodies, near, memory, walls, blocks, scratch, lo, hi, dummy):
    """List the discs lo to hi near each live wall, in the order (disc, wall); False if room is short."""
    fill, at, kept = 0, 0, scratch.counts[KEPT_WALLS]
    for i in range(lo, hi):
        radius = bodies.radius[i if bodies.radius.size > 1 else 0]
        reach, least = radius + blocks.skin[i // BLOCK], (1.0 - TOO_DEEP) * radius
        for q in range(walls.live.size):
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
            at = recall(near, fill, (np.int64(i) << SHIFT) | q, memory, kept, at)
            fill += 1
    near.begin[0] = pad(near, fill, dummy, 0)
    return True


@njit(**OPTIONS)
def harvest(contacts, near, pair_memory, wall_memory, scratch, last, base):
    """Take the histories out of both lists into sorted memories; `last` is the number of blocks."""
    begin, never = contacts.begin, np.int64(1) << 62
    kept = remember(contacts, begin[last], begin[last + 1], base, scratch.ghost, pair_memory, 0)
    scratch.counts[KEPT_PAIRS] = remember(contacts, 0, begin[last], base, scratch.ghost, pair_memory, kept)
    scratch.counts[KEPT_WALLS] = remember(near, 0, near.begin[0], never, scratch.ghost, wall_memory, 0)
