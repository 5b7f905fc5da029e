"""Test over prediction for every rule and every rival reading of the source: which reading do the tests want?"""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.lines import Line2D

from silostudy.figures.miller_statistics import statistics
from silostudy.figures.rules import GROUPS, group, is_rival, name
from silostudy.figures.style import save

OFFSET = {"unstiffened": 0.22, "ringed": 0.0, "large": -0.22}  # of the groups within a line


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    ratio = cube["test_lower_buckling_stress"] / cube["buckling_stress"]
    rules, groups, found = list(map(str, cube["rule"].values)), group(cube), statistics(cube)
    figure, panel = plt.subplots(figsize=(10, 0.62 * len(rules) + 1.8))
    for place, rule in enumerate(reversed(rules)):
        for kind, (marker, _) in GROUPS.items():
            values = ratio.sel({"rule": rule}).values[groups == kind]
            level = np.full(len(values), place + OFFSET[kind])
            style: dict[str, Any] = {
                "marker": marker,
                "linestyle": "none",
                "markersize": 4.5,
                "markerfacecolor": "none",
                "alpha": 0.8,
            }
            panel.plot(values, level, color="#D55E00" if is_rival(cube, rule) else "black", **style)
        panel.text(1.01, place, _note(found, rule), transform=panel.get_yaxis_transform(), va="center", fontsize=8)
    rivals = sum(is_rival(cube, rule) for rule in rules)
    panel.axhline(rivals - 0.5, color="black", linewidth=0.8)
    panel.axvline(1, color="black", linewidth=0.8)
    labels = [("reading: " if is_rival(cube, rule) else "") + name(cube, rule) for rule in reversed(rules)]
    panel.set(xlabel="measured collapse stress over predicted buckling stress", xscale="log", yticks=range(len(rules)))
    panel.set_yticklabels(labels)
    panel.set_xticks(
        [0.4, 0.5, 0.6, 0.8, 1, 1.25, 1.5, 2, 3, 4, 5],
        labels=["0.4", "0.5", "0.6", "0.8", "1", "1.25", "1.5", "2", "3", "4", "5"],
    )
    panel.minorticks_off()
    panel.set_ylim(-0.6, len(rules) - 0.4)
    figure.suptitle(
        "Left of 1 the prediction is unsafe. Below the line: rival readings of the source, taken at their word\n"
        "(numbers: mean and coefficient of variation of the small tests; masked tests are those a rule does not cover)"
    )
    looks: dict[str, Any] = {"linestyle": "none", "color": "black", "markerfacecolor": "none"}
    handles = [Line2D([], [], marker=marker, label=label, **looks) for marker, label in GROUPS.values()]
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
    save(figure, _numbers(cube, ratio, groups), stem)


def _note(found: pd.DataFrame, rule: str) -> str:
    row = found[(found.rule == rule) & (found.group == "small, all")].iloc[0]
    masked = f", {row.masked} masked" if row.masked else ""
    return f"{row['mean']:.3f}, {row['cov']:.3f}{masked}" if row.tests else f"all {row.masked} masked"


def _numbers(cube: xr.Dataset, ratio: xr.DataArray, groups: np.ndarray) -> pd.DataFrame:
    table = ratio.rename("test_over_prediction").to_dataframe().reset_index()[["rule", "test", "test_over_prediction"]]
    return table.assign(group=table.test.map(dict(zip(map(str, cube["test"].values), groups, strict=True))))
