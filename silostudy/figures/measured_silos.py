"""Measured wall pressures against every method: curves with the measured points, and by how much each method is off."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.measured import deviations, pressures_measured_in
from silostudy.cube.silence import silences
from silostudy.errors import BadInput
from silostudy.figures.steps import over_depth
from silostudy.figures.style import BLUE, REST, WIDTH, foot, headline, look, save, title
from silostudy.tables.measured import Measurement

READ = "grey: methods in the other phases; right: those of the measured phase, dark the next to what was measured"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a pair of panels for each measured silo of the study (curves, deviations) and the deviations as numbers."""
    measured = {place: points for place in range(cube.sizes["silo"]) if (points := _points(cube.isel(silo=place)))}
    if not measured:
        told = "no silo of the study has the size of a measured one, and depths to the measured one (see `silostudy list`)"
        raise BadInput("cube", cube.attrs["title"], told)
    size = (WIDTH, 3.3 * len(measured) + 1.6)
    figure, axes = plt.subplots(len(measured), 2, figsize=size, squeeze=False, width_ratios=(1.1, 1))
    curves, compared = [], []
    for (walls, bars), (place, points) in zip(axes, measured.items(), strict=True):
        here = cube.isel(silo=place)
        curves.append(_curves(walls, here, points))
        for point in points:
            compared.append(_deviations(here, point))
            _bars(bars, compared[-1][compared[-1].phase == point.phase], point)
    headline(figure, _message(pd.concat(compared)))
    unspoken = silences(cube, in_every_case=True, titles=True)
    foot(figure, f"{cube.attrs['title']}; {READ}", *unspoken, handles=axes[0, 0].get_legend_handles_labels()[0])
    save(figure, pd.concat([*curves, *compared], ignore_index=True), stem)


def _message(compared: pd.DataFrame) -> str:
    """Message of the figure, in numbers: how far the methods of a measurement's phase are off, and how many lie below it."""
    same = compared[compared.phase == compared.measured_phase]
    return (
        f"Wall pressures computed for the phase of the measurement are {100 * same.off.min():+.0f} to"
        f" {100 * same.off.max():+.0f} % off; {(same.off < 0).sum()} of {len(same)} lie below what was measured"
    )


def _points(here: xr.Dataset) -> list[Measurement]:
    """The measured pressures of a silo at depths that the cube reaches."""
    least, most = float(here["depth"].min()), float(here["depth"].max())
    return [point for point in pressures_measured_in(here) if least <= point.depth <= most]


def _deviations(here: xr.Dataset, point: Measurement) -> pd.DataFrame:
    """Each method's pressure at the measured depth, by how much it is off, and which methods bracket the measurement."""
    table = deviations(here, point, list(map(str, here["pressure_method"].values)))
    table = table.assign(shown="at the measured depth", depth_m=point.depth, source=f"{point.source}, {point.locator}")
    table["title"] = [title(here, row.pressure_method) for row in table.itertuples()]
    table["measured_kPa"], table["computed_kPa"] = table.pop("measured") / 1e3, table.pop("computed") / 1e3
    return table.assign(measured_phase=point.phase)


def _curves(panel: Axes, here: xr.Dataset, points: list[Measurement]) -> pd.DataFrame:
    """Draws every method's pressure over depth, of other phases than the measured in grey; the curves as a table."""
    tables = []
    for method in map(str, here["pressure_method"].values):
        for phase in map(str, here["phase"].values):
            pressure = here["wall_normal_pressure"].sel(pressure_method=method, phase=phase)
            if pressure.notnull().any():
                own = phase in {point.phase for point in points}
                style = {**look(here, method), "linewidth": 1.6, "markevery": 12, "label": title(here, method)} if own else REST
                table: dict[str, Any] = {"shown": "curve", "measurement": points[0].measurement, "title": title(here, method)}
                table |= {"pressure_method": method, "phase": phase, "depth_m": here["depth"].values}
                tables.append(pd.DataFrame(table | {"computed_kPa": pressure.values / 1e3}).dropna())
                over_depth(panel, tables[-1].computed_kPa.to_numpy(), tables[-1].depth_m.to_numpy(), **style)
    for point in points:
        panel.plot(point.value / 1e3, point.depth, "k*", markersize=16, label=f"measured after {point.phase}", zorder=4)
    panel.set(xlabel="wall normal pressure (kPa)", ylabel="depth z (m)", xlim=(0, None), ylim=(float(here["depth"].max()), 0))
    panel.set_title(points[0].title)
    return pd.concat(tables)


def _bars(panel: Axes, table: pd.DataFrame, point: Measurement) -> None:
    """A bar a method: by how much it is off; dark those next to the measurement."""
    colours = np.where(table.bracket != "", BLUE, REST["color"])
    panel.barh(np.arange(len(table)), 100 * table.off, color=colours, edgecolor="0.4", linewidth=0.5)
    for place, row in enumerate(table.itertuples()):
        panel.text(max(100 * row.off, 0), place, f"  {100 * row.off:+.0f} % {row.bracket}", va="center", fontsize="small")
    panel.set_yticks(np.arange(len(table)), table.title)
    panel.axvline(0, color="black", linewidth=1)
    span = np.ptp([0.0, *100 * table.off])
    panel.set(xlabel="computed over measured, less one (%)", xlim=(None, 100 * table.off.max() + 0.6 * span))
    panel.set_title(f"against {point.value / 1e3:.1f} kPa at {point.depth:g} m")
    panel.grid(axis="y", visible=False)
