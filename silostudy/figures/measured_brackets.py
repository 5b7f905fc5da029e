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
from silostudy.figures.style import look, save
from silostudy.tables.measured import SWELLING_OVER_FILLING, Measured, measurements
from silostudy.tables.outputs import output_of

STATIC, FILLED, SWOLLEN = output_of(__name__).methods
LANES = 0.62  # of the room of a measurement, in which each method has a lane
BEHIND = {"facecolor": "white", "edgecolor": "none", "pad": 1}
PLACES = (0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0)  # ticks of computed over measured


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure, and a table of a finding a measurement, every method's value and the curves."""
    plain = [one for one in measurements() if one.answer not in ("", SWELLING_OVER_FILLING)]
    swollen = [one for one in measurements() if one.answer == SWELLING_OVER_FILLING]
    silent = [one for one in measurements() if not one.answer]
    figure, axes = plt.subplot_mosaic("ab;cc", figsize=(13, 9.4), height_ratios=(5, 1.15), width_ratios=(1.2, 1))
    tables = [_compared(cube, one) for one in plain]
    _strip(axes["a"], cube, plain, tables)
    curves = measured_swelling.curves(cube, swollen, SWOLLEN, (FILLED, STATIC))
    crossings = measured_swelling.crossings(curves, swollen)
    measured_swelling.draw_on(axes["b"], curves, crossings, swollen)
    _unanswered(axes["c"], silent)
    figure.suptitle(cube.attrs["title"])
    figure.legend(handles=axes["a"].get_legend_handles_labels()[0], loc="outside lower center", ncols=4, fontsize=8)
    findings = [_bracketed(cube, *pair) for pair in zip(plain, tables, strict=True)]
    findings += [_finding(one, measured_swelling.words(crossings, one)) for one in swollen]
    findings += [_finding(one, one.why_none) for one in silent]
    save(figure, pd.concat([pd.DataFrame(findings), *tables, crossings, curves], ignore_index=True), stem)


def _finding(one: Measured, verdict: str) -> dict:
    return {
        "shown": "finding", "measurement": one.measurement, "title": one.title, "kind": one.kind, "scale": one.scale,
        "solid": one.solid, "taken_solid": one.taken_solid, "taken_wall": one.taken_wall, "quantity": one.quantity,
        "value_with_unit": one.told, "verdict": verdict, "source": f"{one.source}, {one.locator}", "remark": one.remark,
    }  # fmt: skip


def _name(cube: xr.Dataset, method: str) -> str:
    return str(cube["pressure_method_title"].sel(pressure_method=method).values)


# ---- values beside a measurement ----
def _compared(cube: xr.Dataset, one: Measured) -> pd.DataFrame:
    """Every method's value in the measured phase; the swelling solid is another state."""
    place, *_ = cases_of(cube, one)
    methods = [method for method in map(str, cube["pressure_method"].values) if method != SWOLLEN]
    table = deviations(cube.isel(silo=place), one, methods)
    return table[table.phase == one.phase].assign(shown="method", ratio=lambda rows: rows.off + 1)


def _bracketed(cube: xr.Dataset, one: Measured, table: pd.DataFrame) -> dict:
    found = _finding(one, _words(cube, table))
    for where in ("below", "above"):
        methods, off = neighbour(table, where)
        found |= {f"next_{where}": " ".join(methods), f"next_{where}_off": off}
    return found | {"measured": table.measured.iloc[0]}


def _words(cube: xr.Dataset, table: pd.DataFrame) -> str:
    told = []
    for where in ("below", "above"):
        methods, off = neighbour(table, where)
        names = ", ".join(_name(cube, method) for method in methods)
        told.append(f"next {where}: {names} ({100 * off:+.0f} %)" if methods else f"next {where}: no method")
    return "; ".join(told)


def _strip(panel: Axes, cube: xr.Dataset, plain: list[Measured], tables: list[pd.DataFrame]) -> None:
    """Computed over measured, a row for each measurement and a lane for each method."""
    methods = [
        method
        for method in map(str, cube["pressure_method"].values)
        if any((t.pressure_method == method).any() for t in tables)
    ]
    every = pd.concat([table.assign(row=row) for row, table in enumerate(tables)])
    for lane, method in enumerate(methods):
        own = every[every.pressure_method == method]
        height = own.row + LANES * (lane / (len(methods) - 1) - 0.65)
        panel.plot(own.ratio, height, label=_name(cube, method), linestyle="none", markersize=7, **look(cube, method))
    for row, table in enumerate(tables):
        words = fill(_words(cube, table), 78)
        panel.text(0.01, row + 0.3, words, transform=panel.get_yaxis_transform(), va="top", fontsize=7.5, bbox=BEHIND)
    panel.axvline(1, color="black", linewidth=1.2)
    panel.set_yticks(np.arange(len(plain)), [_label(*pair) for pair in zip(plain, tables, strict=True)], fontsize=8)
    panel.set(xscale="log", xlabel="computed over measured", ylim=(len(plain) - 0.45, -0.55), xlim=(0.55, 9))
    panel.set_xticks(PLACES, [f"{place:g}" for place in PLACES])
    panel.minorticks_off()
    panel.grid(axis="y", visible=False)
    panel.set_title("Values: every method that treats the measured phase, filling")


def _label(one: Measured, table: pd.DataFrame) -> str:
    place = "" if np.isnan(one.depth) else f" at {one.depth:g} m"
    value = f" = {table.measured.iloc[0]:.2f}" if one.formula else ""
    return f"{fill(one.title, 30)}\n{fill(one.quantity, 30)}\n{one.told}{value}{place}"


# ---- what none answers ----
def _unanswered(panel: Axes, silent: list[Measured]) -> None:
    panel.axis("off")
    lines = ["Measured, and answered by no method:"]
    for why, group in groupby(silent, key=lambda one: one.why_none):
        what = "; ".join(f"{one.quantity} {one.told} ({one.title})" for one in group)
        lines.append(fill(f"- {what}: {why}.", 185, subsequent_indent="   "))
    panel.text(0, 1, "\n".join(lines), transform=panel.transAxes, va="top", fontsize=8)
