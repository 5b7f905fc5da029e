"""Fig. 4.2.11 with the codes in use today: the handbook's curves thin and numbered, EN 1991-4 with its band, AS 3774.

Where the study samples the solid's scatter, each method's larger phase has its middle nine tenths as a light fill and a bar.
"""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from silostudy.cube.measured import pressures_measured_in
from silostudy.figures.style import AID, PHASE_LINES, drawn, look, phases_of_its_own, save, silent, title
from silostudy.figures.uncertainty_bands import distinct_methods
from silostudy.tables.outputs import output_of

(STATIC,) = output_of(__name__).methods
EDGES = (("wall_normal_pressure_kPa", "upper_kPa"), ("ratio_to_janssen", "upper_ratio"))  # of a band, on either panel
LINES = 3  # for the handbook's numbers
SCATTER = "light fill, bar in a method's colour: 5 % to 95 % of the sampled solid, larger phase"
BELOW = "scatter: unit weight from the solid's lower value up to the curves' own, which lie high in their fills for that"
HATCHES = {"filling": "\\\\\\\\", "switch": "....", "discharge": "////"}


def draw(cube: xr.Dataset, stem: Path, sampled: xr.Dataset | None = None) -> None:
    """Writes the figure and the curves, the bands and the measured points it shows; `sampled`: the uncertainty cube."""
    static = cube["wall_normal_pressure"].sel(pressure_method=STATIC, phase="filling")
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.5, 8.4), sharey=True, width_ratios=(1.3, 1))
    tables = []
    for method in map(str, cube["pressure_method"].values):
        if drawn(cube, method) not in ("set", "none"):
            for phase in phases_of_its_own(cube, method, STATIC):
                tables.append(_curve(cube, method, phase, static))
                _draw_curve((left, right), cube, tables[-1], method, phase)
    for phase in map(str, cube["phase"].values):
        band = _band(cube, phase, static)
        if band is not None:
            tables.append(band)
            _draw_band((left, right), band, phase)
    scatter = [] if sampled is None else _scatter((left, right), cube, sampled, static)
    for point in pressures_measured_in(cube):
        left.plot(point.value / 1e3, point.depth, "k*", markersize=13, label=f"measured: {point.title}")
    left.set(xlabel="wall normal pressure (kPa)", ylabel="depth z (m)", xlim=(0, None))
    right.set(xlabel="ratio to static Janssen", xlim=_ratios(tables, float(cube["cylinder_depth"])))
    _number_ends(left, tables)
    left.set_ylim(float(cube["cylinder_depth"]) * 1.08, 0)
    handles = [*left.get_legend_handles_labels()[0], *([Patch(color="0.5", alpha=0.45, label=SCATTER)] if scatter else [])]
    handles += silent(cube)
    figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=8)
    figure.suptitle(cube.attrs["title"] + ("\n" + BELOW if scatter else ""))
    save(figure, pd.concat([*tables, *scatter], ignore_index=True), stem)


def _curve(cube: xr.Dataset, method: str, phase: str, static: xr.DataArray) -> pd.DataFrame:
    pressure = cube["wall_normal_pressure"].sel(pressure_method=method, phase=phase)
    ratio = (pressure / static.where(static > 0)).values
    table = {"curve": f"{title(cube, method)}, {phase}", "depth_m": cube["depth"].values}
    table |= {"wall_normal_pressure_kPa": pressure.values / 1e3, "ratio_to_janssen": ratio}
    table["number"] = str(cube["pressure_method_number"].sel(pressure_method=method).values)
    return pd.DataFrame(table).dropna(subset="wall_normal_pressure_kPa")


def _draw_curve(axes: tuple[Axes, Axes], cube: xr.Dataset, table: pd.DataFrame, method: str, phase: str) -> None:
    style = {**look(cube, method), "linestyle": PHASE_LINES[phase], "linewidth": 2.0, "markersize": 6, "markevery": 18}
    if drawn(cube, method) == "handbook":  # thin, told apart by number and marker
        style |= {"linewidth": 0.9, "markersize": 3.5, "alpha": 0.75}
    if phase == "filling":
        style["markerfacecolor"] = "none"
    for panel, column in zip(axes, ("wall_normal_pressure_kPa", "ratio_to_janssen"), strict=True):
        panel.plot(table[column], table.depth_m, label=table.curve.iloc[0] if panel is axes[0] else None, **style)


def _ratios(tables: list[pd.DataFrame], height: float) -> tuple[float, float]:
    """Limits of the ratio axis: all ratios below a tenth of the height (nearer the surface some grow without bound)."""
    ratios = pd.concat([table[table.depth_m > height / 10].ratio_to_janssen for table in tables])
    return min(0.5, 0.95 * ratios.min()), 1.05 * ratios.max()


def _number_ends(axes: Axes, tables: list[pd.DataFrame]) -> None:
    """The handbook's number at the foot of its curves, on further lines where they stand close."""
    feet = sorted((t.wall_normal_pressure_kPa.iloc[-1], t.depth_m.iloc[-1], t.number.iloc[0]) for t in tables if "number" in t)
    last = [-np.inf] * LINES
    for x, y, number in (foot for foot in feet if foot[2]):
        line = next((n for n in range(LINES) if x - last[n] >= 0.025 * feet[-1][0]), LINES - 1)
        last[line] = x
        place: dict[str, Any] = {
            "xytext": (0, -9 - 9 * line),
            "textcoords": "offset points",
            "ha": "center",
            "va": "center",
            "fontsize": 7.5,
        }
        axes.annotate(number, (x, y), **place)


def _band(cube: xr.Dataset, phase: str, static: xr.DataArray) -> pd.DataFrame | None:
    """Least and largest wall pressure over the sets of characteristic values."""
    sets = [method for method in map(str, cube["pressure_method"].values) if drawn(cube, method) == "set"]
    if not sets:
        return None
    pressure = cube["wall_normal_pressure"].sel(pressure_method=sets, phase=phase)
    table = {"curve": f"EN 1991-4, all sets of characteristic values, {phase}", "depth_m": cube["depth"].values}
    table |= {
        "wall_normal_pressure_kPa": pressure.min("pressure_method").values / 1e3,
        "upper_kPa": pressure.max("pressure_method").values / 1e3,
    }
    table["ratio_to_janssen"] = (pressure.min("pressure_method") / static.where(static > 0)).values
    table["upper_ratio"] = (pressure.max("pressure_method") / static.where(static > 0)).values
    return pd.DataFrame(table).dropna(subset="wall_normal_pressure_kPa")


def _draw_band(axes: tuple[Axes, Axes], band: pd.DataFrame, phase: str) -> None:
    hatched: dict[str, Any] = {
        "facecolor": "none",
        "edgecolor": "#2166AC",
        "alpha": 0.4,
        "linewidth": 0.3,
        "hatch": HATCHES[phase],
    }
    for panel, (low, high) in zip(axes, EDGES, strict=True):
        label = band.curve.iloc[0] if panel is axes[0] else None
        panel.fill_betweenx(band.depth_m, band[low], band[high], facecolor="#2166AC", alpha=0.12, linewidth=0)
        panel.fill_betweenx(band.depth_m, band[low], band[high], label=label, **hatched)


def _scatter(axes: tuple[Axes, Axes], cube: xr.Dataset, sampled: xr.Dataset, static: xr.DataArray) -> list[pd.DataFrame]:
    """Draws each method's middle nine tenths in its colour, in the phase of the larger pressure; the numbers it shows.

    Many bands lie over one another: each fill is faint, and a bar at a depth of the method's own shows its width.
    """
    methods, depth, unit = distinct_methods(sampled), cube["depth"].values, static.where(static > 0).values
    bars = np.linspace(0.45, 0.97, len(methods)) * float(cube["cylinder_depth"])
    tables = []
    for method, bar in zip(methods, bars, strict=True):
        one = sampled["wall_normal_pressure_quantile"].sel(pressure_method=method)
        phase = str(one["phase"][int(one.max(["quantile", one.dims[-1]]).argmax("phase"))].values)
        low, high = (one.sel({"phase": phase}).isel(quantile=place).values for place in (0, -1))
        table = {"curve": f"{title(cube, method)}, {phase}, 5 % to 95 % of the sampled solid", "depth_m": depth}
        table |= {"wall_normal_pressure_kPa": low / 1e3, "upper_kPa": high / 1e3}
        tables.append(pd.DataFrame(table | {"ratio_to_janssen": low / unit, "upper_ratio": high / unit}))
        for panel, (lower, upper) in zip(axes, EDGES, strict=True):
            edges = tables[-1][lower], tables[-1][upper]
            panel.fill_betweenx(depth, *edges, color=look(cube, method)["color"], alpha=0.06, linewidth=0, zorder=0.5)
            ends = [np.interp(bar, depth, edge) for edge in edges]
            colour = look(cube, method)["color"]
            panel.plot(ends, [bar, bar], color=colour, linewidth=5, alpha=0.45, solid_capstyle="butt", gid=AID)
    return [table.dropna(subset="upper_kPa") for table in tables]
