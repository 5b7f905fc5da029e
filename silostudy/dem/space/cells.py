"""Cells of surfaces of spheres: their middles (m), areas (m2), and how what they feel stands to the vertical."""

from dataclasses import dataclass
from functools import singledispatch
from itertools import pairwise
from math import nan
from typing import Any

import numpy as np

from silostudy.dem.space.cones import EccentricCone
from silostudy.dem.space.level import LevelPiece, Outline
from silostudy.dem.space.rows import ACROSS, CIRCLE, NORMAL, UPWARD
from silostudy.dem.space.walls import FlatPiece, TurnedLine

GAUSS = 64  # points all around by which an eccentric cone's area is added up
CUT = 33  # points of a line that a plane cuts a turned surface in
CORNERS = 720  # of the polygon that stands for a circle


@dataclass(frozen=True)
class Face:
    """One face of a surface that has cells of its own: the surface's name, or that and `_back`.

    wall: number of the surface; count: of cells; lean: vertical components (1) of the normal that presses it and of the upward
    direction along it; sheet: name of the curved sheet that it is a facet of, or that and `_back`.
    """

    name: str
    wall: int
    count: int
    lean: tuple[float, float]
    sheet: str = ""


def faces(surfaces, roof: str) -> list[Face]:
    """Faces of surfaces in the order of their cells; roof: name of the one that the solid is below."""
    listed = []
    for number, surface in enumerate(surfaces):
        normal, along = uprightness(surface, surface.name == roof)
        for back in range(surface.faces):
            name, sheet = (f"{of}_back" if back and of else of for of in (surface.name, surface.sheet))
            listed.append(Face(name, number, int(np.prod(surface.cells)), (-normal if back else normal, along), sheet))
    return listed


@singledispatch
def middles(surface: Any) -> np.ndarray:
    """Middle (cells, 3; m) of each cell, along by along, in each around."""
    raise TypeError(type(surface))


@middles.register
def _(surface: TurnedLine) -> np.ndarray:
    along, around = (middle.ravel() for middle in np.meshgrid(*map(_parts, surface.cells), indexing="ij"))
    (r0, z0), (r1, z1), turn = surface.start, surface.end, 2.0 * np.pi * around
    r = r0 + along * (r1 - r0)
    return np.column_stack([surface.axis[0] + r * np.cos(turn), surface.axis[1] + r * np.sin(turn), z0 + along * (z1 - z0)])


@middles.register
def _(surface: EccentricCone) -> np.ndarray:
    along, around = (middle.ravel() for middle in np.meshgrid(*map(_parts, surface.cells), indexing="ij"))
    turn, radius = 2.0 * np.pi * around, surface.start[0] + along * surface.rise[0]
    level = surface.foot + np.outer(along, surface.lean) + radius[:, None] * np.column_stack([np.cos(turn), np.sin(turn)])
    return np.column_stack([level, surface.start[1] + along * surface.rise[1]])


@middles.register
def _(surface: FlatPiece | LevelPiece) -> np.ndarray:
    up, across, origin = _plane(surface)
    along, around = (middle.ravel() for middle in np.meshgrid(*map(_parts, surface.cells), indexing="ij"))
    return origin + np.outer(up[3] + along * up[4], up[:3]) + np.outer(across[3] + around * across[4], across[:3])


@singledispatch
def areas(surface: Any) -> np.ndarray:
    """Area (m2) of each cell, as middles are counted; of a floor with its outlets shut."""
    raise TypeError(type(surface))


@areas.register
def _(surface: TurnedLine) -> np.ndarray:
    along, around = surface.cells
    radius = np.linspace(surface.start[0], surface.end[0], along + 1)
    length = float(np.hypot(*np.subtract(surface.end, surface.start))) / along
    return np.repeat(np.pi * (radius[:-1] + radius[1:]) * length / around, around)


@areas.register
def _(surface: EccentricCone) -> np.ndarray:
    """The wall's element of area is the radius times the root of the squares of height and of growth outward at its angle."""
    along, around = surface.cells
    radius = np.linspace(surface.start[0], surface.end[0], along + 1)
    places, weights = np.polynomial.legendre.leggauss(max(GAUSS // around, 8))
    turn = np.pi * (2.0 * np.arange(around)[:, None] + 1.0 + places) / around
    (dx, dy), (wide, high) = surface.lean, surface.rise
    wall = np.hypot(high, wide + dx * np.cos(turn) + dy * np.sin(turn)) @ weights * np.pi / around
    return np.outer((radius[:-1] + radius[1:]) / (2.0 * along), wall).ravel()


@areas.register
def _(surface: FlatPiece) -> np.ndarray:
    up, across, _ = _plane(surface)
    corners = np.array(surface.corners)
    return _in_cells(
        np.column_stack([corners @ up[:3] - up[3], corners @ across[:3] - across[3]]), up[4], across[4], surface.cells
    )


@areas.register
def _(surface: LevelPiece) -> np.ndarray:
    up, across, _ = _plane(surface)
    corners = polygon(surface.outline)[:, ::-1] - [up[3], across[3]]
    return _in_cells(corners, up[4], across[4], surface.cells)


def uprightness(surface: Any, roof: bool = False) -> tuple[float, float]:
    """Vertical components (1) of the normal towards the solid, and of the upward direction along the surface.

    An eccentric cone has no single ones: its load is recorded.
    """
    if isinstance(surface, EccentricCone):
        return nan, nan
    if isinstance(surface, TurnedLine):
        (r0, z0), (r1, z1) = surface.start, surface.end
        length = float(np.hypot(r1 - r0, z1 - z0))
        return (-1.0 if roof else (r1 - r0) / length), abs(z1 - z0) / length
    if isinstance(surface, LevelPiece):
        return (-1.0 if roof else 1.0), 0.0
    row = surface.shape
    return float(row[NORMAL + 2]), float(row[UPWARD + 2])


def polygon(outline: Outline) -> np.ndarray:
    """Corners (n, 2; m) of an outline, counter-clockwise; of a circle those of a polygon of the same area."""
    if outline.sides != CIRCLE:
        return np.array(outline.corners)
    turn = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    wide = outline.half[0] * np.sqrt(2.0 * np.pi / (CORNERS * np.sin(2.0 * np.pi / CORNERS)))
    return np.column_stack([outline.middle[0] + wide * np.cos(turn), outline.middle[1] + wide * np.sin(turn)])


@singledispatch
def cuts(surface: Any) -> list[np.ndarray]:
    """Lines (n, 2; m) in which the plane of y = 0 cuts a surface: x and z."""
    raise TypeError(type(surface))


@cuts.register
def _(surface: TurnedLine) -> list[np.ndarray]:
    share = np.linspace(0.0, 1.0, CUT)[:, None]
    r, z = (np.array(surface.start) * (1.0 - share) + np.array(surface.end) * share).T
    half = np.sqrt(np.maximum(r**2 - surface.axis[1] ** 2, 0.0))
    there = r >= abs(surface.axis[1])
    return [np.column_stack([surface.axis[0] + side * half, z])[there] for side in (-1.0, 1.0) if there.any()]


@cuts.register
def _(surface: FlatPiece) -> list[np.ndarray]:
    crossings = []
    for a, b in (np.array(side) for side in surface.sides):
        if (a[1] < 0.0) != (b[1] < 0.0):
            crossings.append((a + a[1] / (a[1] - b[1]) * (b - a))[[0, 2]])
    return [np.array(crossings)] if crossings else []


def _parts(count: int) -> np.ndarray:
    """Middles of equal parts of one."""
    return (np.arange(count) + 0.5) / count


def _plane(surface: FlatPiece | LevelPiece) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unit vector, least coordinate and length (m) of a flat surface upward and across, and its point nearest the origin."""
    row = surface.shape
    up, across = row[UPWARD : UPWARD + 5], row[ACROSS : ACROSS + 5]
    corner = np.array(surface.corners)[0]
    normal = np.cross(across[:3], up[:3])
    return up, across, normal * (normal @ corner)


def _in_cells(corners: np.ndarray, high: float, wide: float, cells: tuple[int, int]) -> np.ndarray:
    """Area (m2) of a polygon (n, 2; m) in each of the equal cells of the rectangle of these sides that it stands in."""
    along, around = (np.linspace(0.0, side, count + 1) for side, count in zip((high, wide), cells, strict=True))
    areas = []
    for low, top in pairwise(along):
        strip = _clipped(_clipped(corners, 0, low, 1.0), 0, top, -1.0)
        areas += [_area(_clipped(_clipped(strip, 1, left, 1.0), 1, right, -1.0)) for left, right in pairwise(around)]
    return np.array(areas)


def _clipped(corners: np.ndarray, way: int, line: float, sign: float) -> np.ndarray:
    """Part of a polygon beyond a line across one of its coordinates: sign 1 above it, -1 below it."""
    clipped = []
    inside = sign * (corners[:, way] - line) if len(corners) else corners
    for k in range(len(corners)):
        here, then = inside[k - 1], inside[k]
        if (here < 0.0) != (then < 0.0):
            clipped.append(corners[k - 1] + here / (here - then) * (corners[k] - corners[k - 1]))
        if then >= 0.0:
            clipped.append(corners[k])
    return np.array(clipped).reshape(-1, 2)


def _area(corners: np.ndarray) -> float:
    """Area of a polygon (n, 2)."""
    a, b = corners, np.roll(corners, -1, axis=0)
    return 0.5 * abs(float((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum()))
