"""Reads the package's CSV tables (and the user's): every row has a source and a locator, every number becomes SI here."""

import csv
import math
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from silostudy.errors import BadInput
from silostudy.tables.units import SUFFIXES, split_unit

HERE = Path(__file__).parent
TEXT = {"title", "source", "locator", "remark"}
NUMBER = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)([eEdD][+-]?\d{1,3})?", re.ASCII)  # D: an exponent as Fortran writes it


def rows(path: Path, text: Iterable[str] = (), units: Mapping[str, str] | None = None) -> list[dict]:
    """Rows of a CSV as dicts: columns in `text` stay text, the others become SI numbers without the unit in the name.

    units: quantity -> the SI unit that the unit in its column's name must come to.
    Empty cells of number columns are left out.  Lines that start with # are remarks.
    Raises BadInput (file, line, column) for a cell that is no number, a missing file, or a row without source or locator.
    """
    lines = text_of(path).splitlines()
    numbered = [(number, line) for number, line in enumerate(lines, 1) if line.strip() and not line.startswith("#")]
    if not numbered:
        raise BadInput("file", str(path), "must be a CSV table: it holds not even a header")
    (first, header), *rest = numbered
    text, where = TEXT | set(text), f"{path.name} line {first}"
    head = _cells(header, where)
    _check_head(head, text, units or {}, where)
    table = []
    for line_number, line in rest:
        where = f"{path.name} line {line_number}"
        raw = _row(head, _cells(line, where), where)
        table.append({**_converted(raw, text, where), "where": where})
    return table


def _cells(line: str, where: str) -> list[str]:
    try:
        return next(csv.reader([line], strict=True))
    except csv.Error as error:
        raise BadInput("row", short(line), f"must be a line of CSV ({error})", where) from None


def _check_head(head: list[str], text: set[str], units: Mapping[str, str], where: str) -> None:
    """BadInput for a quantity that stands in two columns, or in a unit that is none of its own."""
    read: dict[str, str] = {}
    for column in head:
        quantity, unit, _ = (column, "", 1.0) if column in text else split_unit(column)
        if quantity in read:
            raise BadInput("column", column, f"says the same as the column {read[quantity]!r}", where)
        if quantity in units and unit != units[quantity]:
            endings = [suffix for suffix, (known, _) in SUFFIXES.items() if known == units[quantity]]
            allowed = f"must end in its unit: {', '.join(endings)}" if endings else "has no unit"
            raise BadInput("column", column, f"{quantity} {allowed}", where)
        read[quantity] = column


def _row(head: list[str], cells: list[str], where: str) -> dict[str, str]:
    if len(cells) != len(head):
        raise BadInput("row", [short(cell) for cell in cells], "has more or fewer cells than the header", where)
    raw = dict(zip(head, cells, strict=True))
    for column in ("source", "locator"):
        if not raw.get(column, "").strip():
            raise BadInput(column, raw.get(column), "every row of a table must say where its values come from", where)
    return raw


def _converted(raw: dict[str, str], text: set[str], where: str) -> dict:
    row: dict = {}
    for column, cell in raw.items():
        cell = cell.strip()
        if column in text:
            row[column] = cell
        elif cell:
            quantity, _, factor = split_unit(column)
            row[quantity] = number(cell, column, where) * factor
    return row


def is_number(cell: str) -> bool:
    """Whether a cell holds a number, or what programs write where they have none that is finite."""
    return bool(NUMBER.fullmatch(cell)) or cell.lower().lstrip("+-") in ("nan", "inf", "infinity")


def number(cell: str, column: str, where: str) -> float:
    """A finite number from a table cell, or BadInput."""
    if not is_number(cell):
        raise BadInput(column, short(cell), "must be a number", where)
    value = float(cell.lower().replace("d", "e"))
    if not math.isfinite(value):
        raise BadInput(column, short(cell), "must be finite", where)
    return value


def text_of(path: Path, errors: str = "strict") -> str:
    """The text of a file, with or without a byte order mark; BadInput where there is none to be read."""
    try:
        return path.read_text(encoding="utf-8-sig", errors=errors)
    except (OSError, ValueError) as error:  # ValueError: bytes that are no UTF-8, or a path with a null byte
        told = getattr(error, "strerror", None) or error
        raise BadInput("file", str(path), f"must be a readable file of text ({told})") from None


def short(text: str) -> str:
    """A text to be shown in a message, cut where it is long."""
    return text if len(text) <= 40 else text[:40] + "..."
