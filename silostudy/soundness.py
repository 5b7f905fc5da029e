"""Faults of the rows of any family, in words: each function yields those of a part, none of a sound one."""

import re
from collections.abc import Callable, Iterable, Iterator
from inspect import getdoc
from textwrap import shorten

import numpy as np

MARKERS = set(".,ov^<>12348spP*hH+xXDd|_")  # of matplotlib; or $text$
SHOWN = 300  # characters of an error
LINES = ("solid", "dashed", "dashdot", "dotted", "-", "--", "-.", ":")  # of matplotlib


def faults_of_look(row) -> Iterator[str]:
    """Faults of how a row is drawn and explained: colour, marker, line where it has one, formula, range."""
    if not re.fullmatch(r"#[0-9A-Fa-f]{6}", row.colour):
        yield f"colour = {row.colour!r}: must be #rrggbb"
    if row.marker not in MARKERS and not re.fullmatch(r"\$.+\$", row.marker):
        yield f"marker = {row.marker!r}: must be $text$ or one of {' '.join(sorted(MARKERS))}"
    if getattr(row, "line", LINES[0]) not in LINES:
        yield f"line = {row.line!r}: must be one of {' '.join(LINES)}"
    for name in ("formula", "validity"):
        if not getattr(row, name).strip():
            yield f"{name} must not be empty"


def faults_of_function(name: str, function: Callable, unit: str, asked: Iterable[str], known: Iterable[str]) -> Iterator[str]:
    """Faults of a function of a row: no unit in its docstring, a parameter that has no unit in the family."""
    written = unit.replace(" m-1", "/m").replace(" m-", "/m")
    doc = getdoc(function) or ""
    if f"({unit}" not in doc and f"({written}" not in doc:
        yield f"{name}: its docstring must name its unit, ({written})"
    if strange := [parameter for parameter in asked if parameter not in known]:
        yield f"{name}: asks for {', '.join(strange)}, which has no unit; known: {', '.join(known)}"


def faults_of_trial(name: str, trial: Callable[[], object]) -> Iterator[str]:
    """Faults of a function of a row when it is called with arrays of usual values."""
    try:
        trial()
    except Exception as error:
        yield f"{name}: fails for usual values: {type(error).__name__}: {shorten(str(error), SHOWN)}"


def check_numbers(call: Callable[[], object]) -> np.ndarray:
    """Result of a call, as an array; ValueError unless these are finite or NaN, real, and the same when called again."""
    values = np.asarray(call())
    if values.dtype.kind not in "fiub":
        raise ValueError(f"gives no real numbers but {values.ravel()[:1]}")
    if np.isinf(values).any():
        raise ValueError("gives an infinite value")
    if not np.array_equal(values, np.asarray(call()), equal_nan=True):
        raise ValueError("gives other values when it is called again")
    return values
