"""Parts that the figures of accuracy share: a panel a quantity of a problem, error over CPU time, Pareto front, floor."""

import textwrap
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from silostudy.figures.style import BLACK, WIDTH, foot, headline, save, series

LEAST = 1e-16  # where an error of zero is drawn
NAME = 0.07  # share of a panel's height that a name in its legend takes
BELOW = 30.0  # how far below the statistical floor is shown: what lies there is chance
ACROSS = 2
WRAP = 66  # letters across a panel
ASKED = 1e-3  # relative error that the headline asks for
SPAN = 20.0  # of the time axis at the least: a narrower one is all noise
FEW = 300.0  # of a time axis on which there is room for labels between the decades


def table(cube: xr.Dataset) -> pd.DataFrame:
    """The points of a cube, one row each."""
    names = [str(name) for name in cube.variables if str(name).startswith("point_")]
    return pd.DataFrame({name.removeprefix("point_"): cube[name].to_numpy() for name in names})


def draw_group(cube: xr.Dataset, group: str, stem: Path) -> None:
    """Every problem of a group, quantity by quantity; writes the figure and its points."""
    points = table(cube)
    problems = cube.isel(problem=np.flatnonzero(cube["problem_group"].to_numpy() == group))
    points = points[points["problem"].isin(problems["problem"].to_numpy())]
    panels = list(points.groupby(["problem", "quantity"], sort=False))
    across = min(ACROSS, max(1, len(panels)))
    down = -(-len(panels) // across) or 1
    figure, axes = plt.subplots(down, across, figsize=(WIDTH, 1.2 + 4.2 * down), squeeze=False)
    for axis, ((key, _), part) in zip(axes.flat, panels, strict=False):
        panel(axis, part, problems.sel(problem=key))
    for axis in axes.flat[len(panels) :]:
        axis.set_visible(False)
    headline(figure, _message(points))
    about = (
        f"CPU time: median of {cube.attrs['repeats']} readings on {cube.attrs['machine']}, {cube.attrs['measured_on']}. Grey "
    )
    about += (
        "band: Pareto front of errors that finer settings keep (where chance is part of them: of the ends of their intervals)."
    )
    foot(figure, f"{cube.attrs['title']}.", about)
    save(figure, written(points), stem)


def _message(points: pd.DataFrame) -> str:
    """Message: how many quantities come to the error asked for, and what the cheapest settings that do so cost at most."""
    quantities = points.groupby(["problem", "quantity"]).ngroups
    reached = points[points["error_kept"] <= ASKED].groupby(["problem", "quantity"])["cost"].min()
    if reached.empty:
        return f"None of {quantities} quantities comes to {100 * ASKED:g} %"
    cost = f"for {reached.max():.2g} s of CPU time at most"
    return f"{len(reached)} of {quantities} quantities come to an error of {100 * ASKED:g} %, {cost}"


def written(points: pd.DataFrame) -> pd.DataFrame:
    """The points as they are saved: costs with their unit, and what is drawn of errors too small for a scale of powers."""
    error = np.maximum(points["error"], LEAST)
    ends = {"error_drawn": error, "error_low_drawn": np.maximum(points["error_low"], error / 30)}
    ends["error_kept_drawn"] = np.maximum(points["error_kept"], LEAST)
    return points.assign(**ends).rename(columns={name: f"{name}_s" for name in points if name.startswith("cost")})


def panel(axis, part: pd.DataFrame, problem: xr.Dataset) -> None:
    """One quantity of one problem."""
    for number, (ladder, rungs) in enumerate(part.groupby("ladder", sort=False)):
        shown = rungs[np.isfinite(rungs["error"]) & (rungs["error"] < 2.0)]
        steep = slope(shown)
        label = f"{ladder}  (slope {round(steep, 1) + 0.0:.1f})" if np.isfinite(steep) else ladder
        error = np.maximum(shown["error"], LEAST)
        look = series(number) | {"markersize": 5, "linewidth": 1.2}
        bars = np.array([error - np.maximum(shown["error_low"], error / 30), shown["error_high"] - error])
        axis.errorbar(shown["cost"], error, yerr=bars if bars.any() else None, label=label, capsize=2, elinewidth=0.6, **look)
    front, chance = part[part["on_front"] > 0].sort_values("cost"), bool((part["floor"] > 0).any())
    axis.plot(
        front["cost"], np.maximum(front["error_kept"], LEAST), color="0.87", linewidth=7, solid_capstyle="round", zorder=1
    )
    if chance:
        floor = part["floor"].min()
        axis.set_ylim(bottom=floor / BELOW)
        axis.axhspan(floor / BELOW, floor, color="grey", alpha=0.15, linewidth=0)
        axis.axhline(floor, color="grey", linewidth=1, linestyle="--", label="statistical floor")
    for share in (0.1, 0.01, 0.001):
        axis.axhline(share, color=BLACK, linewidth=0.5, linestyle=":")
    about = f"over {problem['problem_setting'].item()}; reference, {problem['problem_reference'].item()}"
    axis.set(xscale="log", yscale="log", ylabel="relative error")
    axis.set_xlabel(f"CPU time (s)\n{textwrap.fill(about, WRAP)}", fontsize="small")
    _spread(axis)
    titles = (problem["problem_title"].item(), part["quantity_title"].iloc[0])
    axis.set_title("\n".join(textwrap.fill(title, WRAP) for title in titles))
    names = len(axis.get_legend_handles_labels()[1])
    low, high = axis.get_ylim()
    axis.set_ylim(low, high * (high / low) ** (NAME * names))  # the legend stands above all points
    axis.legend(loc="upper right", borderpad=0.1)


def _spread(axis) -> None:
    """A time axis of SPAN at the least, with labels at every decade, and between them where there are few."""
    low, high = axis.get_xlim()
    if high < SPAN * low:
        middle = np.sqrt(low * high)
        low, high = middle / np.sqrt(SPAN), middle * np.sqrt(SPAN)
        axis.set_xlim(low, high)
    if high < FEW * low:
        axis.xaxis.set_minor_locator(LogLocator(subs=(3.0,)))
        axis.xaxis.set_minor_formatter(FuncFormatter(lambda value, _: rf"$3\times10^{{{np.floor(np.log10(value)):.0f}}}$"))
    else:
        axis.xaxis.set_minor_formatter(NullFormatter())  # its labels would overlap


def slope(rungs: pd.DataFrame) -> float:
    """Slope of log error over log cost by least squares, between the floor or rounding and one; NaN for fewer than three."""
    error, cost = rungs["error"].to_numpy(), rungs["cost"].to_numpy()
    usable = (error > np.maximum(rungs["floor"].to_numpy(), 1e-13)) & (error < 1.0)
    if usable.sum() < 3 or np.ptp(np.log(cost[usable])) < 0.7:
        return np.nan
    return float(np.polyfit(np.log(cost[usable]), np.log(error[usable]), 1)[0])
