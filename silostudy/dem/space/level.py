"""Level surfaces of a scene of spheres: pieces inside an outline and outside a hole, and the rims of rectangular holes."""

from dataclasses import dataclass
from math import cos, hypot, pi, sin, tan

import numpy as np

from silostudy.dem.space.surfaces import (
    ACROSS,
    CIRCLE,
    COLUMNS,
    HEIGHT,
    HOLE,
    LEVEL,
    NO_HOLE,
    OUTLINE,
    RECTANGLE,
    RIM,
    UPWARD,
    WAY,
)
from silostudy.dem.space.walls import Surface
from silostudy.errors import BadInput


@dataclass(frozen=True, kw_only=True)
class Outline:
    """A closed line in a level plane: a circle, a rectangle, or a regular polygon with a side that faces x.

    sides: 0 a circle, 4 a rectangle; middle: its x and y (m); half: half its widths along x and y (m); of a circle or
    polygon both are the radius of the circle inside it.
    """

    sides: int
    half: tuple[float, float]
    middle: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self):
        if self.sides not in (CIRCLE, RECTANGLE) and (self.sides < 3 or self.half[0] != self.half[1]):
            raise BadInput("sides", self.sides, "an outline is a circle, a rectangle or a regular polygon of 3 sides or more")
        if not np.isfinite([*self.half, *self.middle]).all() or min(self.half) < 0.0:
            raise BadInput("half", self.half, "half widths must be finite, none negative")

    @property
    def row(self) -> tuple[float, ...]:
        """Its five numbers in a surface's row."""
        return (self.sides, *self.middle, *self.half)

    @property
    def normals(self) -> list[tuple[float, float]]:
        """Outward unit normals of its sides, counter-clockwise from the side that faces x."""
        return [(cos(2.0 * pi * k / self.sides), sin(2.0 * pi * k / self.sides)) for k in range(self.sides)]

    @property
    def corners(self) -> list[tuple[float, float]]:
        """Corners (m): each side runs from the corner of its number to the next."""
        (x, y), (a, b) = self.middle, self.half
        if self.sides == RECTANGLE:
            return [(x + a, y - b), (x + a, y + b), (x - a, y + b), (x - a, y - b)]
        wide, part = a / cos(pi / self.sides), 2.0 * pi / self.sides
        return [(x + wide * cos(part * (k - 0.5)), y + wide * sin(part * (k - 0.5))) for k in range(self.sides)]

    @property
    def area(self) -> float:
        """Area (m2)."""
        if self.sides == CIRCLE:
            return pi * self.half[0] ** 2
        if self.sides == RECTANGLE:
            return 4.0 * self.half[0] * self.half[1]
        return self.sides * self.half[0] ** 2 * tan(pi / self.sides)

    def inset(self, x, y):
        """How far (m) inside it (x, y) stands, the least over its sides; negative outside."""
        x, y = x - self.middle[0], y - self.middle[1]
        if self.sides == CIRCLE:
            return self.half[0] - np.hypot(x, y)
        if self.sides == RECTANGLE:
            return np.minimum(self.half[0] - abs(x), self.half[1] - abs(y))
        return self.half[0] - np.max([x * a + y * b for a, b in self.normals], axis=0)

    def reach(self, way: tuple[float, float]) -> float:
        """Distance (m) from the origin to its farthest point along a unit vector."""
        if self.sides == CIRCLE:
            return self.middle[0] * way[0] + self.middle[1] * way[1] + self.half[0]
        return max(x * way[0] + y * way[1] for x, y in self.corners)

    def room_for(self, other: "Outline") -> float:
        """Least distance (m) from this outline, about the origin, to another inside it; negative where that leaves it."""
        if self.sides != CIRCLE:
            spans = self.half * 2 if self.sides == RECTANGLE else self.half[:1] * self.sides
            return min(span - other.reach(way) for span, way in zip(spans, self.normals, strict=True))
        if other.sides == CIRCLE:
            return self.half[0] - hypot(*other.middle) - other.half[0]
        return self.half[0] - max(hypot(*corner) for corner in other.corners)

    @property
    def box(self) -> np.ndarray:
        """Opposite corners (2, 2) of a box around it, m."""
        x, y = self.middle
        a, b = self.half if self.sides in (CIRCLE, RECTANGLE) else (self.half[0] / cos(pi / self.sides),) * 2
        return np.array([(x - a, y - b), (x + a, y + b)])


def framed(row: np.ndarray, upward: tuple, heights: tuple, across: tuple, widths: tuple) -> np.ndarray:
    """The row with the unit vectors that its cells run along, each with the least coordinate and the length (m) along it."""
    row[UPWARD : UPWARD + 5], row[ACROSS : ACROSS + 5] = (*upward, *heights), (*across, *widths)
    return row


@dataclass(frozen=True, kw_only=True)
class LevelPiece(Surface):
    """What lies in a level plane inside an outline, all of it joined to other surfaces, and outside a hole.

    A circular hole pushes as an edge; the sides of a rectangular one are rims.  Cells along run with y, cells around with x.
    """

    height: float
    outline: Outline
    hole: Outline | None = None

    @property
    def shape(self) -> np.ndarray:
        """Its row."""
        row, ((x, y), (right, back)) = np.zeros(COLUMNS), self.outline.box
        row[0], row[HEIGHT], row[OUTLINE : OUTLINE + 5] = LEVEL, self.height, self.outline.row
        row[HOLE : HOLE + 5] = self.hole.row if self.hole else NO_HOLE
        return framed(row, (0.0, 1.0, 0.0), (y, back - y), (1.0, 0.0, 0.0), (x, right - x))

    @property
    def corners(self) -> np.ndarray:
        """Corners (n, 3) of a box around it, m."""
        return np.column_stack([self.outline.box, [self.height] * 2])


@dataclass(frozen=True, kw_only=True)
class Rim(Surface):
    """One side of a rectangular hole in a level piece: a line that pushes spheres whose middle is over the hole.

    side: 0 the one that faces x, the others counter-clockwise.  Cells around run along it.
    """

    height: float
    hole: Outline
    side: int

    @property
    def shape(self) -> np.ndarray:
        """Its row."""
        row, way = np.zeros(COLUMNS), ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[self.side]
        row[0], row[HEIGHT], row[HOLE : HOLE + 5] = RIM, self.height, self.hole.row
        row[WAY : WAY + 3] = *way, self.hole.half[self.side % 2]
        along, length = (-way[1], way[0], 0.0), 2.0 * self.hole.half[1 - self.side % 2]
        first = along[0] * self.hole.middle[0] + along[1] * self.hole.middle[1] - 0.5 * length
        return framed(row, (0.0, 0.0, 1.0), (self.height, 1.0), along, (first, length))

    @property
    def corners(self) -> np.ndarray:
        """Its two ends, m."""
        ends = [self.hole.corners[self.side], self.hole.corners[(self.side + 1) % 4]]
        return np.column_stack([ends, [self.height] * 2])
