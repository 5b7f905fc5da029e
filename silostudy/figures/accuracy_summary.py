"""Cost of 10 %, 1 % and 0.1 %: the cheapest setting that reaches each, problem by problem."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import BLACK, SKY, VERMILION, WIDTH, foot, headline, save
from silostudy.figures.work_precision import table

ASKED = {0.1: ("10 %", SKY, "o"), 0.01: ("1 %", VERMILION, "s"), 0.001: ("0.1 %", BLACK, "D")}
WRAP = 44  # letters of a label


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the table; an error counts where all finer settings of its ladder keep it."""
    cheapest = costs(cube)
    problems = cube.set_coords("problem")
    figure, axis = plt.subplots(figsize=(WIDTH, 0.62 * cheapest.groupby(["problem", "quantity"]).ngroups + 2.2))
    labels = []
    for row, ((problem, quantity), part) in enumerate(cheapest.groupby(["problem", "quantity"], sort=False)):
        axis.plot(part["cost"], np.full(len(part), row), color="0.7", linewidth=1, zorder=1)
        for point in part.itertuples():
            _, colour, marker = ASKED[point.asked]
            axis.scatter(point.cost, row, color=colour, marker=marker, s=130 * point.asked**0.15, zorder=2)
        words = "\n".join(map(_words, part.itertuples()))
        axis.text(1.01, row, words, transform=axis.get_yaxis_transform(), fontsize="small", va="center")
        here = problems.sel(problem=problem)
        title, setting = (here[f"problem_{name}"].item() for name in ("title", "setting"))
        labels.append(f"{problem}: {quantity}".replace("_", " ") + "\n" + fill(f"{title}; by {setting}", WRAP))
    axis.set_yticks(range(len(labels)), labels)
    axis.set_ylim(len(labels) - 0.4, -0.6)
    axis.set(xscale="log", xlabel="CPU time of the cheapest setting (s)")
    handles = [plt.Line2D([], [], color=c, marker=m, linestyle="", label=text) for text, c, m in ASKED.values()]
    headline(figure, _message(cheapest))
    told = (
        "Cheapest setting that reaches a relative error and whose finer ones do too; its ladder and setting stand on the right."
    )
    foot(figure, f"{cube.attrs['title']}: {cube.attrs['machine']}, {cube.attrs['measured_on']}.", told, handles=handles)
    save(figure, cheapest.rename(columns={"cost": "cost_s"}), stem)


def _message(cheapest: pd.DataFrame) -> str:
    """Message: how many times as long the finest error takes as the coarsest, in the median over what comes to both."""
    cost = cheapest.pivot(index=["problem", "quantity"], columns="asked", values="cost")
    (coarse, (coarse_words, *_)), *_, (fine, (fine_words, *_)) = ASKED.items()
    dearer = (cost[fine] / cost[coarse]).dropna()
    told = f"{cost[fine].notna().sum()} of {len(cost)} quantities come to {fine_words}"
    if dearer.empty:
        return told
    return f"{told}, for {dearer.median():.2g} times the CPU time of {coarse_words} in the median, {dearer.max():.2g} at most"


def _words(point) -> str:
    """Setting that reaches an error, or why nothing does."""
    text = ASKED[point.asked][0]
    if point.ladder:
        return f"{text}: {point.ladder}, {point.setting:.6g}"
    return f"{text}: " + (f"chance alone makes {100 * point.floor:.0f} %" if point.floor > point.asked else "not reached")


def costs(cube: xr.Dataset) -> pd.DataFrame:
    """The cheapest point of every problem and quantity that reaches each asked error; without ladder where none does."""
    rows = []
    for (problem, quantity), part in table(cube).groupby(["problem", "quantity"], sort=False):
        for asked in ASKED:
            reached = part[part["error_kept"] <= asked].sort_values("cost")
            row = {"problem": problem, "quantity": quantity, "asked": asked, "floor": part["floor"].min()}
            empty = {"ladder": "", "setting": np.nan, "error": np.nan, "error_kept": np.nan, "cost": np.nan}
            rows.append(row | ({name: reached.iloc[0][name] for name in empty} if len(reached) else empty))
    return pd.DataFrame(rows)
