"""Pressure around the hopper over height and time from the opening on: how the relief runs up, and when the switch is where."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from scipy.stats import theilslopes

from silostudy.figures.beside import columns_of, interval, settings, span, told
from silostudy.figures.style import BLACK, WIDTH, foot, headline, plt, save

FILLING = "filling"
RELIEVED = 0.95  # of its pressure at rest: a level that feels less is reached by the relief,
EARLY = 0.02  # s after the opening at most
RISEN = 1.1  # of the same: a level that feels more at its most is one of those where the switch shows
FIRST = 0.06  # s after the opening: what is largest later is a pulse of the flow
LEAST = 3  # levels that a speed needs
MILLI = 1e3  # of a unit
MOST = 2.0  # times rest: where the colours end
# what the rows of the travel tell
SPEED = "speed of the relief up the hopper (m/s)"
TOP = "time at which the top level feels most (ms)"
LATER = "by how much the top of the risen levels feels most later than the lowest (ms)"
MARKS: dict[str, dict[str, Any]] = {  # what -> look: hollow marks on the dark, filled ones on the light
    "relief": {"marker": "o", "markerfacecolor": "white", "label": "first below 0.95 of rest"},
    "largest": {"marker": "D", "markerfacecolor": BLACK, "label": "largest of 60 ms, where it and all above rise by a tenth"},
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a map a setting of height above the outlet and time."""
    axes = [axis for axis in cube.attrs["sweep_axes"].split() if axis != FILLING]
    every = list(settings(cube.assign_attrs(sweep_axes=" ".join(axes))))
    columns = columns_of(len(every))
    rows = -(-len(every) // columns)
    figure, panels = plt.subplots(rows, columns, figsize=(WIDTH, 2.4 + 3.0 * rows), squeeze=False, sharex=True, sharey=True)
    tables = []
    for panel, (setting, case) in zip(panels.flat, every, strict=False):
        cells, marks = over_time(case), times(case)
        mesh = _map(panel, cells)
        _points(panel, marks)
        panel.set(title=told(setting, case), xlim=(0.0, cells["time_ms"].max()))
        tables.append(pd.concat([cells, marks, travel(case)], ignore_index=True).assign(**setting))
    for panel in panels.flat[len(every) :]:
        panel.set_visible(False)
    for panel in panels[-1]:
        panel.set_xlabel("time (ms)")
    for panel in panels[:, 0]:
        panel.set_ylabel("height above\nthe outlet (mm)")
    figure.colorbar(mesh, ax=panels, label="mean pressure around the hopper over that at rest", extend="max")
    shown = pd.concat(tables, ignore_index=True)
    headline(figure, _message(shown))
    about = (
        "Times from the opening. Colours: of the means of the fillings, white as at rest. Marks: mean of the fillings' times "
    )
    about += "and its interval, 95 %."
    foot(figure, f"{cube.attrs['title']}.", about, handles=panels[0, 0].get_legend_handles_labels()[0])
    save(figure, shown, stem)


def _map(panel: Axes, cells: pd.DataFrame) -> QuadMesh:
    """Draws the pressure over that at rest."""
    grid = cells.pivot(index="height_mm", columns="time_ms", values="pressure_over_rest")
    panel.grid(False)
    return panel.pcolormesh(
        grid.columns, grid.index, grid.to_numpy(), cmap="RdBu_r", vmin=2.0 - MOST, vmax=MOST, shading="nearest"
    )


def _points(panel: Axes, marks: pd.DataFrame) -> None:
    for what, look in MARKS.items():
        table = marks[marks["what"] == what]
        spread = np.abs(table[["low_95_ms", "high_95_ms"]].to_numpy().T - table["time_ms"].to_numpy())
        panel.errorbar(table["time_ms"], table["height_mm"], xerr=spread, color=BLACK, linestyle="none", markersize=5,
                       linewidth=1.0, **look)  # fmt: skip


def _message(shown: pd.DataFrame) -> str:
    """Message: how fast the relief runs up the hopper, and when its top feels most."""
    speed, top = (shown.loc[shown["what"] == what, "value"].dropna() for what in (SPEED, TOP))
    runs = "Opening relieves the hopper from below"
    runs = f"{runs} at {span(speed.min(), speed.max())} m/s" if len(speed) else "No relief is told"
    most = f"its top feels most {span(top.min(), top.max())} ms after it" if len(top) else "nowhere it feels more than at rest"
    return f"{runs}; {most}"


def over_time(case: xr.Dataset) -> pd.DataFrame:
    """A row a level and window: height (mm), middle of the window (ms), pressure over that at rest, each the fillings' mean."""
    flow, rest = _rings(case)
    usual = rest.mean(FILLING)
    ratio = (flow.mean(FILLING) / usual.where(usual > 0.0)).transpose("flow_window", "wall_level")
    time, height = _middle(case).mean(FILLING).values * MILLI, _height(case).values * MILLI
    known = np.isfinite(time)
    table = {"time_ms": np.repeat(time[known], len(height)), "height_mm": np.tile(height, int(known.sum()))}
    return pd.DataFrame({"what": "map", **table, "pressure_over_rest": ratio.values[known].ravel()})


def times(case: xr.Dataset) -> pd.DataFrame:
    """A row a level: when it is relieved and when it feels most (ms), mean of the fillings with its interval."""
    rows = []
    for what, time in (("relief", relieved(case)), ("largest", largest(case))):
        for level, height in enumerate(_height(case).values):
            mean, low, high = interval(time.isel(wall_level=level).values * MILLI)
            rows.append({"what": what, "height_mm": height * MILLI, "time_ms": mean, "low_95_ms": low, "high_95_ms": high})
    return pd.DataFrame(rows).dropna(subset=["low_95_ms"])  # levels of at least two fillings


def relieved(case: xr.Dataset) -> xr.DataArray:
    """Time (s) at which each level of a filling first feels less than most of its pressure at rest; missing where not soon."""
    flow, rest = _rings(case)
    below = (flow < RELIEVED * rest) & (_middle(case) < EARLY)
    return _middle(case).isel(flow_window=below.argmax("flow_window")).where(below.any("flow_window"))


def largest(case: xr.Dataset) -> xr.DataArray:
    """Time (s) at which each level of a filling first feels most; missing below those that all rise by a tenth."""
    flow, rest = _rings(case)
    flow = flow.where(_middle(case) < FIRST)
    from_above = (flow.max("flow_window") > RISEN * rest).isel(wall_level=slice(None, None, -1))
    risen = (from_above.cumprod("wall_level") > 0).isel(wall_level=slice(None, None, -1))
    return _middle(case).isel(flow_window=flow.fillna(-1.0).argmax("flow_window")).where(risen)


def travel(case: xr.Dataset) -> pd.DataFrame:
    """Rows of the speed of the relief, and of the time of the largest pressure: means of the fillings with their intervals."""
    height, most = _height(case), largest(case)
    slow = interval(np.array([_slowness(time, height) for time in relieved(case).transpose(FILLING, "wall_level")]))
    speed = [1.0 / slow[0] if slow[0] > 0.0 else np.nan, *(1.0 / end if slow[1] > 0.0 else np.nan for end in slow[:0:-1])]
    reach = [_slowness(time, height) * _reach(time, height) * MILLI for time in most.transpose(FILLING, "wall_level")]
    told_of = {SPEED: speed, TOP: interval(most.isel(wall_level=-1).values * MILLI), LATER: interval(np.array(reach))}
    return pd.DataFrame(
        [{"what": what, "value": mean, "low_95": low, "high_95": high} for what, (mean, low, high) in told_of.items()]
    )


def _slowness(time: xr.DataArray, height: xr.DataArray) -> float:
    """Time a way up (s/m), by the median of the slopes between two levels; NaN of too few levels."""
    there = np.isfinite(time.values)
    return float(theilslopes(time.values[there], height.values[there])[0]) if there.sum() >= LEAST else np.nan


def _reach(time: xr.DataArray, height: xr.DataArray) -> float:
    """Way (m) between the lowest and the highest level that has a time."""
    return float(np.ptp(height.values[np.isfinite(time.values)])) if time.notnull().any() else np.nan


def _rings(case: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Mean pressure (Pa) around each level of the hopper, window by window in flow and at rest."""
    return case["hopper_pressure_in_flow"].mean("wall_turn"), case["hopper_pressure_at_rest"].mean("wall_turn")


def _middle(case: xr.Dataset) -> xr.DataArray:
    """Middle (s after the opening) of each window."""
    end = case["flow_window_end"]
    return end - end.diff("flow_window").median() / 2


def _height(case: xr.Dataset) -> xr.DataArray:
    """Height (m) of each level above the outlet."""
    return case["hopper_level_height"].mean(FILLING)
