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
from silostudy.figures.style import VERMILION, WIDTH, foot, headline, save

READ = (
    "Left of 1 the prediction is unsafe. Grey, below the line: rival readings of the source, taken at their word",
    "numbers: mean and coefficient of variation of the small tests; masked tests are those that a rule does not cover",
)
OFFSET = {"unstiffened": 0.22, "ringed": 0.0, "large": -0.22}  # of the groups within a line


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    ratio = cube["test_lower_buckling_stress"] / cube["buckling_stress"]
    rules, groups, summary = list(map(str, cube["rule"].values)), group(cube), statistics(cube)
    figure, panel = plt.subplots(figsize=(WIDTH, 0.46 * len(rules) + 2.0))
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
            panel.plot(values, level, color="0.55" if is_rival(cube, rule) else VERMILION, **style)
        panel.text(1.01, place, _note(summary, rule), transform=panel.get_yaxis_transform(), va="center", fontsize="small")
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
    headline(figure, _message(summary))
    looks: dict[str, Any] = {"linestyle": "none", "color": "black", "markerfacecolor": "none"}
    handles = [Line2D([], [], marker=marker, label=label, **looks) for marker, label in GROUPS.values()]
    foot(figure, *READ, handles=handles)
    save(figure, _numbers(cube, ratio, groups), stem)


def _message(summary: pd.DataFrame) -> str:
    """Message of the figure, in numbers: the rule with the least scatter, and the range of the others' means."""
    rules = summary[(summary.group == "small, all") & ~summary.rival].sort_values("cov")
    best, others = rules.iloc[0], rules.iloc[1:]
    return (
        f"The small tests bore {best['mean']:.2f} times what {best.title} predicts, with the least scatter"
        f" ({100 * best['cov']:.0f} %), and {others['mean'].min():.2f} to {others['mean'].max():.2f} times what the others do"
    )


def _note(summary: pd.DataFrame, rule: str) -> str:
    row = summary[(summary.rule == rule) & (summary.group == "small, all")].iloc[0]
    masked = f", {row.masked} masked" if row.masked else ""
    return f"{row['mean']:.3f}, {row['cov']:.3f}{masked}" if row.tests else f"all {row.masked} masked"


def _numbers(cube: xr.Dataset, ratio: xr.DataArray, groups: np.ndarray) -> pd.DataFrame:
    table = ratio.rename("test_over_prediction").to_dataframe().reset_index()[["rule", "test", "test_over_prediction"]]
    return table.assign(group=table.test.map(dict(zip(map(str, cube["test"].values), groups, strict=True))))
