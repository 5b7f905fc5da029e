"""The wide list: which bodies may come near each other in the next hundreds of steps, from cells of space.

The list of near contacts is sieved from it, many times before it has to be made anew.
"""

import numpy as np
from numba import njit

from silostudy.dem.arrays import BLOCK
from silostudy.dem.body import place, square_gap
from silostudy.dem.cache import OPTIONS
from silostudy.dem.cells import bin_bodies, cell_of
from silostudy.dem.vectors import WIDTH, pick_eight

SHIFT = 32  # key = first << SHIFT | second
MOST = 0.4  # of the smallest radius: largest way that a body may travel before the next list
LEAST = 0.004  # of the smallest radius: the smallest
LOOK_FAR = 300.0  # steps that a wide list should last
WIDE_MOST = 0.5  # of the smallest radius: largest way before the next wide list
WIDE_LEAST = 0.04  # of the smallest radius: the smallest
FEW = 32  # numbers that are ranked rather than sorted
GHOSTS, KEPT_PAIRS, KEPT_WALLS, PRESSED, WIDE_WALLS, SEAMS = range(6)  # places in Scratch.counts


@njit(**OPTIONS)
def allow(blocks, block_from, block_to, ahead, smallest, fixed_skin):
    """Choose the distance (m) that the bodies of each block may travel before the next list: from their speed now."""
    for b in range(block_from, block_to):
        foreseen = min(ahead * blocks.peak[b] + LEAST * smallest, MOST * smallest)
        blocks.skin[b] = 0.5 * fixed_skin if fixed_skin > 0.0 else foreseen
        blocks.wide_travel[b] += blocks.travel[b]
        blocks.travel[b] = 0.0


@njit(**OPTIONS)
def allow_wide(blocks, block_from, block_to, smallest):
    """Choose the distance (m) that the bodies of each block may travel before the next wide list."""
    for b in range(block_from, block_to):
        foreseen = min(LOOK_FAR * blocks.peak[b] + WIDE_LEAST * smallest, WIDE_MOST * smallest)
        blocks.wide_skin[b] = max(foreseen, 1.5 * blocks.skin[b])
        blocks.wide_travel[b] = 0.0


@njit(**OPTIONS)
def wide_holds(blocks, count):
    """Whether the wide list has all bodies that the next list of near contacts may call for."""
    holds = True
    for b in range(count):
        holds = holds and blocks.wide_travel[b] + blocks.skin[b] <= blocks.wide_skin[b]
    return holds


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
            key, spot = keys[k], k
            while spot >= begin + gap and keys[spot - gap] > key:
                keys[spot] = keys[spot - gap]
                spot -= gap
            keys[spot] = key
        gap //= 2


@njit(**OPTIONS)
def put_in_order(bodies, skin, n, scratch):
    """Copy place (m) and reach (m) of the first n bodies in the order of their cells, where a search reads them in a row."""
    for t in range(n):
        i = scratch.order[t]
        scratch.near[0, t], scratch.near[1, t], scratch.near[2, t] = place(bodies, i)
        scratch.near[3, t] = bodies.radius[i if bodies.radius.size > 1 else 0] + skin[i // BLOCK]


@njit(**OPTIONS)
def near_bodies(bodies, skin, gap, i, lo, grid, scratch):
    """Bodies after i, or before `lo`, within reach of it, cell by cell, into scratch.close; gives how many, be they
    more than it has room for.

    Each candidate is written, and counted if it is one: a branch that nobody can foresee costs more than ten of them.
    """
    (x0, y0, z0), size, (nx, ny, nz) = grid
    listed, order, near = scratch.close, scratch.order, scratch.near
    x, y, z = place(bodies, i)
    cx, cy, cz = cell_of(x, x0, size, nx), cell_of(y, y0, size, ny), cell_of(z, z0, size, nz)
    own = bodies.radius[i if bodies.radius.size > 1 else 0] + skin[i // BLOCK] + gap
    left, right, count, last = max(cx - 1, 0), min(cx + 2, nx), 0, listed.size - WIDTH
    for layer in range(max(cz - 1, 0), min(cz + 2, nz)):
        for row in range(max(cy - 1, 0), min(cy + 2, ny)):
            start = (layer * ny + row) * nx
            begin, end = np.int64(scratch.cell_begin[start + left]), np.int64(scratch.cell_begin[start + right])
            for t in range(begin, end, WIDTH):
                count += pick_eight(near, order, t, end, (x, y, z), own, i, lo, listed, min(count, last))
    return count


@njit(**OPTIONS)
def take_near(scratch, count, i, lo, fill):
    """Enter those found into the wide list from `fill` on, in order; pairs with a body before `lo` go to scratch.cross."""
    listed, later, crossing = scratch.close, 0, scratch.cross[0]
    for c in range(count):
        j = listed[c]
        if j < lo:
            crossing += 1
            if crossing < scratch.cross.size:
                scratch.cross[crossing] = (np.int64(j) << SHIFT) | i
            continue
        listed[later] = j
        later += 1
    scratch.cross[0] = crossing
    if later <= FEW:
        rank(listed, later, scratch.wide, fill)
        return fill + later
    sort(listed, 0, later)
    for c in range(later):
        scratch.wide[fill + c] = listed[c]
    return fill + later


@njit(**OPTIONS)
def rank(numbers, count, into, fill):
    """Write different numbers in order: each behind as many as are smaller, which asks no branch that nobody foresees."""
    for c in range(count):
        number, smaller = numbers[c], 0
        for d in range(count):
            smaller += numbers[d] < number
        into[fill + smaller] = number


@njit(**OPTIONS)
def list_wide(bodies, walls, blocks, scratch, gap, n, lo, hi):
    """List for each body from lo to hi the later ones that may come near it, and the walls; False if room is short."""
    widest = largest_of(blocks.wide_skin, (n + BLOCK - 1) // BLOCK)
    largest = largest_of(bodies.radius, min(n, bodies.radius.size))
    grid = bin_bodies(bodies, n, 2.0 * (largest + widest) + gap, scratch.cell_begin, scratch.order)
    put_in_order(bodies, blocks.wide_skin, n, scratch)
    scratch.cross[0] = 0
    fill = 0
    for i in range(lo, hi):
        scratch.wide_begin[i - lo] = fill
        count = near_bodies(bodies, blocks.wide_skin, gap, i, lo, grid, scratch)
        if fill + count > scratch.wide.size or count > scratch.close.size - WIDTH:
            return False
        fill = take_near(scratch, count, i, lo, fill)
    scratch.wide_begin[hi - lo] = fill
    if scratch.cross[0] >= scratch.cross.size:
        return False
    sort(scratch.cross, 1, scratch.cross[0] + 1)
    return list_wide_walls(bodies, walls, blocks, scratch, gap, lo, hi)


@njit(**OPTIONS)
def list_wide_walls(bodies, walls, blocks, scratch, gap, lo, hi):
    """List the walls, standing or not, that bodies from lo to hi may come near; False if room is short."""
    fill = 0
    for i in range(lo, hi):
        reach = bodies.radius[i if bodies.radius.size > 1 else 0] + blocks.wide_skin[i // BLOCK] + gap
        for q in range(walls.live.size):
            if square_gap(bodies, walls.shape, q, i) >= reach * reach:
                continue
            if fill >= scratch.wide_body.size:
                return False
            scratch.wide_body[fill], scratch.wide_wall[fill] = i, q
            fill += 1
    scratch.counts[WIDE_WALLS] = fill
    return True
