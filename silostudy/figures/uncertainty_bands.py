"""The scatter of the stored solid, method by method: median and the middle nine tenths of the wall pressure over depth."""

from pathlib import Path
from textwrap import fill
from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.silence import NOT_COVERED, reason
from silostudy.figures.steps import over_depth
from silostudy.figures.style import BLUE, PHASE_LINES, PURPLE, VERMILION, WIDTH, foot, headline, name, save, title

SAMPLED = (
    "scatter of friction angle, wall friction, lateral pressure ratio and unit weight; methods that coincide are shown once"
)
QUANTILE = "wall_normal_pressure_quantile"
EXPECTED = {NOT_COVERED.replace("_", " "), "above wall contact"}
LOOKS = {
    "filling": (BLUE, "\\\\\\\\", PHASE_LINES["filling"]),
    "switch": (PURPLE, "....", PHASE_LINES["switch"]),
    "discharge": (VERMILION, "////", PHASE_LINES["discharge"]),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a panel for each method and the quantiles it shows."""
    quantiles = cube[QUANTILE] / 1e3
    methods = distinct_methods(cube)
    columns = _columns(len(methods))
    rows = -(-len(methods) // columns)
    size = (WIDTH, 2.1 * rows + 1.6)
    figure, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, sharex=True, sharey=True)
    tables = []
    for panel, method in zip(axes.flat, methods, strict=False):
        for phase in map(str, cube["phase"].values):
            low, middle, high = (quantiles.sel(pressure_method=method, phase=phase).isel(quantile=i) for i in range(3))
            if middle.notnull().any():
                _band(panel, cube["depth"], (low, middle, high), phase)
                table = {"pressure_method": method, "phase": phase, "depth_m": cube["depth"].values}
                table |= {"p05_kPa": low.values, "p50_kPa": middle.values, "p95_kPa": high.values}
                tables.append(pd.DataFrame(table))
        panel.set_title(fill(title(cube, method), 108 // columns, break_on_hyphens=False))
    for panel in list(axes.flat)[len(methods) :]:
        panel.set_visible(False)
    axes[0, 0].set(ylim=(float(cube["depth"].max()), 0), xlim=(0, None))
    for place, panel in enumerate(list(axes.flat)[: len(methods)]):
        panel.set_ylabel("depth z (m)" if place % columns == 0 else "")
        if place + columns >= len(methods):
            panel.set_xlabel("wall normal pressure (kPa)")
            panel.tick_params(labelbottom=True)
    table = pd.concat(tables, ignore_index=True).dropna()
    handles = {label: handle for panel in axes.flat for handle, label in zip(*panel.get_legend_handles_labels(), strict=True)}
    headline(figure, _message(cube, table))
    foot(figure, f"{cube.attrs['title']}; {SAMPLED}", *missing(cube), handles=handles.values())
    save(figure, table, stem)


def _message(cube: xr.Dataset, table: pd.DataFrame) -> str:
    """Message of the figure, in numbers: scatter of the largest median pressure, least and most of methods and phases."""
    peaks = table.loc[table.groupby(["pressure_method", "phase"]).p50_kPa.idxmax()]
    spread = (50.0 * (peaks.p95_kPa - peaks.p05_kPa) / peaks.p50_kPa).to_numpy()
    ends = peaks.iloc[[spread.argmin(), spread.argmax()]]
    narrow, wide = (f"{name(cube, row.pressure_method)}, {row.phase}" for row in ends.itertuples())
    return (
        f"The solid's scatter moves the largest wall pressure by ±{spread.min():.0f} % ({narrow})"
        f" to ±{spread.max():.0f} % ({wide})"
    )


def _columns(count: int) -> int:
    """Columns for so many panels: those that leave the fewest places of the last row empty, four sooner than another number."""
    return count if count <= 4 else min((4, 5, 3), key=lambda columns: -count % columns)


def missing(cube: xr.Dataset) -> list[str]:
    """Lines that name the methods with masked quantiles, by reason.

    A phase that a method's source does not treat, and a wall above the heap, are told only where nothing else is.
    """
    names: dict[str, list[str]] = {}
    for method in map(str, cube["pressure_method"].values):
        masked = cube[QUANTILE].sel(pressure_method=method).isnull()
        phases = [phase for phase in map(str, cube["phase"].values) if masked.sel(phase=phase).any()]
        reasons = {reason(cube, QUANTILE, method, phase) for phase in phases}
        for told in sorted(reasons - EXPECTED or (reasons if masked.all() else ())):
            text = f"{'not shown' if masked.all() else 'shown in part'}, a sample masked ({told})"
            names.setdefault(text, []).append(title(cube, method))
    return [f"{text}: {', '.join(methods)}" for text, methods in names.items()]


def distinct_methods(cube: xr.Dataset) -> list[str]:
    """Methods with quantiles, each curve once: sampled, the rows of one code's sets of characteristic values coincide."""
    first: dict[bytes, str] = {}
    for method in map(str, cube["pressure_method"].values):
        quantiles = cube[QUANTILE].sel(pressure_method=method)
        if quantiles.notnull().any():
            first.setdefault(quantiles.fillna(-1).values.tobytes(), method)
    return list(first.values())


def _band(panel: Axes, depth, quantiles: tuple, phase: str) -> None:
    low, middle, high = quantiles
    colour, hatch, line = LOOKS[phase]
    panel.fill_betweenx(depth, low, high, facecolor=colour, alpha=0.25, linewidth=0)
    hatched: dict[str, Any] = {"facecolor": "none", "edgecolor": colour, "hatch": hatch, "alpha": 0.5, "linewidth": 0}
    panel.fill_betweenx(depth, low, high, label=f"{phase}: 5 % to 95 %", **hatched)
    look: dict[str, Any] = {"color": colour, "linestyle": line, "linewidth": 1.6}
    over_depth(panel, middle.values, depth.values, label=f"{phase}: median", **look)
