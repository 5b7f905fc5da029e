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
    """Writes the figure and the table; an error counts with the upper end of its interval."""
    found = costs(cube)
    names = list(dict.fromkeys(zip(found["problem"], found["quantity"], strict=True)))
    figure, axis = plt.subplots(figsize=(13, 0.62 * len(names) + 1.8))
    for row, name in enumerate(names):
        part = found[(found["problem"] == name[0]) & (found["quantity"] == name[1])]
        axis.plot(part["cost"], np.full(len(part), row), color="grey", linewidth=1, zorder=1)
        words = []
        for one in part.itertuples():
            text, colour, marker = ASKED[one.asked]
            axis.scatter(one.cost, row, color=colour, marker=marker, s=40, zorder=2, label=text if row == 0 else None)
            words.append(f"{text}: {one.ladder}, {one.setting:.3g}" if one.ladder else f"{text}: not reached")
        axis.text(1.01, row, "\n".join(words), transform=axis.get_yaxis_transform(), fontsize=6.3, va="center")
    axis.set_yticks(range(len(names)), [_label(found, name) for name in names], fontsize=7.5)
    axis.invert_yaxis()
    axis.set(xscale="log", xlabel="CPU time of the cheapest setting that reaches it (s)")
    handles = [plt.Line2D([], [], color=c, marker=m, linestyle="") for _, c, m in ASKED.values()]
    figure.legend(handles, [text for text, *_ in ASKED.values()], loc="outside lower center", ncols=3, title="relative error")
    axis.set_title(
        f"{cube.attrs['title']}: what 10 %, 1 % and 0.1 % cost\n{cube.attrs['machine']}, {cube.attrs['measured_on']}"
    )
    save(figure, found, stem)


def _label(found: pd.DataFrame, name: tuple[str, str]) -> str:
    row = found[(found["problem"] == name[0]) & (found["quantity"] == name[1])].iloc[0]
    return f"{row['problem'].replace('_', ' ')}: {name[1].replace('_', ' ')}"


def costs(cube: xr.Dataset) -> pd.DataFrame:
    """The cheapest point of every problem and quantity that reaches each asked error; without ladder where none does."""
    rows = []
    for (problem, quantity), part in table(cube).groupby(["problem", "quantity"], sort=False):
        for asked in ASKED:
            reached = part[part["error_high"] <= asked].sort_values("cost")
            row = {"problem": problem, "quantity": quantity, "asked": asked}
            empty = {"ladder": "", "setting": np.nan, "error": np.nan, "error_high": np.nan, "cost": np.nan}
            rows.append(row | ({name: reached.iloc[0][name] for name in empty} if len(reached) else empty))
    return pd.DataFrame(rows)
