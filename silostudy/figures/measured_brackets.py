"""Every measurement of the tables with the methods next below and above it, or why none answers.

What moisture does to the wall pressure is no number of a method but a quotient of two over depth: where a curve of it comes to
the measured value.
"""

from itertools import groupby
from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.measured import cases_of, deviations, neighbour
from silostudy.figures import measured_swelling
from silostudy.figures.style import WIDTH, foot, headline, look, save
from silostudy.tables.measured import SWELLING_OVER_FILLING, Measurement, measurements
from silostudy.tables.outputs import output_of

STATIC, FILLED, SWOLLEN = output_of(__name__).methods
LANES = 0.52  # of the room of a measurement, in which each method has a lane
BEHIND = {"facecolor": "white", "edgecolor": "none", "pad": 1}
PLACES = (0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0)  # ticks of computed over measured


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure, and a table of a finding a measurement, every method's value and the curves."""
    plain = [point for point in measurements() if point.answer not in ("", SWELLING_OVER_FILLING)]
    swollen = [point for point in measurements() if point.answer == SWELLING_OVER_FILLING]
    silent = [point for point in measurements() if not point.answer]
    figure, axes = plt.subplot_mosaic("ab", figsize=(WIDTH, 9.5), width_ratios=(1.1, 1))
    tables = [_compared(cube, point) for point in plain]
    _strip(axes["a"], cube, plain, tables)
    curves = measured_swelling.curves(cube, swollen, SWOLLEN, (FILLED, STATIC))
    crossings = measured_swelling.crossings(curves, swollen)
    measured_swelling.draw_on(axes["b"], curves, crossings, swollen)
    headline(figure, _message(tables))
    handles = [handle for panel in axes.values() for handle in panel.get_legend_handles_labels()[0]]
    foot(figure, cube.attrs["title"], *_unanswered(silent), handles=handles)
    findings = [_bracketed(cube, *pair) for pair in zip(plain, tables, strict=True)]
    findings += [_finding(point, measured_swelling.words(crossings, point)) for point in swollen]
    findings += [_finding(point, point.why_none) for point in silent]
    save(figure, pd.concat([pd.DataFrame(findings), *tables, crossings, curves], ignore_index=True), stem)


def _message(tables: list[pd.DataFrame]) -> str:
    """Message of the figure, in numbers: how many measurements lie between methods, and how near the nearest come."""
    off = pd.concat([table.assign(row=row) for row, table in enumerate(tables)]).groupby("row").off
    between = int(((off.min() < 0) & (off.max() >= 0)).sum())
    nearest = 100 * off.agg(lambda values: np.abs(values).min())
    return (
        f"{between} of {len(tables)} measured values lie between the methods for the measured phase;"
        f" the nearest method is {nearest.min():.0f} to {nearest.max():.0f} % off"
    )


def _finding(point: Measurement, verdict: str) -> dict:
    return {
        "shown": "finding", "measurement": point.measurement, "title": point.title, "kind": point.kind, "scale": point.scale,
        "solid": point.solid, "taken_solid": point.taken_solid, "taken_wall": point.taken_wall, "quantity": point.quantity,
        "value_with_unit": point.told, "verdict": verdict, "source": f"{point.source}, {point.locator}", "remark": point.remark,
    }  # fmt: skip


def _name(cube: xr.Dataset, method: str) -> str:
    return str(cube["pressure_method_title"].sel(pressure_method=method).values)


# ---- values beside a measurement ----
def _compared(cube: xr.Dataset, point: Measurement) -> pd.DataFrame:
    """Every method's value in the measured phase; the swelling solid is another state."""
    place, *_ = cases_of(cube, point)
    methods = [method for method in map(str, cube["pressure_method"].values) if method != SWOLLEN]
    table = deviations(cube.isel(silo=place), point, methods)
    return table[table.phase == point.phase].assign(shown="method", ratio=lambda rows: rows.off + 1)


def _bracketed(cube: xr.Dataset, point: Measurement, table: pd.DataFrame) -> dict:
    finding = _finding(point, _words(cube, table))
    for where in ("below", "above"):
        methods, off = neighbour(table, where)
        finding |= {f"next_{where}": " ".join(methods), f"next_{where}_off": off}
    return finding | {"measured": table.measured.iloc[0]}


def _words(cube: xr.Dataset, table: pd.DataFrame) -> str:
    told = []
    for where in ("below", "above"):
        methods, off = neighbour(table, where)
        names = ", ".join(_name(cube, method) for method in methods)
        told.append(f"next {where}: {names} ({100 * off:+.0f} %)" if methods else f"next {where}: no method")
    return "; ".join(told)


def _strip(panel: Axes, cube: xr.Dataset, plain: list[Measurement], tables: list[pd.DataFrame]) -> None:
    """Computed over measured, a row for each measurement and a lane for each method."""
    methods = [
        method
        for method in map(str, cube["pressure_method"].values)
        if any((t.pressure_method == method).any() for t in tables)
    ]
    values = pd.concat([table.assign(row=row) for row, table in enumerate(tables)])
    for lane, method in enumerate(methods):
        own = values[values.pressure_method == method]
        height = own.row + LANES * (lane / (len(methods) - 1) - 0.65)
        panel.plot(own.ratio, height, label=_name(cube, method), linestyle="none", markersize=7, **look(cube, method))
    for row, table in enumerate(tables):
        words = fill(_words(cube, table), 60)
        panel.text(0.01, row + 0.25, words, transform=panel.get_yaxis_transform(), va="top", fontsize="small", bbox=BEHIND)
    panel.axvline(1, color="black", linewidth=1.2)
    panel.set_yticks(np.arange(len(plain)), [_label(*pair) for pair in zip(plain, tables, strict=True)])
    panel.set(xscale="log", xlabel="computed over measured", ylim=(len(plain) - 0.4, -0.45), xlim=(0.55, 9))
    panel.set_xticks(PLACES, [f"{place:g}" for place in PLACES])
    panel.minorticks_off()
    panel.grid(axis="y", visible=False)
    panel.set_title("Values: every method that\ntreats the measured phase, filling")


def _label(point: Measurement, table: pd.DataFrame) -> str:
    place = "" if np.isnan(point.depth) else f" at {point.depth:g} m"
    value = f" = {table.measured.iloc[0]:.2f}" if point.formula else ""
    return f"{fill(point.title, 24)}\n{fill(point.quantity, 24)}\n{point.told}{value}{place}"


# ---- what none answers ----
def _unanswered(silent: list[Measurement]) -> list[str]:
    """Lines that name the measurements without an answer, by reason."""
    lines = []
    for why, group in groupby(silent, key=lambda point: point.why_none):
        what = "; ".join(f"{point.quantity} {point.told} ({point.title})" for point in group)
        lines.append(f"answered by no method: {what}: {why}")
    return lines
