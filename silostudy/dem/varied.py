"""Contacts of one set of laws whose coefficients differ: by the kinds of two bodies, or by a body's kind and the wall.

Each of these sets of coefficients has a number, by which a list's contacts name theirs.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numba.extending import register_jitable

from silostudy.contact import Law
from silostudy.dem.cache import piece
from silostudy.dem.contacts import Contact
from silostudy.dem.dimension import Dimension
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput


@register_jitable
def set_of_pair(kind, other):
    """Number of the set of coefficients between two kinds of bodies, the same either way."""
    high, low = np.maximum(kind, other), np.minimum(kind, other)
    return high * (high + 1) // 2 + low


@register_jitable
def set_at_wall(kind, wall, walls):
    """Number of the set of coefficients of a kind of bodies at a wall, of so many walls."""
    return kind * walls + wall


@dataclass(frozen=True)
class Varied:
    """Contacts of the same laws in the order of their numbers."""

    sets: tuple[Contact, ...]

    def __post_init__(self):
        for contact in self.sets:
            if contact.laws != self.laws:
                raise BadInput("laws", contact.laws, "all contacts of pairs, or of walls, have the same laws")

    @property
    def laws(self) -> Laws:
        """The laws of all of them."""
        return self.sets[0].laws

    @property
    def rows(self) -> tuple[Law, ...]:
        """Rows of the laws."""
        return self.laws.rows

    def numbered(self, number: int) -> Contact:
        """The contact of a number."""
        return self.sets[number]

    @cached_property
    def ordered(self) -> np.ndarray:
        """Coefficients of each contact, law after law, in the order that their functions take."""
        return np.array([[value for law in contact.ordered for value in law] for contact in self.sets])

    def gap(self, radius: float) -> float:
        """Largest gap (m) across which two bodies that have touched hold on, of a reduced radius (m)."""
        return max(contact.gap(radius) for contact in self.sets)

    def scaled(self, *, stiffness: float, damping: float) -> "Varied":
        """The same laws with springs and dashpots stronger by these factors."""
        return Varied(tuple(contact.scaled(stiffness=stiffness, damping=damping) for contact in self.sets))

    def changed(self, values: Mapping[str, float], which: Iterable[int] | None = None) -> "Varied":
        """A copy with other values of coefficients, in all sets or in some."""
        numbers = set(range(len(self.sets)) if which is None else which)
        return replace(
            self,
            sets=tuple(contact.changed(values) if number in numbers else contact for number, contact in enumerate(self.sets)),
        )


def coefficients_pass(space: Dimension, laws: Laws, *, varied: bool):
    """Functions that bring the coefficients of a stretch's contacts into lanes, and that give those of contact k.

    Where all contacts have the same there is nothing to bring, and they are what is given.
    """
    if not varied:
        return _nothing_brought, _as_given
    stretch, counts = space.stretch, [len(row.coefficients) for row in laws.rows]
    first = [sum(counts[:n]) for n in range(len(counts))]
    normal, tangential, rolling, cohesion, twisting = (
        _numbers(n, count, stretch) for n, count in zip(first, counts, strict=True)
    )

    @piece("coefficients", laws, stretch)
    def own(c, k):
        lanes = c.lanes
        return normal(lanes, k), tangential(lanes, k), rolling(lanes, k), cohesion(lanes, k), twisting(lanes, k)

    return _bringing(stretch), own


def _bringing(stretch: int):
    @piece("coefficients", stretch)
    def bring(c, which, start, count):
        values, lanes = c.values, c.lanes
        for n in range(values.shape[1]):
            for k in range(count):
                lanes[n * stretch + k] = values[which[start + k], n]

    return bring


@piece("coefficients")
def _nothing_brought(c, which, start, count):
    pass


@piece("coefficients")
def _as_given(c, k):
    return c


def _numbers(first: int, count: int, stretch: int):
    """Function that gives so many numbers of contact k, which stand in lanes after each other; their places are constants."""
    if not count:
        return _no_numbers
    place, others = first * stretch, _numbers(first + 1, count - 1, stretch)

    @piece("coefficients", first, count, stretch)
    def numbers(lanes, k):
        return (lanes[place + k], *others(lanes, k))

    return numbers


@piece("coefficients", 0)
def _no_numbers(lanes, k):
    return ()
