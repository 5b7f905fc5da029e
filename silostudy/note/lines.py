"""The lines of a calculation note: what each reads from the cubes, and its formula with those numbers put in."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from math import isclose, isnan
from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.errors import BadInput
from silostudy.note import formula
from silostudy.note.mathml import UNITS, math, mo, number, row, shown, symbol, tag, width
from silostudy.tables.read import rows

# width of a formula (signs) that fills its column
LONG = 36  # in the usual size
LONGER = 51  # in the smaller one
AGREES = 1e-6  # relative: how far the value of a formula may lie from what the cube holds
TEXT = ("section", "owner", "name", "what", "unit", "read", "formula", "when", "words", "source", "locator", "remark")


@dataclass(frozen=True)
class Line:
    """A row of lines.csv: see there."""

    section: str
    owner: tuple[str, ...]
    name: str
    what: str
    unit: str
    variable: str
    places: tuple[tuple[str, str], ...]
    formula: str
    when: str
    words: tuple[str, ...]
    source: str
    locator: str
    remark: str


@dataclass(frozen=True)
class Scope:
    """Parts of the cubes that a section reads, and the names that are known so far with their value (SI) and unit shown."""

    cubes: tuple[xr.Dataset, ...]
    known: dict[str, tuple[float, str]] = field(default_factory=dict)

    def reading(self, *cubes: xr.Dataset, **flags: float) -> "Scope":
        """A scope of its own that knows the same, reads elsewhere, and has further numbers for the conditions."""
        return Scope(cubes or self.cubes, {**self.known, **{name: (float(value), "") for name, value in flags.items()}})

    def holds(self, condition: str) -> bool:
        """Whether a condition is met; it is not where it speaks of a name that is not known."""
        asked = formula.names(condition) if condition else []
        if any(name not in self.known for name in asked):
            return False
        return not condition or formula.evaluate(condition, self.numbers(asked)) == 1

    def numbers(self, names: Iterable[str]) -> dict[str, float]:
        """The values (SI) of known names."""
        return {name: self.known[name][0] for name in names}


@dataclass(frozen=True)
class Written:
    """A line with its result from the cube (SI), the value of its formula with the numbers before it, and their MathML."""

    line: Line
    result: float
    value: float
    symbols: str
    numbers: str
    shown: str
    origin: str = ""

    @property
    def size(self) -> str:
        """Size in which a formula stands beside its name: `long`, `longer` (its source below it), or as it is."""
        widest = max(width(text) for text in (self.symbols, self.numbers))
        return "longer" if widest > LONGER else "long" if widest > LONG else ""

    @property
    def constant(self) -> bool:
        """Whether the formula is a number, which is the result."""
        return bool(self.line.formula) and not formula.names(self.line.formula)

    @property
    def agrees(self) -> bool:
        """Whether the formula gives what the cube holds; a line without one has nothing to compare."""
        return isnan(self.value) or isclose(self.value, self.result, rel_tol=AGREES, abs_tol=1e-9)


@cache
def lines(section: str) -> tuple[Line, ...]:
    """The rows of a section, in order."""
    return tuple(line for line in every_line() if line.section == section)


@cache
def every_line() -> tuple[Line, ...]:
    """All rows of the table."""
    return tuple(_line(raw) for raw in rows(Path(__file__).parent / "lines.csv", TEXT))


def _line(raw: Mapping[str, str]) -> Line:
    cells = {name: raw[name] for name in TEXT if name not in ("read", "owner", "words")}
    variable, *where = raw["read"].split()
    if raw["unit"] not in UNITS:
        raise BadInput("unit", raw["unit"], f"known: {', '.join(UNITS)}", "lines.csv")
    places = tuple((word.partition("=")[0], word.partition("=")[2]) for word in where)
    words = tuple(raw["words"].split("|")) if raw["words"] else ()
    return Line(**cells, owner=tuple(raw["owner"].split()), variable=variable, places=places, words=words)


def write(section: str, scope: Scope, owner: str = "") -> list[Written]:
    """The lines of a section that hold in a scope, which then knows their names; owner: of the lines that have one."""
    written_lines = []
    for line in lines(section):
        if (line.owner and owner not in line.owner) or not scope.holds(line.when):
            continue
        result = read(line, scope.cubes)
        if not isnan(result):
            written_lines.append(written(line, result, scope))
            scope.known[line.name] = (result, line.unit)
    return written_lines


def read(line: Line, cubes: Iterable[xr.Dataset]) -> float:
    """The number that a line reads; NaN where the cubes do not hold it or mask it."""
    for cube in cubes:
        if line.variable in cube.variables:
            values = cube[line.variable]
            for dim, place in line.places:
                values = (
                    values.isel({dim: 0 if place == "first" else -1})
                    if place in ("first", "last")
                    else values.sel({dim: place})
                )
            if values.ndim:
                raise BadInput(
                    "line", f"{line.section}, {line.name}", f"{line.variable} still has {', '.join(map(str, values.dims))}"
                )
            return float(values)
    return np.nan


def written(line: Line, result: float, scope: Scope) -> Written:
    """A line with its result and its formula in numbers."""
    sign = tag("mtext", "\u00a0if\u00a0") if line.words else mo("=")
    told = line.words[int(result)] if line.words else shown(result, line.unit)
    if not line.formula or any(name not in scope.known for name in formula.names(line.formula)):
        return Written(line, result, np.nan, math(symbol(line.name)), "", told)
    asked = formula.names(line.formula)
    symbols = row(symbol(line.name), sign, formula.mathml(line.formula, symbol))
    put_in = asked and asked != [line.formula]  # a constant, or one other quantity, says all with its result
    numbers = formula.mathml(line.formula, lambda name: number(*scope.known[name])) if put_in else ""
    value = formula.evaluate(line.formula, scope.numbers(asked))
    return Written(
        line, result, value, math(symbols), math(row(mo("=") if not line.words else "", numbers)) if numbers else "", told
    )


def result_of(line: Written) -> str:
    """MathML of a line's result with its unit."""
    content = tag("mtext", line.shown) if line.line.words else number(line.result, line.line.unit, bracketed=False)
    return math(row(mo("→" if line.line.words else "="), content))
