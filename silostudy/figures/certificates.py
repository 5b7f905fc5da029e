"""Accuracy that was asked of means, what the runs of a sweep estimated of it, and what it cost."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.certificates import step_unsure
from silostudy.figures.style import BLACK, BLUE, TALLEST, VERMILION, WIDTH, foot, headline, plt, save

ROW = 0.3  # inches of a case
LOOKS = {1.0: (BLUE, "o", "found, met"), 0.0: (VERMILION, "X", "found, not met")}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row for each case and quantity."""
    table = certificates(cube)
    figure, panel = plt.subplots(figsize=(WIDTH, min(TALLEST, 2.0 + ROW * len(table))))
    rows = np.arange(len(table))
    marks = panel.plot(100.0 * table["error_asked"], rows, "|", color=BLACK, markersize=13, markeredgewidth=2, label="asked")
    for met, (colour, marker, label) in LOOKS.items():
        part = table["error_met"] == met
        if part.any():
            marks += panel.plot(100.0 * table["error_bound"][part], rows[part], marker, color=colour, label=label)
    panel.set_yticks(rows, [f"{quantity}, {case}" for quantity, case in zip(table["quantity"], table["case"], strict=True)])
    panel.set(xlabel="error of the mean that 95 % of such means keep (%)", xlim=(0.0, None), ylim=(len(table) - 0.5, -0.5))
    for row, told in zip(rows.tolist(), map(_told, table.itertuples()), strict=True):
        panel.text(1.02, row, told, transform=panel.get_yaxis_transform(), va="center", fontsize="small")
    cases = table.drop_duplicates("case")
    spent, on_step = cases["cpu_time"].sum(), cases["cpu_time_on_step"].sum()
    taken = f"{cases['fillings_computed'].sum():.0f} fillings, {spent:.3g} CPU s, {on_step:.2g} of them on the step"
    headline(figure, f"{int(table['error_met'].sum())} of {len(table)} means scatter by no more than asked: {taken}")
    unsure = int(step_unsure(table).sum())
    told = f"Of {unsure} the few fillings at half the step do not show that the step errs by less than asked." if unsure else ""
    foot(figure, str(cube.attrs["title"]), told, handles=marks)
    save(figure, table, stem)


def certificates(cube: xr.Dataset) -> pd.DataFrame:
    """A row for each case that was computed and each quantity: error asked for and found, fillings, step, CPU time (s)."""
    names = ["error_asked", "error_bound", "error_met", "step_change", "step_change_deviation", "fillings_computed",
             "time_step", "cpu_time", "cpu_time_on_step"]  # fmt: skip
    axes = str(cube.attrs["sweep_axes"]).split()
    table = cube[names].to_dataframe(dim_order=[*axes, "asked_quantity"])[names].reset_index()
    case = [", ".join(f"{axis} {_shown(row[axis])}" for axis in axes) or "the scene" for _, row in table.iterrows()]
    table = table.rename(columns={"asked_quantity": "quantity"}).drop(columns=axes)
    table.insert(0, "case", case)
    return table.dropna(subset=["error_bound"]).reset_index(drop=True)


def _shown(value) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _told(row) -> str:
    """Fillings and CPU time of a row, and the mean's change at half the step."""
    step = (
        ""
        if np.isnan(row.step_change)
        else f"; half the step {100 * row.step_change:+.1f} ± {100 * row.step_change_deviation:.1f} %"
    )
    return f"{row.fillings_computed:.0f} fillings, {row.cpu_time:.3g} CPU s{step}"
