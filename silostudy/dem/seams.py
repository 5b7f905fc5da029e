"""Seams of a floor of discs: its pieces meet there while outlets are shut, and springs go on over them.

So the floor of several pieces is to discs what it is as one, to the bit.
"""

from numba import njit

from silostudy.dem import history
from silostudy.dem.cache import OPTIONS
from silostudy.dem.lanes import X, Y
from silostudy.dem.walls import is_beyond
from silostudy.dem.wide import SEAMS


@njit(**OPTIONS)
def carry_over(rows, shape, near, scratch):
    """Give histories of discs that have come over a seam to the piece that pushes there, of both that are listed."""
    for s in range(scratch.counts[SEAMS]):
        after = scratch.seams[s]
        i, before = near.first[after], after - 1
        beyond = is_beyond(shape, near.second[after], rows[i, X], rows[i, Y])
        old, new = (before, after) if beyond else (after, before)
        if is_held(near, old):
            pass_on(near.stored, old, new)
            pass_on(near.rolled, old, new)
            pass_on(near.twisted, old, new)
            pass_on(near.touched, old, new)


@njit(**OPTIONS)
def is_held(contacts, k):
    """Whether contact k of a list has a history."""
    sprung = history.holds(history.entry(contacts.stored, k)) | history.holds(history.entry(contacts.rolled, k))
    return sprung | history.holds(history.entry(contacts.twisted, k)) | history.holds(history.entry(contacts.touched, k))


@njit(**OPTIONS)
def pass_on(held, old, new):
    """Move a history from one contact of a list to another."""
    history.enter(held, new, history.entry(held, old))
    history.forget(held, old)
