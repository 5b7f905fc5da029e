"""Measurements of silos and their solids, each with the source it was read in."""

from dataclasses import dataclass, field
from functools import cache
from math import isnan, nan

from silostudy.tables.read import HERE, rows
from silostudy.tables.units import split_unit

TEXT = (
    "measurement", "kind", "scale", "plan", "solid", "taken_solid", "taken_wall", "phase", "quantity", "unit", "formula",
    "answer", "why_none",
)  # fmt: skip
KINDS = ("profile value", "extreme", "gradient", "ratio", "formula", "property")
SWELLING_OVER_FILLING = "swelling_over_filling"  # an answer that is no variable of a cube


@dataclass(frozen=True, kw_only=True)
class Measurement:
    """One measurement: value and spread in SI, `shown` and `unit` as the source has them; NaN or empty where it says nothing.

    taken_solid, taken_wall: what the methods are handed for it; answer: the variable of a cube that answers it, or empty,
    and then why_none says why; formula: how the value follows from the taken solid, in place of a value.
    """

    measurement: str
    title: str
    kind: str
    scale: str
    plan: str
    diameter: float = nan
    height: float = nan
    solid: str
    taken_solid: str
    taken_wall: str
    phase: str
    depth: float = nan
    quantity: str
    value: float = nan
    shown: float = nan
    unit: str
    spread: float = nan
    formula: str
    answer: str
    why_none: str
    source: str
    locator: str
    remark: str
    where: str = field(repr=False, compare=False)

    @property
    def factor(self) -> float:
        """The size of the unit in SI."""
        return _factor(self.unit)

    @property
    def told(self) -> str:
        """Value and unit for people, with the spread where there is one."""
        number = self.formula if isnan(self.shown) else f"{self.shown:g}"
        spread = "" if isnan(self.spread) else f" +- {self.spread / self.factor:g}"
        return number + spread + ("" if self.unit == "1" else f" {self.unit}")


def _factor(unit: str) -> float:
    return split_unit(f"value_{unit.replace('/', '_')}")[2]


@cache
def measurements() -> tuple[Measurement, ...]:
    """Every measurement, in the order of the table."""
    return tuple(_measured(row) for row in rows(HERE / "measured_silos.csv", text=TEXT))


def _measured(row: dict) -> Measurement:
    inside = {name: row[name] * _factor(row["unit"]) for name in ("value", "spread") if name in row}
    return Measurement(**row | inside | {"shown": row.get("value", nan)})


def measured_pressures() -> list[Measurement]:
    """The measured wall pressures of known depth in silos of known size."""
    return [measurement for measurement in measurements() if measurement.answer == "wall_normal_pressure"]
