"""Histories of base and top: measured, and computed with several effective mass coefficients, a column a case."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import MEASURED, answer, cases, distance, head, kind, name, nearest
from silostudy.figures.style import BLACK, TALLEST, VERMILION, WIDTH, save

WINDOW = 1.5  # s about the largest measured value; the whole history would be a band of ink


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the histories it shows."""
    columns = cases(cube)
    shown = list(map(float, cube["shown_coefficient"].values))
    figure, panels = plt.subplots(
        len(shown) + 2, len(columns), figsize=(WIDTH, TALLEST), sharex="col", sharey="col", squeeze=False
    )
    tables, told = [], []
    for column, case in zip(panels.T, columns, strict=True):
        part = case.isel(sample=_window(case))
        _column(column, part, shown)
        column[0].set_title(f"{name(case)}\nC_eff: {answer(case, 'amplitude_error')}")
        tables.append(_numbers(part).assign(case=str(case["case"].values)))
        told.append(_told(part))
    figure.supylabel("acceleration (m/s²)")
    about = f"Accelerations of base and top, {WINDOW:g} s about the largest value of (a), which is grey in all; red: the"
    head(
        figure,
        cube,
        f"Computed tops come closest {' and '.join(told)}",
        f"{about} coefficient next to the one found. Off: root mean square of the difference over that of (a).",
    )
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _window(case: xr.Dataset) -> slice:
    time = case["elapsed_time"].values
    peak = time[np.nanargmax(np.abs(case["measured_acceleration"].values))]
    inside = np.flatnonzero(np.abs(time - peak) <= WINDOW / 2)
    return slice(int(inside[0]), int(inside[-1]) + 1)


def _told(case: xr.Dataset) -> str:
    """The shown coefficient that comes closest to the measured top, and how close."""
    off = {float(c): _off(case, float(c)) for c in case["shown_coefficient"].values}
    closest = min(off, key=lambda coefficient: off[coefficient])
    return f"with C_eff = {closest:.2f} ({100 * off[closest]:.0f} % off)"


def _off(case: xr.Dataset, coefficient: float) -> float:
    """Distance (1) of a computed top from the measured one."""
    return distance(case["top_acceleration"].sel(shown_coefficient=coefficient).values, case["measured_acceleration"].values)


def _column(column, case: xr.Dataset, shown: list[float]) -> None:
    time, measured = case["elapsed_time"], case["measured_acceleration"]
    _panel(column[0], time, measured, f"(a) top, {kind(case)}", MEASURED)
    for number, (panel, coefficient) in enumerate(zip(column[1:-1], shown, strict=True), 1):
        panel.plot(time, measured, color=MEASURED, linewidth=1.8)
        computed = case["top_acceleration"].sel(shown_coefficient=coefficient)
        text = f"(b{number}) top, C_eff = {coefficient:.2f}: {100 * _off(case, coefficient):.0f} % off"
        _panel(panel, time, computed, text, VERMILION if coefficient == nearest(case) else BLACK)
    _panel(column[-1], time, case["base_acceleration"], "(c) base", BLACK)
    column[-1].set_xlabel("time at the model's scale (s)")


def _panel(panel, time, values, text: str, colour: str) -> None:
    panel.plot(time, values, color=colour, linewidth=0.8)
    panel.margins(y=0.25)  # room for the words above the curve
    panel.text(0.01, 0.99, text, transform=panel.transAxes, va="top", fontsize="small")


def _numbers(case: xr.Dataset) -> pd.DataFrame:
    table = {
        "time_s": case["elapsed_time"],
        "base_m_s2": case["base_acceleration"],
        "measured_m_s2": case["measured_acceleration"],
    }
    for coefficient in map(float, case["shown_coefficient"].values):
        table[f"computed_{coefficient:.2f}_m_s2"] = case["top_acceleration"].sel(shown_coefficient=coefficient)
    return pd.DataFrame({key: value.values for key, value in table.items()})
