"""Surfaces of a silo of spheres in LAMMPS' words: a region each, against which a wall of grains is fixed."""

import numpy as np

from silostudy.accuracy.laws_in_lammps import CannotSay
from silostudy.dem.space.level import LevelPiece
from silostudy.dem.space.rows import CIRCLE
from silostudy.dem.space.walls import FlatPiece, Surface, TurnedLine
from silostudy.scene.space_silo import LID

ROOM = 1.0  # m: how far a block behind a sloping wall goes on
SAME = 1e-9  # m: planes that are nearer are one
FLAT = 1e-9  # rise over radius of a cone that stands for a level ring


def regions(walls: tuple[Surface, ...]) -> dict[str, str]:
    """Region of each surface by its name, each plane once; CannotSay for a surface that no region is."""
    said: dict[str, str] = {}
    planes: list[np.ndarray] = []
    for wall in walls:
        plane = _plane(wall)
        if plane is None:
            said[wall.name] = _bent(wall)
        elif not any(np.abs(plane - other).max() < SAME for other in planes):
            planes.append(plane)
            place, normal = plane[:3], plane[3:]
            said[wall.name] = f"plane {_numbers(place)} {_numbers(normal)} side in"
    return said


def _plane(wall: Surface) -> np.ndarray | None:
    """Foot of the origin on a level or upright surface's plane (m), and its normal towards the solid; None: it is neither."""
    normal = np.array([0.0, 0.0, -1.0 if wall.name == LID else 1.0])
    if isinstance(wall, LevelPiece):
        return np.r_[0.0, 0.0, wall.height, normal]
    if isinstance(wall, TurnedLine) and wall.start[1] == wall.end[1]:
        return np.r_[0.0, 0.0, wall.start[1], normal]
    if isinstance(wall, FlatPiece) and abs(wall.normal[2]) < SAME:
        return np.r_[wall.normal * (wall.normal @ np.array(wall.corners[0])), wall.normal]
    return None


def _bent(wall: Surface) -> str:
    """A cylinder or cone open at both ends, or the block behind a sloping wall, which ends at the outlet."""
    if isinstance(wall, TurnedLine):
        (low, z), (high, top) = wall.start, wall.end
        shape = f"cylinder z 0 0 {low}" if low == high else f"cone z 0 0 {low} {high}"
        return f"{shape} {z} {top} side in open 1 open 2"
    if isinstance(wall, FlatPiece):
        return _block(wall)
    raise CannotSay(f"{wall.name} is no plane, cylinder or cone")


def _block(wall: FlatPiece) -> str:
    """Solid block behind a wall that slopes along x or y."""
    corners, way = np.array(wall.corners), int(np.argmax(np.abs(wall.normal[:2])))
    if abs(wall.normal[1 - way]) > SAME:
        raise CannotSay(f"{wall.name} slopes along neither x nor y")
    low, high = corners[:, 2].min(), corners[:, 2].max()
    foot, head = (corners[corners[:, 2] == height, way][0] for height in (low, high))
    sides = [(-ROOM, ROOM), (-ROOM, ROOM), (low, high)]
    sides[way] = (foot - ROOM, foot) if wall.normal[way] > 0.0 else (foot, foot + ROOM)
    tilts = [0.0, head - foot, 0.0] if way == 0 else [0.0, 0.0, head - foot]
    return f"prism {' '.join(_numbers(side) for side in sides)} {_numbers(tilts)} side out"


def holed(floor: LevelPiece, names: tuple[str, ...]) -> str:
    """A level floor around its open hole, as a cone that hardly rises: of a circle with a round hole in its middle."""
    outlines = [floor.outline, *(hole.outline for hole in floor.holes if hole.name in names)]
    if len(outlines) != 2 or any(outline.sides != CIRCLE or any(outline.middle) for outline in outlines):
        raise CannotSay("an outlet of a flat floor is told here where both are round, about the axis")
    wide, narrow = (outline.half[0] for outline in outlines)
    return f"cone z 0 0 {narrow} {wide} {floor.height - FLAT * wide} {floor.height} side in open 1 open 2"


def _numbers(values) -> str:
    return " ".join(f"{value:.17g}" for value in values)
