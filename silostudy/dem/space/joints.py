"""Joints of surfaces that say nothing of them: pieces of one plane are a sheet, others have one edge where they meet.

Facets of a curved sheet are one too where they turn by little: it pushes from its nearest point, once, over all its joints.
"""

from itertools import combinations
from math import cos, radians
from typing import Any, NamedTuple

import numpy as np

from silostudy.dem.space.rows import (
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
SMOOTH = cos(radians(15.0))  # of two facets that turn by less at a joint of a curved sheet: more is a corner with two faces
ENDS = ((START_END, START_WAY), (END_END, END_WAY))


class Joint(NamedTuple):
    """Joint of two surfaces: their numbers, and the numbers of their sides or ends."""

    surface: int
    other: int
    side: int
    others: int


def join(shape: np.ndarray, surfaces) -> None:
    """Write into the rows of surfaces what their sides and ends are that meet."""
    for joint in flat_joints(surfaces):
        surface, other, side, others = joint
        of, to = (MORE + PER_SIDE * k for k in (side, others))
        if level(surfaces, joint):
            shape[surface, of + SIDE] = shape[other, to + SIDE] = 0.0
        elif shape[surface, of + SIDE] != JOINED and shape[other, to + SIDE] != JOINED:
            shape[surface, of + SIDE], shape[other, to + SIDE] = MEETS, JOINED
            shape[surface, of + SIDE_WAY : of + SIDE_WAY + 3] = inward(surfaces[other], others)
    for surface, other, end, others in turned_joints(surfaces):
        (kind, way), (same, _) = ENDS[end], ENDS[others]
        if shape[surface, kind] != JOINED and shape[other, same] != JOINED:
            shape[surface, kind], shape[other, same] = MEETS, JOINED
            (r0, z0), (r1, z1) = ends(surfaces[other])[:: 1 - 2 * others]
            shape[surface, way : way + 2] = np.array([r1 - r0, z1 - z0]) / np.hypot(r1 - r0, z1 - z0)


def sheets(surfaces) -> list[list[int]]:
    """Numbers of the flat pieces of each sheet of two or more, in order."""
    groups: list[set[int]] = []
    for joint in flat_joints(surfaces):
        if level(surfaces, joint):
            both = {joint.surface, joint.other}
            touched = [sheet for sheet in groups if sheet & both]
            groups = [sheet for sheet in groups if sheet not in touched] + [both.union(*touched)]
    return [sorted(sheet) for sheet in groups]


def level(surfaces, joint: Joint) -> bool:
    """Whether two flat pieces that share a side are of one sheet, plane or curved, and of the same coefficients."""
    surface, other = surfaces[joint.surface], surfaces[joint.other]
    even = abs(surface.normal @ other.normal) > 1.0 - EVEN
    if surface.sheet and surface.sheet == other.sheet:
        even = even or inward(surface, joint.side) @ inward(other, joint.others) < -SMOOTH
    return bool(even) and surface.coat == other.coat


def inward(piece: Any, side: int) -> np.ndarray:
    """Unit vector in a flat piece's plane, from one of its sides to its inside."""
    start, end = np.array(piece.sides[side])
    across = np.cross(piece.normal, end - start)
    return across / np.linalg.norm(across)


def flat_joints(surfaces) -> list[Joint]:
    """Joints of standing flat pieces that share a side."""
    meeting: dict[frozenset, list[tuple[int, int]]] = {}
    for number in standing(surfaces, FLAT):
        for k, side in enumerate(surfaces[number].sides):
            meeting.setdefault(frozenset(side), []).append((number, k))
    met = (two for all_here in meeting.values() for two in combinations(all_here, 2))
    return sorted(Joint(surface, other, k, n) for (surface, k), (other, n) in met if surface != other)


def turned_joints(surfaces) -> list[Joint]:
    """Joints of standing turned lines about one axis that share an end."""
    joints = []
    for surface, other in combinations(standing(surfaces, TURNED), 2):
        if surfaces[surface].axis == surfaces[other].axis:
            here, there = ends(surfaces[surface]), ends(surfaces[other])
            joints += [Joint(surface, other, k, n) for k in (0, 1) for n in (0, 1) if here[k] == there[n]]
    return joints


def standing(surfaces, kind: float) -> list[int]:
    """Numbers of the standing surfaces of a kind."""
    return [number for number, surface in enumerate(surfaces) if surface.live and surface.shape[0] == kind]


def ends(surface: Any) -> tuple[tuple[float, float], tuple[float, float]]:
    """Both ends of a turned line: distance from the axis and height (m)."""
    return surface.start, surface.end
