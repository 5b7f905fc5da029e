"""Histories of base and top: measured, and computed with several effective mass coefficients, a column a case."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import MEASURED, answer, cases, head, kind, name
from silostudy.figures.style import save

WINDOW = 1.5  # s about the largest measured value; the whole history would be a band of ink


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the histories it shows."""
    columns = cases(cube)
    shown = list(map(float, cube["shown_coefficient"].values))
    figure, panels = plt.subplots(
        len(shown) + 2, len(columns), figsize=(5.6 * len(columns) + 1, 9.5), sharex="col", sharey="col", squeeze=False
    )
    tables = []
    for column, one in zip(panels.T, columns, strict=True):
        one = one.isel(sample=_window(one))
        _column(column, one, shown)
        column[0].set_title(f"{name(one)}\nC_eff found: {answer(one, 'amplitude_error')}", fontsize=9)
        tables.append(_numbers(one).assign(case=str(one["case"].values)))
    for panel in panels.flat:
        panel.set_ylabel("acceleration (m/s²)", fontsize=7)
    head(figure, cube, f"accelerations of base and top, {WINDOW:g} s about the largest value of (a) (grey: (a) again)")
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _window(one: xr.Dataset) -> slice:
    time = one["elapsed_time"].values
    peak = time[np.nanargmax(np.abs(one["measured_acceleration"].values))]
    inside = np.flatnonzero(np.abs(time - peak) <= WINDOW / 2)
    return slice(int(inside[0]), int(inside[-1]) + 1)


def _column(column, one: xr.Dataset, shown: list[float]) -> None:
    time, measured = one["elapsed_time"], one["measured_acceleration"]
    _panel(column[0], time, measured, f"(a) top, {kind(one)}", MEASURED)
    for number, (panel, coefficient) in enumerate(zip(column[1:-1], shown, strict=True), 1):
        panel.plot(time, measured, color=MEASURED, linewidth=1.6)
        computed = one["top_acceleration"].sel(shown_coefficient=coefficient)
        _panel(panel, time, computed, f"(b{number}) top, computed, C_eff = {coefficient:.2f}", "black")
    _panel(column[-1], time, one["base_acceleration"], "(c) base", "black")
    column[-1].set_xlabel("time at the model's scale (s)")


def _panel(panel, time, values, text: str, colour: str) -> None:
    panel.plot(time, values, color=colour, linewidth=0.8)
    panel.text(
        0.01, 0.98, text, transform=panel.transAxes, va="top", fontsize=8, bbox={"color": "white", "alpha": 0.8, "pad": 1}
    )


def _numbers(one: xr.Dataset) -> pd.DataFrame:
    table = {
        "time_s": one["elapsed_time"],
        "base_m_s2": one["base_acceleration"],
        "measured_m_s2": one["measured_acceleration"],
    }
    for coefficient in map(float, one["shown_coefficient"].values):
        table[f"computed_{coefficient:.2f}_m_s2"] = one["top_acceleration"].sel(shown_coefficient=coefficient)
    return pd.DataFrame({key: value.values for key, value in table.items()})
