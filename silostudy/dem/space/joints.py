"""Joints of surfaces that say nothing of them: pieces of one plane are a sheet, others have one edge where they meet."""

from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from silostudy.dem.space.surfaces import (
    END_END,
    END_WAY,
    FLAT,
    JOINED,
    MEETS,
    MORE,
    PER_SIDE,
    SIDE,
    SIDE_WAY,
    START_END,
    START_WAY,
    TURNED,
)

EVEN = 1e-12  # of the cosine between two normals: pieces that differ by less are of one plane
ENDS = ((START_END, START_WAY), (END_END, END_WAY))


class Joint(NamedTuple):
    """Where two surfaces meet: their numbers, and the numbers of their sides or ends."""

    one: int
    other: int
    side: int
    others: int


def join(shape: np.ndarray, surfaces) -> None:
    """Write into the rows of surfaces what their sides and ends are that meet."""
    for one, other, side, others in flat_joints(surfaces):
        of, to = (MORE + PER_SIDE * k for k in (side, others))
        if level(surfaces[one], surfaces[other]):
            shape[one, of + SIDE] = shape[other, to + SIDE] = 0.0
        elif shape[one, of + SIDE] != JOINED and shape[other, to + SIDE] != JOINED:
            shape[one, of + SIDE], shape[other, to + SIDE] = MEETS, JOINED
            start, end = np.array(surfaces[other].sides[others])
            inward = np.cross(surfaces[other].normal, end - start)
            shape[one, of + SIDE_WAY : of + SIDE_WAY + 3] = inward / np.linalg.norm(inward)
    for one, other, end, others in turned_joints(surfaces):
        (kind, way), (same, _) = ENDS[end], ENDS[others]
        if shape[one, kind] != JOINED and shape[other, same] != JOINED:
            shape[one, kind], shape[other, same] = MEETS, JOINED
            (r0, z0), (r1, z1) = ends(surfaces[other])[:: 1 - 2 * others]
            shape[one, way : way + 2] = np.array([r1 - r0, z1 - z0]) / np.hypot(r1 - r0, z1 - z0)


def sheets(surfaces) -> list[list[int]]:
    """Numbers of the flat pieces of each sheet of two or more, in order."""
    found: list[set[int]] = []
    for one, other, *_ in flat_joints(surfaces):
        if level(surfaces[one], surfaces[other]):
            touched = [sheet for sheet in found if sheet & {one, other}]
            found = [sheet for sheet in found if sheet not in touched] + [{one, other}.union(*touched)]
    return [sorted(sheet) for sheet in found]


def level(one: Any, other: Any) -> bool:
    """Whether two flat pieces that share a side are of one plane and of the same coefficients."""
    return bool(abs(one.normal @ other.normal) > 1.0 - EVEN) and one.coat == other.coat


def flat_joints(surfaces) -> list[Joint]:
    """Where two standing flat pieces share a side."""
    found = []
    for one, other in pairs(surfaces, FLAT):
        sides = [frozenset(side) for side in surfaces[other].sides]
        shared = [(k, frozenset(side)) for k, side in enumerate(surfaces[one].sides)]
        found += [Joint(one, other, k, sides.index(side)) for k, side in shared if side in sides]
    return found


def turned_joints(surfaces) -> list[Joint]:
    """Where two standing turned lines about one axis share an end."""
    found = []
    for one, other in pairs(surfaces, TURNED):
        if surfaces[one].axis == surfaces[other].axis:
            here, there = ends(surfaces[one]), ends(surfaces[other])
            found += [Joint(one, other, k, n) for k in (0, 1) for n in (0, 1) if here[k] == there[n]]
    return found


def pairs(surfaces, kind: float) -> combinations:
    """Numbers of any two standing surfaces of a kind."""
    return combinations([number for number, surface in enumerate(surfaces) if surface.live and surface.shape[0] == kind], 2)


def ends(surface: Any) -> tuple[tuple[float, float], tuple[float, float]]:
    """Both ends of a turned line: distance from the axis and height (m)."""
    return surface.start, surface.end
