"""Influence of the stored solid's properties: first-order and total Sobol indices of the largest wall pressure."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import BLUE, ORANGE, SKY, VERMILION, WIDTH, foot, headline, save, title
from silostudy.figures.uncertainty_bands import distinct_methods, missing

LOOKS = {
    "internal_friction_angle": (ORANGE, "////"),
    "wall_friction": (BLUE, ""),
    "lateral_pressure_ratio": (SKY, "...."),
    "unit_weight": (VERMILION, "xxxx"),
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a bar for each method and phase, split by first-order index, a tick at the sum of the total indices."""
    numbers = _numbers(cube)
    bars = numbers.groupby("curve", sort=False)
    figure, panel = plt.subplots(figsize=(WIDTH, 0.27 * len(bars) + 2.3))
    start = np.zeros(len(bars))
    for parameter, (colour, hatch) in LOOKS.items():
        share = numbers[numbers.parameter == parameter].first_order.clip(lower=0).to_numpy()
        name = parameter.replace("_", " ")
        panel.barh(
            np.arange(len(bars)), share, left=start, color=colour, hatch=hatch, edgecolor="white", height=0.75, label=name
        )
        start = start + share
    panel.plot(
        bars.sum_of_totals.first().to_numpy(), np.arange(len(bars)), "k|", markersize=11, label="sum of the total indices"
    )
    panel.set_yticks(np.arange(len(bars)), list(bars.groups))
    panel.set(xlabel="share of the variance of the largest wall pressure (first-order Sobol index)", xlim=(0, 1.1))
    panel.set_ylim(len(bars) - 0.4, -0.6)
    panel.grid(axis="y", visible=False)
    headline(figure, _message(numbers))
    foot(figure, cube.attrs["title"], *missing(cube), handles=panel.get_legend_handles_labels()[0])
    save(figure, numbers, stem)


def _message(numbers: pd.DataFrame) -> str:
    """Message of the figure, in numbers: the two properties that matter most, in the median of methods and phases."""
    shares = numbers.groupby("parameter").first_order.median().sort_values(ascending=False)[:2]
    told = (f"{str(parameter).replace('_', ' ')} {100 * share:.0f} %" for parameter, share in shares.items())
    return f"What scatters the largest wall pressure most, in the median of the methods: {', '.join(told)} of its variance"


def _numbers(cube: xr.Dataset) -> pd.DataFrame:
    tables = []
    for method in distinct_methods(cube):
        for phase in map(str, cube["phase"].values):
            here = cube.sel(pressure_method=method, phase=phase)
            table = {"curve": f"{title(cube, method)}, {phase}", "parameter": cube["parameter"].values}
            table |= {"first_order": here["sobol_first"].values, "total": here["sobol_total"].values}
            tables.append(pd.DataFrame(table))
    table = pd.concat(tables, ignore_index=True).dropna()
    return table.assign(sum_of_totals=table.groupby("curve").total.transform("sum"))
