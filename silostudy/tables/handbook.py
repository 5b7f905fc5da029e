"""The handbook's own results, as printed, and the errors found in it."""

from dataclasses import dataclass

from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.read import HERE, rows

TONNE_PER_M2 = 1e3 * STANDARD_GRAVITY  # Pa
STATIC_COLUMN = "janssen"  # of Table 4.2.5: static Janssen


@dataclass(frozen=True)
class Printed:
    """One printed wall pressure (Pa) of Table 4.2.5."""

    method: str
    phase: str
    row: int
    depth: float
    wall_normal_pressure: float


@dataclass(frozen=True)
class Erratum:
    """An error of the source: where, what it prints, what is right and how that is known; depth only for one value."""

    erratum: str
    place: str
    printed: str
    right: str
    method: str
    phase: str
    evidence: str
    depth: float | None


def table_4_2_5() -> list[Printed]:
    """Every value of Table 4.2.5, column by column."""
    return [
        Printed(row["method"], row["phase"], int(row["row"]), row["depth"], row["wall_normal_pressure"])
        for row in rows(HERE / "table_4_2_5.csv", text=("method", "phase"))
    ]


def errata() -> list[Erratum]:
    """The errors of the source, from errata.csv."""
    names = ("erratum", "place", "printed", "right", "method", "phase", "evidence")
    printed = rows(HERE / "errata.csv", text=names)
    return [Erratum(**{name: row[name] for name in names}, depth=row.get("depth")) for row in printed]
