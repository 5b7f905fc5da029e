"""Table 4.2.5 again: what the source prints, what the package computes, and by how much they differ."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.figures.style import save_table
from silostudy.tables.handbook import TONNE_PER_M2, Printed, errata, table_4_2_5

AS_PRINTED = "_as_printed"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the comparison as CSV: one row for each printed value and each reading of its method in the cube."""
    labels = [str(label) for label in cube["pressure_method"].values]
    rows = [
        _row(cube, printed, label)
        for printed in table_4_2_5()
        for label in (printed.method, printed.method + AS_PRINTED)
        if label in labels
    ]
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _row(cube: xr.Dataset, printed: Printed, label: str) -> dict:
    here = {"pressure_method": label, "phase": printed.phase, "depth": printed.depth}
    computed = float(cube["wall_normal_pressure"].sel(here))
    return {
        "pressure_method": label,
        "phase": printed.phase,
        "depth_m": printed.depth,
        "printed_t_m2": printed.wall_normal_pressure / TONNE_PER_M2,
        "computed_t_m2": computed / TONNE_PER_M2,
        "deviation": computed / printed.wall_normal_pressure - 1,
        "remark": remark(printed, label),
    }


def remark(printed: Printed, label: str) -> str:
    """The errors of the source that touch a printed value."""
    if label.endswith(AS_PRINTED):
        return "computed with the source's misprints left in"
    remarks = [
        f"{erratum.place}: printed {erratum.printed}, right {erratum.right}"
        for erratum in errata()
        if erratum.method == printed.method
        and erratum.phase == printed.phase
        and erratum.place.startswith("Table 4.2.5")
        and erratum.depth in (None, printed.depth)
    ]
    return "; ".join(remarks)
