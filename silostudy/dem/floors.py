"""Floors of a run and of its branch: while all outlets are shut, the pieces of one floor may stand for those of another."""

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from silostudy.dem.drive import standing
from silostudy.dem.model import FLOOR, Model
from silostudy.dem.snapshot import from_walls, length

PIECE = re.compile(rf"{FLOOR}(_\d+)?")


def pieces_of(boxes: Mapping[str, Any], live) -> dict[str, Any]:
    """Boxes of the standing pieces of the floor, by their names."""
    walls = zip(boxes.items(), live, strict=True)
    return {name: box for (name, box), stands in walls if stands and PIECE.fullmatch(name)}


def changed(end: Mapping[str, Any], name: str) -> bool:
    """Whether a wall has been moved, or an outlet in it opened, by then."""
    return not np.array_equal(np.trim_zeros(_shape_then(end, name), "b"), end["walls"][name][1])


def _shape_then(end: Mapping[str, Any], name: str) -> np.ndarray:
    return end["engine"]["shape"][list(end["walls"]).index(name)]


def exchanged(model: Model, end: Mapping[str, Any], here: Mapping[str, Any]) -> tuple[set[str], set[str]]:
    """Names of the pieces of the floor there and here, where these stand for those; none where both are the same.

    here: the model's walls as an end has them (see `branch.walls`).  Both floors reach as far, and nothing has moved or
    opened that there.
    """
    there = pieces_of(end["walls"], end["engine"]["live"])
    own = pieces_of(here, [wall.live for wall in model.walls])
    if not there or not own or {name: box for name, (box, _) in there.items()} == {name: box for name, (box, _) in own.items()}:
        return set(), set()
    numbers = [list(end["walls"]).index(name) for name in there]
    still = np.array_equal(end["engine"]["drive"][numbers], standing(len(numbers)))
    whole = not any(changed(end, name) for name in there)
    return (set(there), set(own)) if still and whole and _reach(model, there) == _reach(model, own) else (set(), set())


def _reach(model: Model, pieces: Mapping[str, Any]) -> list[float]:
    """Least and largest coordinates (m) of pieces."""
    corners = np.concatenate([np.frombuffer(box).reshape(-1, model.space.ways) for box, _ in pieces.values()])
    return [*corners.min(axis=0), *corners.max(axis=0)]


def nearest_of(engine, names: set[str], places: np.ndarray) -> np.ndarray:
    """Number of the nearest of the named walls to each place (n, d; m)."""
    numbers = np.array(sorted(engine.model.wall_number(name) for name in names))
    away = [length(from_walls(engine, np.full(len(places), number), places)) for number in numbers]
    return numbers[np.argmin(away, axis=0)]
