"""Reads text files of columns of numbers, as records and quakes come in: a time in front, a line a sample, equal steps."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, log10
from pathlib import Path

import numpy as np

from silostudy.errors import BadInput
from silostudy.tables.read import is_number, number, short, text_of

LONGEST = 1e9  # s: far beyond any history
JITTER = 0.01  # of a step: how far a step may be off besides the print's rounding
COARSE = 4.0  # a step must be so many units of the times' last digit before their rounding excuses anything


@dataclass(frozen=True)
class Columns:
    """The cells of a file: head, the names above the numbers (none: ()), remarks above them, and the line of each row."""

    path: Path
    head: tuple[str, ...]
    remarks: tuple[str, ...]
    lines: tuple[int, ...]
    cells: tuple[tuple[str, ...], ...]

    def column(self, name: str, place: int) -> np.ndarray:
        """The finite numbers of a column; BadInput names the line of a cell that is none."""
        return np.array([number(cells[place], name, self.place_of(row)) for row, cells in enumerate(self.cells)])

    def place_of(self, row: int) -> str:
        """File and line of a row, for messages."""
        return f"{self.path} line {self.lines[row]}"


def read_columns(path: Path, names: Sequence[str]) -> Columns:
    """Rows of as many cells as there are names, two at least; commas or blanks part them, # starts a remark.

    A first row without any number is the head.  BadInput names file and line of what is wrong.
    """
    rows, remarks = [], []
    for line_number, line in enumerate(text_of(path).splitlines(), 1):
        data, _, remark = line.partition("#")
        if data.strip():
            cells = tuple(cell.strip() for cell in data.split(",")) if "," in data else tuple(data.split())
            rows.append((line_number, cells))
        if not rows:
            remarks.append(remark.strip())
    with_head = bool(rows) and not any(map(is_number, rows[0][1]))
    head, rows = (rows[0][1] if with_head else ()), rows[with_head:]
    for line_number, cells in rows:
        if len(cells) != len(names):
            told = f"must hold the {len(names)} columns {', '.join(names)}, parted by commas or blanks"
            raise BadInput("row", short(" ".join(cells)), told, f"{path} line {line_number}")
    if len(rows) < 2:
        raise BadInput("rows", len(rows), f"must be two or more, of {', '.join(names)}", str(path))
    return Columns(path, head, tuple(remarks), tuple(n for n, _ in rows), tuple(cells for _, cells in rows))


def equal_steps(columns: Columns, place: int = 0) -> tuple[float, float]:
    """Start and step (s) of equally spaced times in a column; BadInput names the first line that is out of step.

    Times carry the rounding of their print: 1/128 s to three decimals are equal steps, of 1/128 s.
    """
    time = columns.column("time", place)
    if np.abs(time).max() > LONGEST:
        row = int(np.abs(time).argmax())
        raise BadInput("time", columns.cells[row][place], f"must lie within {LONGEST:g} s", columns.place_of(row))
    unit = printed_unit([row[place] for row in columns.cells], time)
    steps = np.diff(time)
    usual = float(np.sort(steps)[(len(steps) - 1) // 2])
    rounding = unit if unit.max() * COARSE <= usual else np.zeros_like(unit)
    off = np.abs(steps - usual) > JITTER * abs(usual) + rounding[1:]
    if usual <= 0 or off.any():
        row = int(np.argmax((steps <= 0) | off)) + 1
        told = f"must rise by equal time steps: here by {steps[row - 1]:g} s, mostly by {usual:g} s"
        raise BadInput("time", columns.cells[row][place], told, columns.place_of(row))
    step = _simplest(time, rounding)
    stray = np.abs(time - time[0] - step * np.arange(len(time)))
    if (stray > 0.5 * step + rounding).any():
        row = int(np.argmax(stray))
        told = f"must rise by equal time steps: {stray[row]:g} s off a common step of {step:g} s"
        raise BadInput("time", columns.cells[row][place], told, columns.place_of(row))
    return float(time[0]), step


def printed_unit(cells: Sequence[str], values: np.ndarray) -> np.ndarray:
    """Unit of the last digit that each number is printed to, whether with fixed decimals or with fixed digits."""
    shapes = [_shape(cell) for cell in cells]
    decimals, digits = max(shape[0] for shape in shapes), max(shape[1] for shape in shapes)
    leading = [floor(log10(abs(value))) if value else -decimals for value in values.tolist()]
    return np.array([10.0 ** min(max(-decimals, first + 1 - digits), 300) for first in leading])


def _shape(cell: str) -> tuple[int, int]:
    """Decimals of a printed number, and its digits from the first that is not 0."""
    mantissa, _, exponent = cell.lower().replace("d", "e").partition("e")
    whole, _, fraction = mantissa.lstrip("+-").partition(".")
    return len(fraction) - int(exponent or 0), len((whole + fraction).lstrip("0"))


def _simplest(time: np.ndarray, rounding: np.ndarray) -> float:
    """The step (s) with a whole sampling rate, else the shortest decimal, that the ends admit; else their mean step."""
    count = len(time) - 1
    mean = (time[-1] - time[0]) / count
    room = (rounding[0] + rounding[-1]) / 2 / count + 4e-16 * abs(time).max()
    rate = round(1 / mean) if mean < 1 else 0
    decimals = (round(mean, places) for places in range(1, 17))
    candidates = ([1 / rate] if rate else []) + list(decimals)
    return next((step for step in candidates if step > 0 and abs(step - mean) <= room), float(mean))
