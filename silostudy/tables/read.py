"""Reads the package's CSV tables (and the user's): every row has a source and a locator, every number becomes SI here."""

import csv
import math
from collections.abc import Iterable
from pathlib import Path

from silostudy.errors import BadInput
from silostudy.tables.units import split_unit

HERE = Path(__file__).parent
TEXT = {"title", "source", "locator", "remark"}


def rows(path: Path, text: Iterable[str] = ()) -> list[dict]:
    """Rows of a CSV as dicts: columns in `text` stay text, the others become SI numbers without the unit in the name.

    Empty cells of number columns are left out.  Lines that start with # are remarks.
    Raises BadInput (file, line, column) for a cell that is no number, a missing file, or a row without source or locator.
    """
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput("file", str(path), f"must be a readable CSV table ({error})") from None
    kept = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.startswith("#")]
    reader = csv.DictReader(line for _, line in kept)
    found = []
    for (number, _), raw in zip(kept[1:], reader, strict=True):
        where = f"{path.name} line {number}"
        _require_cells(raw, where)
        found.append({**_converted(raw, TEXT | set(text), where), "where": where})
    return found


def _require_cells(raw: dict, where: str) -> None:
    if None in raw or None in raw.values():
        raise BadInput("row", list(filter(None, raw.values())), "has more or fewer cells than the header", where)
    for column in ("source", "locator"):
        if not (raw.get(column) or "").strip():
            raise BadInput(column, raw.get(column), "every row of a table must say where its values come from", where)


def _converted(raw: dict, text: set[str], where: str) -> dict:
    row: dict = {}
    for column, cell in raw.items():
        cell = cell.strip()
        if column in text:
            row[column] = cell
        elif cell:
            quantity, _, factor = split_unit(column)
            row[quantity] = number(cell, column, where) * factor
    return row


def number(cell: str, column: str, where: str) -> float:
    """A finite number from a table cell, or BadInput."""
    try:
        value = float(cell)
    except ValueError:
        raise BadInput(column, cell, "must be a number", where) from None
    if not math.isfinite(value):
        raise BadInput(column, cell, "must be finite", where)
    return value
