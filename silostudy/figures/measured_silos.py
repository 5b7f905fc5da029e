"""Measured wall pressures against every method: curves with the measured points, and by how much each method is off."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.measured import deviations, pressures_measured_in
from silostudy.errors import BadInput
from silostudy.figures.style import PHASE_LINES, look, save, silent, title
from silostudy.tables.measured import Measured


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a pair of panels for each measured silo of the study (curves, deviations) and the deviations as numbers."""
    found = {place: _points(cube.isel(silo=place)) for place in range(cube.sizes["silo"])}
    places = [place for place, points in found.items() if points]
    if not places:
        told = "no silo of the study has the size of a measured one, and depths to the measured one (see `silostudy list`)"
        raise BadInput("cube", cube.attrs["title"], told)
    figure, axes = plt.subplots(len(places), 2, figsize=(12.5, 6.2 * len(places)), squeeze=False, width_ratios=(1, 1.15))
    tables = []
    for (curves, bars), place in zip(axes, places, strict=True):
        here = cube.isel(silo=place)
        tables.append(_curves(curves, here, found[place]))
        for point in found[place]:
            tables.append(_deviations(here, point))
            _bars(bars, tables[-1], point)
    figure.suptitle(cube.attrs["title"])
    handles = [*axes[0, 0].get_legend_handles_labels()[0], *silent(cube)]
    figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=8)
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _points(here: xr.Dataset) -> list[Measured]:
    """The measured pressures of a silo at depths that the cube reaches."""
    return [one for one in pressures_measured_in(here) if float(here["depth"].min()) <= one.depth <= float(here["depth"].max())]


def _deviations(here: xr.Dataset, point: Measured) -> pd.DataFrame:
    """Each method's pressure at the measured depth, by how much it is off, and which methods bracket the measurement."""
    found = deviations(here, point, list(map(str, here["pressure_method"].values)))
    table = found.assign(shown="at the measured depth", depth_m=point.depth, source=f"{point.source}, {point.locator}")
    table["title"] = [f"{title(here, row.pressure_method)}, {row.phase}" for row in table.itertuples()]
    table["measured_kPa"], table["computed_kPa"] = table.pop("measured") / 1e3, table.pop("computed") / 1e3
    return table


def _curves(panel, here: xr.Dataset, points: list[Measured]) -> pd.DataFrame:
    """Draws every method's pressure over depth and the measured points; the curves as a table."""
    tables = []
    for method in map(str, here["pressure_method"].values):
        for phase in map(str, here["phase"].values):
            pressure = here["wall_normal_pressure"].sel(pressure_method=method, phase=phase)
            if pressure.notnull().any():
                style = {
                    **look(here, method),
                    "linestyle": PHASE_LINES[phase],
                    "linewidth": 1.2,
                    "markersize": 4.5,
                    "markevery": 12,
                }
                style |= {"markerfacecolor": "none"} if phase == "filling" else {}
                table: dict[str, Any] = {
                    "shown": "curve",
                    "measurement": points[0].measurement,
                    "pressure_method": method,
                    "phase": phase,
                }
                table |= {"title": f"{title(here, method)}, {phase}"}
                table |= {"depth_m": here["depth"].values, "computed_kPa": pressure.values / 1e3}
                tables.append(pd.DataFrame(table).dropna())
                panel.plot(tables[-1].computed_kPa, tables[-1].depth_m, label=table["title"], **style)
    for point in points:
        panel.plot(point.value / 1e3, point.depth, "k*", markersize=15, label=f"measured in {point.phase}")
    panel.set(xlabel="wall normal pressure (kPa)", ylabel="depth z (m)", xlim=(0, None), ylim=(float(here["depth"].max()), 0))
    panel.set_title(points[0].title)
    return pd.concat(tables)


def _bars(panel, table: pd.DataFrame, point: Measured) -> None:
    own = table.phase == point.phase
    colours = np.where(table.bracket != "", "#2166AC", np.where(own, "#92C5DE", "#E0E0E0"))
    panel.barh(np.arange(len(table)), 100 * table.off, color=colours, edgecolor="0.4", linewidth=0.5)
    for place, row in enumerate(table.itertuples()):
        note = f"  {100 * row.off:+.0f} % {row.bracket}"
        panel.text(max(100 * row.off, 0), place, note, va="center", fontsize=7.5)
    panel.set_yticks(np.arange(len(table)), table.title, fontsize=7.5)
    panel.axvline(0, color="black", linewidth=1)
    panel.set(xlabel="computed over measured, less one (%)", xlim=(None, 100 * table.off.max() + 45))
    against = f"against {point.value / 1e3:.1f} kPa at {point.depth:g} m, {point.phase} (blue: same phase)"
    panel.set_title(against)
    panel.text(0.99, 0.04, _brackets(table), transform=panel.transAxes, ha="right", fontsize=8)
    panel.grid(axis="y", visible=False)


def _brackets(table: pd.DataFrame) -> str:
    """Which methods bracket the measurement in its own phase, or that none lies on one side."""
    found = []
    for where in ("below", "above"):
        rows = table[table.bracket == f"next {where}"]
        some = "; ".join(f"{row.title} ({100 * row.off:+.0f} %)" for row in rows.itertuples())
        found.append(f"next {where}: {some or 'no method'}")
    return "\n".join(found)
