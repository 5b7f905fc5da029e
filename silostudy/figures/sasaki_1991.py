"""The source's printed numbers beside the computed ones, and what they say about each other."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.figures.shaken import cases, printed
from silostudy.figures.style import save_table
from silostudy.tables.sasaki_1991 import PrintedTest, printed_tests

GIVEN = "given to the model"
BEAM = "depends on the beam: the assumed height is such that the three printed values come out"
IMITATED = "from an imitation with the source's coefficient, not from its records"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the table: test, quantity, printed, computed, remark."""
    rows = _sine(cases(cube)[0])
    for case in cases(cube):
        source = printed(cube, case)
        rows += _earthquake(case, source) if source else []
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _row(test: str, quantity: str, shown: float, computed: float, remark: str) -> dict:
    return {"test": test, "quantity": quantity, "printed": shown, "computed": computed, "remark": remark}


def _sine(case: xr.Dataset) -> list[dict]:
    source = printed_tests()["sine"]
    empty, full = case.sel(curve="empty"), case.sel(curve="full")
    low, high = (float(case["sine_coefficient_bound"].sel(bound=end)) for end in ("lower", "upper"))
    remark = f"{low:.3f} to {high:.3f} by the rounding of 33 and 19 Hz: the print is compatible with it, not confirmed"
    return [
        _row("sine", "empty_frequency_Hz", source.empty_frequency, float(empty["sine_frequency"]), GIVEN),
        _row("sine", "full_frequency_Hz", source.full_frequency, float(full["sine_frequency"]), GIVEN),
        _row("sine", "stiffness_reduction", source.stiffness_reduction, float(case["sine_stiffness_reduction"]), BEAM),
        _row("sine", "effective_mass_coefficient", source.effective_mass_coefficient, float(full["sine_coefficient"]), remark),
        _ratio("sine", source, case),
    ]


def _earthquake(case: xr.Dataset, source: PrintedTest) -> list[dict]:
    coarse = case["effective_mass_coefficient"].sel(identification="amplitude_error_coarse")
    at_print = case["candidate_frequency"].sel(coefficient=source.effective_mass_coefficient, method="nearest")
    name = source.test
    return [
        _row(name, "empty_frequency_Hz", source.empty_frequency, float(case["empty_frequency"]), GIVEN),
        _row(name, "damping_ratio", source.damping_ratio, float(case["damping_ratio"]), GIVEN),
        _row(name, "stiffness_reduction", source.stiffness_reduction, float(case["stiffness_reduction"]), BEAM),
        _row(name, "full_frequency_Hz", source.full_frequency, float(at_print), "at the printed coefficient"),
        _row(name, "effective_mass_coefficient", source.effective_mass_coefficient, float(coarse), IMITATED),
        _ratio(name, source, case),
    ]


def _ratio(test: str, source: PrintedTest, case: xr.Dataset) -> dict:
    remark = "printed: implied by the printed frequencies and coefficient; computed: of the assumed model"
    return _row(test, "contents_over_wall_mass", source.implied_mass_ratio, float(case["mass_ratio"]), remark)
