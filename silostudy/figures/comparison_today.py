"""One silo's wall by the handbook's methods and by today's codes: after filling, in discharge, largest pressures ranked.

Each panel brings out one group over the others in grey.  The ranking is the legend, and where the study samples the solid's
scatter it shows the middle nine tenths of each largest pressure.
"""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.measured import pressures_measured_in
from silostudy.cube.silence import silences
from silostudy.figures.steps import over_depth
from silostudy.figures.style import REST, WIDTH, drawn, foot, headline, look, phases_of_its_own, save, title
from silostudy.tables.outputs import output_of

(STATIC,) = output_of(__name__).methods
PRESSURE = "wall_normal_pressure"
SCATTER = "bars: 5 % to 95 % of the sampled solid, whose unit weight goes up to the dots' own: these lie high for that"
BAND = "shaded: EN 1991-4, all sets of characteristic values"
NUMBERS = "numbers before names: curves of the handbook's Fig. 4.2.11 (about 1980)"
GREY = "grey: the curves of the other panels; dashed, with open marks: after filling"
HATCHES = {"filling": "\\\\\\\\", "switch": "....", "discharge": "////"}
# heading -> phases, and how the methods that it brings out are drawn
GROUPS = {
    "after filling": (("filling",), ("handbook", "curve", "misprint")),
    "in discharge:\nthe handbook's": (("switch", "discharge"), ("handbook", "misprint")),
    "in discharge:\ntoday's": (("switch", "discharge"), ("curve",)),
}


def draw(cube: xr.Dataset, stem: Path, sampled: xr.Dataset | None = None) -> None:
    """Writes the figure with the curves, bands, measured points and ranks that it shows; `sampled`: the uncertainty cube."""
    curves, bands = _curves(cube), _bands(cube)
    ranks = _ranks(curves, sampled)
    groups = {name: group for name, group in GROUPS.items() if _of(curves, *group).any()}
    figure, panels = plt.subplots(1, len(groups) + 1, figsize=(WIDTH, 6.8), squeeze=False)
    *walls, ranking = panels[0]
    for panel in walls[1:]:
        panel.sharey(walls[0])
        panel.tick_params(labelleft=False)
    for panel, (name, group) in zip(walls, groups.items(), strict=True):
        _draw_wall(panel, cube, curves, bands, group)
        panel.set(xlim=(0, 1.04 * curves.wall_normal_pressure_kPa.max()), ylim=(float(cube["cylinder_depth"]), 0))
        panel.set_title(name)
        panel.set_xlabel("wall normal\npressure (kPa)")
    walls[0].set_ylabel("depth z (m)")
    _draw_ranks(ranking, cube, ranks)
    below = [BAND] * bool(bands) + [SCATTER] * (sampled is not None)
    reading = [GREY] * (len(groups) > 1) + [NUMBERS] * bool(curves.drawn.isin(("handbook", "misprint")).any())
    headline(figure, f"{cube.attrs['title']}: {_message(ranks)}")
    foot(figure, "; ".join(reading), "; ".join(below), *silences(cube, in_every_case=True, titles=True))
    save(figure, pd.concat([curves, *bands, ranks], ignore_index=True).drop(columns=["pressure_method", "drawn"]), stem)


def _curves(cube: xr.Dataset) -> pd.DataFrame:
    """Every curve drawn, with its method, phase and way to be drawn."""
    tables = []
    for method in map(str, cube["pressure_method"].values):
        if drawn(cube, method) not in ("set", "none"):
            for phase in phases_of_its_own(cube, method, STATIC):
                pressure = cube[PRESSURE].sel(pressure_method=method, phase=phase).values / 1e3
                table: dict[str, Any] = {"curve": f"{title(cube, method)}, {phase}", "pressure_method": method, "phase": phase}
                table |= {"drawn": drawn(cube, method), "depth_m": cube["depth"].values, "wall_normal_pressure_kPa": pressure}
                tables.append(pd.DataFrame(table))
    return pd.concat(tables, ignore_index=True).dropna(subset="wall_normal_pressure_kPa")


def _bands(cube: xr.Dataset) -> list[pd.DataFrame]:
    """Least and largest wall pressure over the sets of characteristic values, a table a phase; none without such sets."""
    sets = [method for method in map(str, cube["pressure_method"].values) if drawn(cube, method) == "set"]
    tables = []
    for phase in map(str, cube["phase"].values) if sets else ():
        pressure = cube[PRESSURE].sel(pressure_method=sets, phase=phase) / 1e3
        table: dict[str, Any] = {"curve": f"EN 1991-4, all sets of characteristic values, {phase}", "phase": phase}
        table |= {"depth_m": cube["depth"].values, "wall_normal_pressure_kPa": pressure.min("pressure_method").values}
        table["upper_kPa"] = pressure.max("pressure_method").values
        tables.append(pd.DataFrame(table).dropna(subset="upper_kPa"))
    return tables


def _ranks(curves: pd.DataFrame, sampled: xr.Dataset | None) -> pd.DataFrame:
    """Each curve's largest pressure, least first, with the middle nine tenths of it where the solid is sampled."""
    ranks = curves.groupby(["curve", "pressure_method", "phase"], sort=False, as_index=False).wall_normal_pressure_kPa.max()
    ranks = ranks.rename(columns={"wall_normal_pressure_kPa": "largest_kPa"}).sort_values("largest_kPa", ignore_index=True)
    ranks["rank"] = np.arange(len(ranks))
    if sampled is not None:
        spans = [_span(sampled, row.pressure_method, row.phase) for row in ranks.itertuples()]
        ranks["p05_kPa"], ranks["p95_kPa"] = np.array(spans).T
    return ranks


def _span(sampled: xr.Dataset, method: str, phase: str) -> tuple[float, float]:
    """Lower and upper quantile (kPa) of the largest pressure over depth; not a number where it was not sampled."""
    if method not in sampled["pressure_method"].values or phase not in sampled["phase"].values:
        return np.nan, np.nan
    quantiles = sampled["wall_normal_pressure_quantile"].sel(pressure_method=method, phase=phase) / 1e3
    return float(quantiles.isel(quantile=0).max()), float(quantiles.isel(quantile=-1).max())


def _of(table: pd.DataFrame, phases: tuple[str, ...], ways: tuple[str, ...]) -> pd.Series:
    return table.phase.isin(phases) & table.drawn.isin(ways)


def _draw_wall(panel: Axes, cube: xr.Dataset, curves: pd.DataFrame, bands: list[pd.DataFrame], group: tuple) -> None:
    """A group of curves in their own looks over all others in grey; the band where the group is not the handbook's alone."""
    for band in bands:
        if band.phase.iloc[0] in group[0] and "curve" in group[1]:
            hatched: dict[str, Any] = {"facecolor": "#2166AC22", "edgecolor": "#2166AC66", "linewidth": 0.3}
            hatch = HATCHES[band.phase.iloc[0]]
            panel.fill_betweenx(band.depth_m, band.wall_normal_pressure_kPa, band.upper_kPa, hatch=hatch, **hatched)
    chosen = _of(curves, *group)
    for rest, table in ((True, curves[~chosen]), (False, curves[chosen])):
        for (method, phase), curve in table.groupby(["pressure_method", "phase"], sort=False):
            style = REST if rest else _look(cube, method, phase) | {"linewidth": 1.8, "markevery": max(1, len(curve) // 7)}
            over_depth(panel, curve.wall_normal_pressure_kPa.to_numpy(), curve.depth_m.to_numpy(), **style)
    for point in pressures_measured_in(cube):
        panel.plot(point.value / 1e3, point.depth, "k*", markersize=13, label=f"measured: {point.title}")
        panel.legend(loc="upper right")


def _look(cube: xr.Dataset, method: str, phase: str) -> dict[str, Any]:
    """Colour and marker of a method, hollow and dashed after filling."""
    filled = {"markerfacecolor": "white", "linestyle": (0, (4, 2))} if phase == "filling" else {"linestyle": "-"}
    return {**look(cube, method), "markersize": 6, **filled}


def _draw_ranks(panel: Axes, cube: xr.Dataset, ranks: pd.DataFrame) -> None:
    """A row a curve: its mark at the largest pressure, and a bar of the sampled scatter."""
    for row in ranks.to_dict("records"):
        if np.isfinite(row.get("p05_kPa", np.nan)):
            panel.hlines(row["rank"], row["p05_kPa"], row["p95_kPa"], color="0.55", linewidth=3.0, zorder=1)
        look_here = _look(cube, row["pressure_method"], row["phase"]) | {"markersize": 8}
        panel.plot(row["largest_kPa"], row["rank"], **look_here)
    panel.set_yticks(ranks["rank"], ranks.curve)
    panel.yaxis.tick_right()
    panel.set(
        xlabel="largest wall\npressure (kPa)",
        xlim=(0, 1.05 * np.nanmax(ranks.filter(like="_kPa"))),
        ylim=(-0.7, len(ranks) - 0.3),
    )
    panel.set_title("largest pressures,\nranked")
    panel.spines["left"].set_visible(False)


def _message(ranks: pd.DataFrame) -> str:
    """Sentence on what the figure says, in numbers."""
    words = {"filling": "after filling", "switch": "at the switch to flow", "discharge": "in discharge"}
    spans = ranks.groupby("phase").largest_kPa.agg(["min", "max"])
    told = [
        f"{spans['min'][phase]:.0f} to {spans['max'][phase]:.0f} kPa {words[phase]}" for phase in words if phase in spans.index
    ]
    return f"the largest pressure is {', '.join(told)}"
