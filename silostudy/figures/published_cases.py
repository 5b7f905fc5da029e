"""Published cases over several fillings: how far each came out off the published number, in its tolerance."""

from math import floor, log10
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.beside import interval
from silostudy.figures.style import GREEN, INK, ORANGE, VERMILION, WIDTH, foot, headline, plt, save
from silostudy.tables.published_cases import published_of

COLOURS = {"met": GREEN, "not met": VERMILION, "mean met, not every filling": ORANGE, "not seen": INK}
UNITS = {"degree": "degrees", "kg s-1": "kg/s"}  # in words


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a row a published number, every filling and their mean with its interval."""
    table, fillings = verdicts(cube)
    figure, panel = plt.subplots(figsize=(WIDTH, 2.2 + 0.9 * len(table)))
    panel.axvspan(-1.0, 1.0, color=GREEN, alpha=0.12, linewidth=0)
    panel.axvline(0.0, color="black", linewidth=0.8)
    for place, (row, values) in enumerate(zip(table.itertuples(), fillings, strict=True)):
        _row(panel, place, row, values)
    panel.set_yticks(range(len(table)), [fill(title, 26) for title in table["title"]])
    panel.set_ylim(len(table) - 0.4, -0.8)
    ends = [*table["low_95"], *table["high_95"], *(value for values in fillings for value in values)]
    reach = max(3.0, 1.15 * float(np.nanmax(np.abs([0.0, *ends]))))
    panel.set(xlim=(-reach, reach), xlabel="distance from the published number, in its tolerances")
    headline(figure, message(table))
    foot(
        figure,
        f"{cube.attrs['title']}; dots: fillings, diamond: their mean with its 95 % interval; green: within the tolerance",
    )
    save(figure, _numbers(table, fillings), stem)


def message(table: pd.DataFrame) -> str:
    """Sentence on what the figure says: how many numbers every filling meets, and how many the mean of the fillings."""
    every, means = int((table["verdict"] == "met").sum()), int((table["off_tolerances"].abs() <= 1.0).sum())
    return f"Of {len(table)} published numbers, {means} are met by the mean of the fillings and {every} by every filling"


def _numbers(table: pd.DataFrame, fillings: list[np.ndarray]) -> pd.DataFrame:
    """A row a published number, of the mean, and a row a filling of it."""
    what = table[["case", "title", "quantity"]].to_dict("records")
    dots = [row | {"off_tolerances": off} for row, values in zip(what, fillings, strict=True) for off in values]
    return pd.concat([table.assign(of="mean"), pd.DataFrame(dots).assign(of="filling")])


def _row(panel: Axes, place: int, row: Any, values: np.ndarray) -> None:
    """Draws the fillings of a published number, their mean, and what the mean is in its unit."""
    colour = COLOURS[row.verdict]
    panel.plot(values, np.full(len(values), place), "o", color=colour, alpha=0.4, markersize=5)
    ends = [[row.off_tolerances - row.low_95], [row.high_95 - row.off_tolerances]]
    panel.errorbar(row.off_tolerances, place, xerr=ends, fmt="D", color=colour, capsize=4)
    unit, digits = UNITS.get(row.unit, row.unit), max(0, 1 - floor(log10(row.tolerance)))
    words = f"{row.mean:.{digits}f} {unit} ({row.published:g} ± {row.tolerance:g}): {row.verdict}"
    panel.annotate(words, (0.99, place), xycoords=("axes fraction", "data"), xytext=(0, 12), textcoords="offset points",
                   ha="right", fontsize="small")  # fmt: skip


def verdicts(cube: xr.Dataset) -> tuple[pd.DataFrame, list[np.ndarray]]:
    """Rows of published numbers (what fillings came to, its interval, met or not and by how much), and of their fillings."""
    rows, fillings = [], []
    for position, file in enumerate(map(str, cube["published_case"].values)):
        for number, published in enumerate(published_of(Path(file).stem)):
            values = cube["off_published"].isel(published_case=position, expectation=number).values
            values = values[np.isfinite(values)]
            off, low, high = interval(values)
            rows.append({
                "case": published.case, "title": published.title, "quantity": published.quantity, "unit": published.unit,
                "published": published.value, "tolerance": published.tolerance, "fillings": len(values),
                "mean": published.value + off * published.tolerance, "off_tolerances": off, "low_95": low, "high_95": high,
                "fillings_met": int((np.abs(values) <= 1.0).sum()), "verdict": verdict(values),
                "missed_by": max(abs(off) - 1.0, 0.0) * published.tolerance, "source": published.source,
                "locator": published.locator,
            })  # fmt: skip
            fillings.append(values)
    return pd.DataFrame(rows), fillings


def verdict(off: np.ndarray) -> str:
    """Whether fillings that are so many tolerances off meet the published number."""
    if not len(off):
        return "not seen"
    if abs(off.mean()) > 1.0:
        return "not met"
    return "met" if (np.abs(off) <= 1.0).all() else "mean met, not every filling"
