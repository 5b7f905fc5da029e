"""Published values against computed ones: a CSV file says its own scene, whatever the method.

Columns with a dot, and `solid` and `wall`, are keys of the scene; the others are reading, phase, depth, one quantity with its
unit, source and locator, and where the source's own arithmetic is coarser than its print, the relative precision of it.
"""

import csv
from pathlib import Path

from silostudy.tables.units import split_unit

PUBLISHED = Path(__file__).parent / "published"


def points(path: Path) -> list[dict[str, str]]:
    """The rows of a file as they are written."""
    lines = (line for line in path.read_text(encoding="utf-8").splitlines() if line.strip() and not line.startswith("#"))
    found = list(csv.DictReader(lines))
    assert found, f"{path.name} holds no values"
    assert all(point["source"] and point["locator"] for point in found)
    return found


def scene_of(point: dict[str, str], keys: list[str]) -> dict:
    """The scene that some columns of a row describe; an empty cell leaves its key out."""
    scene: dict = {}
    for dotted in keys:
        *parents, last = dotted.split(".")
        node = scene
        for parent in parents:
            node = node.setdefault(parent, {})
        if point[dotted]:
            node[last] = _value(point[dotted])
    return scene


def _value(cell: str) -> float | str:
    try:
        return float(cell)
    except ValueError:
        return cell


def printed(point: dict[str, str], column: str) -> tuple[str, float, float]:
    """(quantity, value in SI, relative precision): of the source where the row says so, else one unit in the last digit."""
    quantity, _, factor = split_unit(column)
    cell = point[column]
    last_digit = 10.0 ** -len(cell.partition(".")[2]) / abs(float(cell))
    return quantity, float(cell) * factor, float(point.get("precision") or last_digit)
