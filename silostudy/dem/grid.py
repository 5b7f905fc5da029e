"""Cells that fields are averaged over: boxes along the axes, or rings about the upright axis at x = y = 0."""

from dataclasses import dataclass
from math import floor, sqrt

import numpy as np
from numba.extending import register_jitable

RING = ("r", "turn", "z")  # outward, around from x towards y, upward


@dataclass(frozen=True)
class Grid:
    """Equal cells from a corner (m) on, so many along each coordinate; round: of distance from the axis and height."""

    low: tuple[float, ...]
    size: tuple[float, ...]
    count: tuple[int, ...]
    round: bool = False

    @classmethod
    def around(
        cls, low: tuple[float, ...], high: tuple[float, ...], inner: tuple[int, ...], margin: float, *, round: bool = False
    ) -> "Grid":
        """Grid of so many cells between two corners (m), and as many more of the same size as a margin (m) takes."""
        size = tuple((b - a) / count for a, b, count in zip(low, high, inner, strict=True))
        more = [int(np.ceil(margin / step)) for step in size]
        before = [0, *more[1:]] if round else more  # nothing lies before the axis
        corner = tuple(a - step * extra for a, step, extra in zip(low, size, before, strict=True))
        count = tuple(n + extra + after for n, extra, after in zip(inner, before, more, strict=True))
        return cls(corner, size, count, round)

    @property
    def ways(self) -> tuple[str, ...]:
        """Names of the directions that vectors in the cells have components along."""
        return RING if self.round else tuple("xyz"[: len(self.count)])

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates that tell cells apart."""
        return ("r", "z") if self.round else self.ways

    @property
    def cells(self) -> int:
        """Number of cells."""
        return int(np.prod(self.count))

    @property
    def middles(self) -> np.ndarray:
        """Middle (cells, coordinates; m) of each cell, the last coordinate running fastest."""
        ways = [a + step * (np.arange(n) + 0.5) for a, step, n in zip(self.low, self.size, self.count, strict=True)]
        return np.stack(np.meshgrid(*ways, indexing="ij"), axis=-1).reshape(self.cells, -1)

    @property
    def volumes(self) -> np.ndarray:
        """Volume of each cell (m3), in the plane its area (m2)."""
        box = np.full(self.cells, np.prod(self.size))
        return 2.0 * np.pi * self.middles[:, 0] * box if self.round else box  # exact: rings of equal width

    @property
    def shape(self) -> np.ndarray:
        """Corner, size (m) and count of the cells along three coordinates (3, 3); one cell along those that it has not."""
        fill = 3 - len(self.count)
        return np.array([(*self.low, *[-0.5] * fill), (*self.size, *[1.0] * fill), (*self.count, *[1] * fill)])


@register_jitable
def cell_at(shape, round, x, y, z):
    """Number of the cell that holds a place (m), -1 beyond them all."""
    first, second, third = (sqrt(x * x + y * y), z, 0.0) if round else (x, y, z)
    number = 0
    for k, value in enumerate((first, second, third)):
        index = floor((value - shape[0, k]) / shape[1, k])
        if index < 0 or index >= shape[2, k]:
            return -1
        number = number * int(shape[2, k]) + int(index)
    return number


@register_jitable
def components(round, x, y, vector):
    """Components of a vector along the directions that the cells have at a place."""
    if not round:
        return vector
    off = sqrt(x * x + y * y)
    c, s = (x / off, y / off) if off > 0.0 else (1.0, 0.0)
    return vector[0] * c + vector[1] * s, vector[1] * c - vector[0] * s, vector[2]
