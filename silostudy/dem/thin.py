"""Bodies taken out of the wide list, which need not be made anew for those that are left."""

from numba import njit

from silostudy.dem.arrays import BLOCK
from silostudy.dem.cache import OPTIONS
from silostudy.dem.wide import WIDE_WALLS


@njit(**OPTIONS)
def thin_wide(blocks, scratch, staying, number, n):
    """Take bodies out of a wide list of one thread's first n; number (n) gives those that stay their new numbers."""
    fill, begin = 0, scratch.wide_begin[0]
    for i in range(n):
        end = scratch.wide_begin[i + 1]
        if staying[i]:
            for t in range(begin, end):
                j = scratch.wide[t]
                scratch.wide[fill] = number[j]
                fill += staying[j]
            scratch.wide_begin[number[i] + 1] = fill
            join_block(blocks, number[i], i // BLOCK)
        begin = end
    walls = 0
    for t in range(scratch.counts[WIDE_WALLS]):
        i = scratch.wide_body[t]
        scratch.wide_body[walls], scratch.wide_wall[walls] = number[i], scratch.wide_wall[t]
        walls += staying[i]
    scratch.counts[WIDE_WALLS] = walls


@njit(**OPTIONS)
def join_block(blocks, i, old):
    """Let the block of body i, which came from an old block, allow no more than both."""
    b, begins = i // BLOCK, i % BLOCK == 0
    for longest in (blocks.peak, blocks.travel, blocks.wide_travel):
        longest[b] = longest[old] if begins else max(longest[b], longest[old])
    blocks.wide_skin[b] = blocks.wide_skin[old] if begins else min(blocks.wide_skin[b], blocks.wide_skin[old])
