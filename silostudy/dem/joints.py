"""Joints of lines that say nothing of them: where ends meet, one has the point for all; an end on another wall has none."""

from itertools import pairwise
from math import atan2, pi
from typing import Any, NamedTuple

import numpy as np

START, END = range(2)  # numbers of a wall's ends
# kinds of ends
FREE = 0.0  # it pushes as a point
JOINED = 1.0  # it does not push
MEETS = 2.0  # it pushes what is beyond the end of another wall that it meets
SHUT = 3.0  # it goes straight on in another wall
# columns of a wall's shape
REACH = 4  # from where and to where it stands, along its line from the line's start (m)
ENDS = 6  # kinds of both ends
RISE = 8  # speed of rise (m/s)
WAYS = 9  # unit directions of the walls that the ends meet
CLOSE = 1e-9  # of the longest wall: places that are no farther apart are one
STRAIGHT = 1e-12  # rad: walls whose directions differ by less go straight on


class Tip(NamedTuple):
    """An end of a wall: the wall's number, which end, its place (m) and the unit direction from there into the wall."""

    wall: int
    end: int
    place: np.ndarray
    way: np.ndarray


def join(shape: np.ndarray, walls) -> None:
    """Write into the rows of walls what the ends of lines are that meet others, or stand on them."""
    if all(wall.faces == 1 for wall in walls):
        return
    close = CLOSE * float(shape[:, REACH + END].max())
    for tips in meeting([tip for number, wall in enumerate(walls) if wall.stays for tip in tips_of(number, wall)], close):
        if any(walls[tip.wall].faces > 1 for tip in tips):
            if len(tips) > 1:
                settle(shape, tips)
            if any(stands_on(wall, tips[0].place, close) for wall in walls if wall.stays):
                for tip in tips:
                    shape[tip.wall, ENDS + tip.end] = JOINED


def settle(shape: np.ndarray, tips: list[Tip]) -> None:
    """Let the point of ends that meet be that of the first of the two beside the widest gap, and of no other."""
    owner, other, gap = across_widest(tips)
    for tip in tips:
        shape[tip.wall, ENDS + tip.end] = JOINED
    if gap >= pi - STRAIGHT:
        way = WAYS + 2 * owner.end
        shape[owner.wall, ENDS + owner.end], shape[owner.wall, way : way + 2] = MEETS, other.way


def across_widest(tips: list[Tip]) -> tuple[Tip, Tip, float]:
    """The two ends beside the widest gap between walls that meet, by the walls' numbers, and the gap (rad)."""
    turned = sorted(tips, key=lambda tip: atan2(tip.way[1], tip.way[0]))
    angles = [atan2(tip.way[1], tip.way[0]) for tip in turned]
    gaps = [after - before for before, after in pairwise([*angles, angles[0] + 2.0 * pi])]
    widest = int(np.argmax(gaps))
    first, second = sorted((turned[widest], turned[(widest + 1) % len(turned)]), key=lambda tip: tip.wall)
    return first, second, gaps[widest]


def tips_of(number: int, wall: Any) -> tuple[Tip, Tip]:
    """Both ends of a wall."""
    start, end = np.array(wall.start), np.array(wall.end)
    way = (end - start) / np.hypot(*(end - start))
    return Tip(number, START, start, way), Tip(number, END, end, -way)


def meeting(tips: list[Tip], close: float) -> list[list[Tip]]:
    """Groups of the ends that stand in one place (m)."""
    groups: list[list[Tip]] = []
    for tip in tips:
        for group in groups:
            if np.hypot(*(tip.place - group[0].place)) <= close:
                group.append(tip)
                break
        else:
            groups.append([tip])
    return groups


def stands_on(wall: Any, place: np.ndarray, close: float) -> bool:
    """Whether a place lies on a wall between its ends."""
    start, end = np.array(wall.start), np.array(wall.end)
    length = np.hypot(*(end - start))
    (x, y), (tx, ty) = place - start, (end - start) / length
    return bool(abs(tx * y - ty * x) <= close < min(along := tx * x + ty * y, length - along))
