"""Measured differences between the engine and LAMMPS in means over fillings, by quantity."""

from dataclasses import dataclass

from silostudy.tables.read import HERE, rows

TEXT = ("quantity", "lammps_version", "study")


@dataclass(frozen=True)
class CodeDifference:
    """Difference of LAMMPS' mean of a quantity from the engine's (1) and half its interval, in a study's first setting.

    scatter: standard deviation of a filling over its mean (1), by the engine.
    """

    quantity: str
    study: str
    lammps_version: str
    fillings: int
    change: float
    half_interval: float
    scatter: float


CODE_DIFFERENCES = tuple(
    CodeDifference(
        raw["quantity"], raw["study"], raw["lammps_version"], round(raw["fillings"]), raw["change"], raw["half_interval"],
        raw["silostudy_scatter"],
    )
    for raw in rows(HERE / "code_differences.csv", text=TEXT)
)  # fmt: skip
