"""Surfaces of a scene of spheres as users of the engine write them: turned lines and flat pieces, each with a name."""

from dataclasses import dataclass
from math import ceil, hypot, sqrt

import numpy as np

from silostudy.dem.arrays import Walls
from silostudy.dem.drive import standing
from silostudy.dem.space.joints import join, sheets
from silostudy.dem.space.rows import (
    ACROSS,
    BOX,
    COUNT,
    FLAT,
    FOLLOWS,
    FRONT,
    JOINED,
    LAST,
    MORE,
    NEXT,
    NORMAL,
    PER_SIDE,
    SIDE,
    TURNED,
    UPWARD,
)
from silostudy.errors import BadInput

LEVEL = 1e-9  # height of a unit vector: a piece whose normal is more upright than this is level
FLAT_ENOUGH = 1e-6  # of a piece's extent: distance of its corners from its plane
FEW = 8  # pieces of a sheet that are looked at one by one
STRAIGHT = 1e-12  # of its square: how much a corner may turn inward


@dataclass(frozen=True, kw_only=True)
class Surface:
    """Surface with a name, equal cells along and around that have their force recorded, and whether it stands.

    faces: 2 where its back has cells of its own; coat: number of its coefficients, that pieces of one sheet share; sheet: name
    of the curved sheet that it is a facet of, "": of none.
    """

    name: str
    cells: tuple[int, int] = (1, 1)
    live: bool = True
    faces: int = 1
    coat: int = 0
    sheet: str = ""

    def __post_init__(self):
        if min(self.cells) < 1:
            raise BadInput(f"{self.name}.cells", self.cells, "must be 1 or more each way")

    @property
    def outlets(self) -> tuple[str, ...]:
        """Names of the outlets that it has."""
        return ()

    def covers(self, places: np.ndarray) -> np.ndarray:
        """Mask of places (n, 3) that stand over or under the box around it."""
        ends = np.array(self.corners)[:, :2]  # type: ignore[attr-defined]
        return ((places[:, :2] >= ends.min(axis=0)) & (places[:, :2] <= ends.max(axis=0))).all(axis=1)


@dataclass(frozen=True, kw_only=True)
class TurnedLine(Surface):
    """A straight line turned about an upright axis: a cylinder, a cone, a ring or a disc.

    start, end: distance from the axis and height (m); axis: its x and y (m).  Cells along run from start to end, cells around
    from the x axis towards y.  An end that is joined to another surface does not push as an edge.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    axis: tuple[float, float] = (0.0, 0.0)
    joined: tuple[bool, bool] = (False, False)

    def __post_init__(self):
        super().__post_init__()
        if not np.isfinite([*self.start, *self.end, *self.axis]).all() or min(self.start[0], self.end[0]) < 0.0:
            raise BadInput(
                self.name, (self.start, self.end), "distances from the axis and heights must be finite, none negative"
            )
        if self.start == self.end:
            raise BadInput(self.name, self.start, "a surface must have an extent")

    @property
    def shape(self) -> np.ndarray:
        """The row of numbers that kernels read."""
        (r0, z0), (r1, z1) = self.start, self.end
        length = hypot(r1 - r0, z1 - z0)
        ends = [JOINED if joined else 0.0 for joined in self.joined]
        row = np.zeros(MORE)
        row[:10] = [TURNED, *self.axis, r0, z0, (r1 - r0) / length, (z1 - z0) / length, length, *ends]
        return row

    def covers(self, places: np.ndarray) -> np.ndarray:
        """Mask of places (n, 3) that stand over or under its widest circle."""
        return np.hypot(*(places[:, :2] - self.axis).T) <= max(self.start[0], self.end[0])

    @property
    def corners(self) -> np.ndarray:
        """Corners (n, 3) of a box around it, m."""
        wide = max(self.start[0], self.end[0])
        x, y = self.axis
        return np.array([(x - wide, y - wide, self.start[1]), (x + wide, y + wide, self.end[1])])


@dataclass(frozen=True, kw_only=True)
class FlatPiece(Surface):
    """A convex polygon of three corners (m) or more, counter-clockwise as the solid sees them.

    A side, from each corner to the next, that is joined to another surface does not push as an edge.
    """

    corners: tuple[tuple[float, float, float], ...]
    joined: tuple[bool, ...] = ()
    front_only: bool = False

    def __post_init__(self):
        super().__post_init__()
        if len(self.corners) < 3 or not np.isfinite(self.corners).all():
            raise BadInput(self.name, self.corners, "a flat piece has three finite corners or more")
        if not np.linalg.norm(self._across) > 0.0:
            raise BadInput(self.name, self.corners, "a surface must have an extent")
        corners = np.array(self.corners)
        size, off = np.ptp(corners, axis=0).max(), np.abs((corners - corners[0]) @ self.normal).max()
        if off > FLAT_ENOUGH * size:
            raise BadInput(self.name, self.corners, f"its corners must lie in one plane, and do not by {off:.3g} m")
        along = np.roll(corners, -1, axis=0) - corners
        turns = np.cross(along, np.roll(along, -1, axis=0)) @ self.normal
        angles = np.arctan2(turns, (along * np.roll(along, -1, axis=0)).sum(axis=1))
        if turns.min() < -STRAIGHT * size**2 or angles.sum() > 3.0 * np.pi:
            raise BadInput(self.name, self.corners, "must be convex, its corners in order round it")

    @property
    def _across(self) -> np.ndarray:
        corners = np.array(self.corners)
        return np.cross(corners[1] - corners[0], corners[-1] - corners[0])

    @property
    def normal(self) -> np.ndarray:
        """Unit vector towards the solid."""
        return self._across / np.linalg.norm(self._across)

    @property
    def sides(self) -> list[tuple[tuple[float, ...], tuple[float, ...]]]:
        """Pairs of corners: from each corner to the next."""
        return list(zip(self.corners, (*self.corners[1:], self.corners[0]), strict=True))

    @property
    def shape(self) -> np.ndarray:
        """The row of numbers that kernels read."""
        corners, normal = np.array(self.corners), self.normal
        row = np.zeros(MORE + PER_SIDE * len(corners))
        row[0], row[COUNT], row[NORMAL : NORMAL + 3], row[FRONT] = FLAT, len(corners), normal, self.front_only
        sides = row[MORE:].reshape(-1, PER_SIDE)
        sides[:, :3], sides[: len(self.joined), SIDE] = corners, [JOINED if joined else 0.0 for joined in self.joined]
        steep = np.array([0.0, 0.0, 1.0]) - normal[2] * normal
        upward = steep / np.linalg.norm(steep) if np.linalg.norm(steep) > LEVEL else np.array([0.0, 1.0, 0.0])
        for column, way in ((UPWARD, upward), (ACROSS, np.cross(upward, normal))):
            spread = corners @ way
            row[column : column + 5] = *way, spread.min(), np.ptp(spread)
        return row


def walls_of(surfaces) -> Walls:
    """The surfaces as arrays; cells: first cell, cells along, cells around, and how many before those of its back, if any.

    Of pieces that are a sheet the first is live and stands for all.
    """
    counts = np.array([(*surface.cells, surface.faces) for surface in surfaces], np.int64).reshape(-1, 3)
    total, back = counts.prod(axis=1), counts[:, 0] * counts[:, 1] * (counts[:, 2] > 1)
    rows = [surface.shape for surface in surfaces]
    shape = np.zeros((len(rows), max(MORE, *map(len, rows)) if rows else MORE))
    live = np.array([surface.live for surface in surfaces], bool)
    for number, row in enumerate(rows):
        shape[number, : len(row)] = row
    for sheet in sheets(surfaces):
        live[sheet[1:]] = False
        shape[sheet[:-1], NEXT], shape[sheet[1:], FOLLOWS] = sheet[1:], 1.0
        group(shape, surfaces, sheet)
    join(shape, surfaces)
    cells = np.column_stack([np.cumsum(total) - total, counts[:, :2], back]).reshape(-1, 4)
    return Walls(shape, live, cells, standing(len(rows)))


def group(shape: np.ndarray, surfaces, sheet: list[int]) -> None:
    """Write into the rows of a sheet of many pieces its groups of some that follow each other, each with the box around it."""
    if len(sheet) <= FEW:
        return
    size = ceil(sqrt(len(sheet)))
    for pieces in (sheet[k : k + size] for k in range(0, len(sheet), size)):
        corners = np.concatenate([surfaces[number].corners for number in pieces])
        shape[pieces[0], LAST] = pieces[-1]
        shape[pieces[0], BOX : BOX + 6] = *corners.min(axis=0), *corners.max(axis=0)


def extents(surfaces) -> list[np.ndarray]:
    """Corners (n, 3) of a box around each surface, m."""
    return [np.array(surface.corners) for surface in surfaces]


def beside(surfaces, places: np.ndarray) -> np.ndarray:
    """Mask of places (n, 3; m) that have no surface above, below or at them."""
    covered = np.zeros(len(places), bool)
    for surface in surfaces:
        covered |= surface.covers(places)
    return ~covered


def cell_count(surfaces) -> int:
    """Number of cells of the surfaces."""
    return sum(surface.cells[0] * surface.cells[1] * surface.faces for surface in surfaces)
