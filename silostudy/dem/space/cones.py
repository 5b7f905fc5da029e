"""Eccentric cones of a scene of spheres: hoppers of a circular silo whose outlet lies off its axis."""

from dataclasses import dataclass
from math import hypot

import numpy as np

from silostudy.dem.space.rows import (
    ALONG_R,
    ALONG_Z,
    AXIS_X,
    ECCENTRIC,
    END_END,
    JOINED,
    LEAN_X,
    MORE,
    START_END,
    START_R,
    START_Z,
)
from silostudy.dem.space.walls import Surface
from silostudy.errors import BadInput


@dataclass(frozen=True, kw_only=True)
class EccentricCone(Surface):
    """Level circles whose middles and radii go evenly from a lower to an upper one, which has the lower one inside, seen from
    above.

    start, end: radius and height (m) of both; foot, head: x and y (m) of their middles.  Cells along run upward, of equal
    heights; cells around from the x axis towards y, about the middle of their level.  An end that is joined to another surface
    does not push as an edge.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    foot: tuple[float, float]
    head: tuple[float, float] = (0.0, 0.0)
    joined: tuple[bool, bool] = (False, False)

    def __post_init__(self):
        super().__post_init__()
        if not (0.0 <= self.start[0] < self.end[0] and self.start[1] < self.end[1]):
            raise BadInput(self.name, (self.start, self.end), "must widen upward, from a radius that is not negative")
        if hypot(*self.lean) > self.rise[0] * (1.0 + 1e-12):
            raise BadInput(self.name, self.foot, "the lower circle must not reach out over the upper one")

    @property
    def lean(self) -> tuple[float, float]:
        """Way (m) of the circles' middles from the foot to the head, level."""
        return self.head[0] - self.foot[0], self.head[1] - self.foot[1]

    @property
    def rise(self) -> tuple[float, float]:
        """Growth of the radius, and height (m)."""
        return self.end[0] - self.start[0], self.end[1] - self.start[1]

    @property
    def shape(self) -> np.ndarray:
        """The row of numbers that kernels read."""
        row, (wide, high) = np.zeros(MORE), self.rise
        row[0], row[AXIS_X : AXIS_X + 2], row[START_R], row[START_Z] = ECCENTRIC, self.foot, *self.start
        row[ALONG_R], row[ALONG_Z], row[LEAN_X : LEAN_X + 2] = wide, high, self.lean
        row[[START_END, END_END]] = [JOINED if joined else 0.0 for joined in self.joined]
        return row

    def covers(self, places: np.ndarray) -> np.ndarray:
        """Mask of places (n, 3) that stand over or under its widest circle."""
        return np.hypot(*(places[:, :2] - self.head).T) <= self.end[0]

    @property
    def corners(self) -> np.ndarray:
        """Corners (n, 3) of a box around it, m."""
        (x, y), wide = self.head, self.end[0]
        return np.array([(x - wide, y - wide, self.start[1]), (x + wide, y + wide, self.end[1])])
