"""Measured wall pressures of real silos, each with the source it was read in."""

from dataclasses import dataclass

from silostudy.tables.read import HERE, rows


@dataclass(frozen=True)
class Measured:
    """One measured wall pressure (Pa) at a depth (m) in a silo of diameter and height (m)."""

    silo: str
    title: str
    plan: str
    diameter: float
    height: float
    solid: str
    phase: str
    depth: float
    wall_normal_pressure: float
    source: str
    locator: str
    remark: str


def measured_silos() -> list[Measured]:
    """Every measured value, in the order of the table."""
    found = rows(HERE / "measured_silos.csv", text=("silo", "plan", "solid", "phase"))
    return [Measured(**{name: value for name, value in row.items() if name != "where"}) for row in found]
