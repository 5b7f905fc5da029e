"""Floors of a run and of its branch: what shuts outlets of one may stand for that of another; what is open stays open."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from silostudy.dem.drive import standing
from silostudy.dem.model import FLOOR, Model
from silostudy.dem.snapshot import from_walls, length

PIECE = re.compile(rf"{FLOOR}(_\d+)?")


@dataclass(frozen=True)
class Exchange:
    """Names of the pieces of a floor there, and of those here that stand for them; none where both are the same.

    rows: of those here, with the outlets open that are so there; takes (there, here): which go on for which; lost: name of an
    outlet that is open there and none of those here.
    """

    passed: tuple[str, ...] = ()
    own: tuple[str, ...] = ()
    rows: np.ndarray = field(default_factory=lambda: np.empty((0, 0)))
    takes: np.ndarray = field(default_factory=lambda: np.empty((0, 0), bool))
    lost: str = ""


def pieces_of(boxes: Mapping[str, Any], live) -> dict[str, Any]:
    """Boxes of the standing pieces of the floor, by their names."""
    walls = zip(boxes.items(), live, strict=True)
    return {name: box for (name, box), stands in walls if stands and PIECE.fullmatch(name)}


def changed(end: Mapping[str, Any], name: str) -> bool:
    """Whether a wall has been moved, or an outlet in it opened, by then."""
    return not np.array_equal(np.trim_zeros(_shape_then(end, name), "b"), end["walls"][name][1])


def _shape_then(end: Mapping[str, Any], name: str) -> np.ndarray:
    return end["engine"]["shape"][list(end["walls"]).index(name)]


def exchanged(model: Model, end: Mapping[str, Any], here: Mapping[str, Any]) -> Exchange:
    """The exchange of a floor there for that here: nothing where both are the same, or one cannot stand for the other.

    here: the model's walls as an end has them (see `branch.walls`).  Both floors reach as far, and nothing has moved there but
    what outlets opened.
    """
    there = pieces_of(end["walls"], end["engine"]["live"])
    own = pieces_of(here, [wall.live for wall in model.walls])
    if not there or not own or _same(there, own) or _reach(model, there) != _reach(model, own):
        return Exchange()
    numbers = [list(end["walls"]).index(name) for name in there]
    if not np.array_equal(end["engine"]["drive"][numbers], standing(len(numbers))):
        return Exchange()
    now = end["engine"]["shape"][numbers]
    rows, takes, lost = model.space.handed_on(now, *(_rows(pieces, now.shape[1]) for pieces in (there, own)))
    names = [list(there.values())[piece][2][outlet] for piece, outlet in lost]
    return Exchange(tuple(there), tuple(own), rows, takes, next(iter(names), "")) if len(rows) else Exchange()


def _same(there: Mapping[str, Any], own: Mapping[str, Any]) -> bool:
    """Whether pieces have the same names, boxes and shapes at the start."""
    return list(there) == list(own) and all(
        box == own[name][0] and np.array_equal(shape, own[name][1]) for name, (box, shape, _) in there.items()
    )


def _rows(pieces: Mapping[str, Any], width: int) -> np.ndarray:
    """Shapes at the start, as long as the longest and at least of a width."""
    width = max(width, *(len(shape) for _, shape, _ in pieces.values()))
    return np.array([np.pad(shape, (0, width - len(shape))) for _, shape, _ in pieces.values()])


def _reach(model: Model, pieces: Mapping[str, Any]) -> list[float]:
    """Least and largest coordinates (m) of pieces."""
    corners = np.concatenate([np.frombuffer(box).reshape(-1, model.space.ways) for box, *_ in pieces.values()])
    return [*corners.min(axis=0), *corners.max(axis=0)]


def nearest_of(engine, names: tuple[str, ...], places: np.ndarray) -> np.ndarray:
    """Number of the nearest of the named walls to each place (n, d; m)."""
    numbers = np.array(sorted(engine.model.wall_number(name) for name in names))
    away = [length(from_walls(engine, np.full(len(places), number), places)) for number in numbers]
    return numbers[np.argmin(away, axis=0)]
