"""What 10 %, 1 % and 0.1 % cost: the cheapest setting that reaches each, problem by problem."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import save
from silostudy.figures.work_precision import table

ASKED = {0.1: ("10 %", "#56b4e9", "o"), 0.01: ("1 %", "#d55e00", "s"), 0.001: ("0.1 %", "#332288", "D")}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the table; an error counts where all finer settings of its ladder keep it."""
    found = costs(cube)
    problems = cube.set_coords("problem")
    figure, axis = plt.subplots(figsize=(15, 0.5 * found.groupby(["problem", "quantity"]).ngroups + 1.6))
    labels = []
    for row, ((problem, quantity), part) in enumerate(found.groupby(["problem", "quantity"], sort=False)):
        axis.plot(part["cost"], np.full(len(part), row), color="grey", linewidth=1, zorder=1)
        for one in part.itertuples():
            _, colour, marker = ASKED[one.asked]
            axis.scatter(one.cost, row, color=colour, marker=marker, s=130 * one.asked**0.15, zorder=2)
        words = "\n".join(map(_words, part.itertuples()))
        axis.text(1.01, row, words, transform=axis.get_yaxis_transform(), fontsize=6.3, va="center")
        about = problems.sel(problem=problem)
        title, setting = (about[f"problem_{name}"].item() for name in ("title", "setting"))
        labels.append(f"{problem}: {quantity}".replace("_", " ") + f"\n{title}; by {setting}")
    axis.set_yticks(range(len(labels)), labels, fontsize=6.5)
    axis.set_ylim(len(labels) - 0.4, -0.6)
    axis.set(xscale="log", xlabel="CPU time of the cheapest setting that reaches it and whose finer ones do too (s)")
    handles = [plt.Line2D([], [], color=c, marker=m, linestyle="") for _, c, m in ASKED.values()]
    figure.legend(handles, [text for text, *_ in ASKED.values()], loc="outside lower center", ncols=3, title="relative error")
    axis.set_title(
        f"{cube.attrs['title']}: what 10 %, 1 % and 0.1 % cost\n{cube.attrs['machine']}, {cube.attrs['measured_on']}"
    )
    save(figure, found.rename(columns={"cost": "cost_s"}), stem)


def _words(one) -> str:
    """What reaches an error, or why nothing does."""
    text = ASKED[one.asked][0]
    if one.ladder:
        return f"{text}: {one.ladder}, {one.setting:.6g}"
    return f"{text}: " + (
        "drowned in chance, which alone makes %.0f %%" % (100 * one.floor) if one.floor > one.asked else "not reached"
    )


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
