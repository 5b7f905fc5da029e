"""Level surfaces of a scene of spheres: pieces inside an outline and outside their holes."""

from dataclasses import dataclass
from math import cos, hypot, nan, pi, sin, sqrt, tan

import numpy as np

from silostudy.dem.space.rows import (
    ACROSS,
    CIRCLE,
    FULL,
    GROWTH,
    HEIGHT,
    HOLES,
    LEVEL,
    MORE,
    OPEN,
    OUTLINE,
    PER_HOLE,
    RECTANGLE,
    RIM,
    UPWARD,
)
from silostudy.dem.space.walls import Surface, TurnedLine
from silostudy.errors import BadInput

ENDLESS = 1e9  # m: half length of a hole that runs from wall to wall


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
        """The five numbers of it in a surface's row."""
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
        """Distance (m) of (x, y) inside it, the least over its sides; negative outside."""
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

    def crossed_by(self, other: "Outline") -> tuple[bool, bool]:
        """Whether another outline inside it runs from side to side along x, and along y."""
        return other.half[0] >= self.half[0], other.half[1] >= self.half[1]

    def room_for(self, other: "Outline") -> float:
        """Least distance (m) from this outline, about the origin, to another inside it; negative where that leaves it."""
        if self.sides != CIRCLE:
            spans = self.half * 2 if self.sides == RECTANGLE else self.half[:1] * self.sides
            return min(span - other.reach(way) for span, way in zip(spans, self.normals, strict=True))
        if other.sides == CIRCLE:
            return self.half[0] - hypot(*other.middle) - other.half[0]
        return self.half[0] - max(hypot(*corner) for corner in other.corners)

    def gap_to(self, other: "Outline") -> float:
        """Distance (m) to another circle or rectangle beside it; negative where they overlap, when it is no distance."""
        apart = np.abs(np.subtract(self.middle, other.middle))
        cores = [0.0 if of.sides == CIRCLE else np.array(of.half) for of in (self, other)]
        beyond = apart - cores[0] - cores[1]
        away = float(np.hypot(*np.maximum(beyond, 0.0))) or float(beyond.max())
        return away - sum(of.half[0] for of in (self, other) if of.sides == CIRCLE)

    @property
    def chord(self) -> tuple[float, float]:
        """Ends (m) of the cut of a circle or a rectangle along the x axis; NaN where it does not reach that."""
        (x, y), (a, b) = self.middle, self.half
        inside = a * a - y * y if self.sides == CIRCLE else (a * a if abs(y) < b else -1.0)
        half = sqrt(inside) if inside > 0.0 else nan
        return x - half, x + half

    @property
    def box(self) -> np.ndarray:
        """Opposite corners (2, 2) of a box around it, m."""
        x, y = self.middle
        a, b = self.half if self.sides in (CIRCLE, RECTANGLE) else (self.half[0] / cos(pi / self.sides),) * 2
        return np.array([(x - a, y - b), (x + a, y + b)])


@dataclass(frozen=True, kw_only=True)
class Hole:
    """A hole in a level piece, shut until it is opened."""

    name: str
    outline: Outline


@dataclass(frozen=True, kw_only=True)
class LevelPiece(Surface):
    """Level surface inside an outline, all of which is joined to other surfaces, and outside its open holes.

    A hole as long or as wide as the outline runs from wall to wall: it has no ends there.  Cells along run with y, cells around
    with x.
    """

    height: float
    outline: Outline
    holes: tuple[Hole, ...] = ()

    @property
    def outlets(self) -> tuple[str, ...]:
        """Names of its holes."""
        return tuple(hole.name for hole in self.holes)

    @property
    def shape(self) -> np.ndarray:
        """The row of numbers that kernels read."""
        row, ((x, y), (right, back)) = np.zeros(MORE + PER_HOLE * len(self.holes)), self.outline.box
        row[0], row[HEIGHT], row[OUTLINE : OUTLINE + 5], row[HOLES] = LEVEL, self.height, self.outline.row, len(self.holes)
        holes = row[MORE:].reshape(-1, PER_HOLE)
        for of, hole in zip(holes, (hole.outline for hole in self.holes), strict=True):
            along_x, along_y = self.outline.crossed_by(hole)
            of[RIM : RIM + 5], of[FULL] = hole.row, ENDLESS if along_x and not along_y else hole.half[0]
            of[RIM + 4] = ENDLESS if along_y else of[RIM + 4]
        row[UPWARD : UPWARD + 5], row[ACROSS : ACROSS + 5] = (0.0, 1.0, 0.0, y, back - y), (1.0, 0.0, 0.0, x, right - x)
        return row

    def narrow(self, row: np.ndarray) -> tuple[str, ...]:
        """Names of its holes that are shut yet, or grow, by its row."""
        rims = row[MORE:][: PER_HOLE * len(self.holes)].reshape(-1, PER_HOLE)
        return tuple(hole.name for of, hole in zip(rims, self.holes, strict=True) if not (of[OPEN] and of[RIM + 3] == of[FULL]))

    def opened(self, row: np.ndarray, names: tuple[str, ...], speed: float = 0.0) -> None:
        """Open the holes of these names in its row: at a speed (m/s) of their width along x, or at once where that is none.

        One that is open goes on from its width.
        """
        for of, hole in zip(row[MORE:][: PER_HOLE * len(self.holes)].reshape(-1, PER_HOLE), self.holes, strict=True):
            if hole.name in names:
                begun = of[RIM + 3] if of[OPEN] else 0.0
                of[OPEN], of[GROWTH], of[RIM + 3] = 1.0, speed / 2.0, begun if speed > 0.0 else of[FULL]

    @property
    def corners(self) -> np.ndarray:
        """Corners (n, 3) of a box around it, m."""
        return np.column_stack([self.outline.box, [self.height] * 2])


def gate_of(plug: Surface, name: str) -> LevelPiece:
    """A hopper's plug as a gate: a hole of a name grows in it until nothing of it is left."""
    if isinstance(plug, TurnedLine):
        (wide, height), sides = plug.end, int(CIRCLE)
        outline = Outline(sides=sides, half=(wide, wide), middle=plug.axis)
    else:
        assert isinstance(plug, LevelPiece)
        height, outline = plug.height, plug.outline
    holes = (Hole(name=name, outline=outline),)
    return LevelPiece(name=plug.name, height=height, outline=outline, holes=holes, cells=plug.cells, coat=plug.coat)
