"""Overpressure factor over H/D by method: of the largest pressure, and of the mean pressure on the wall.

The factor at a single depth is no guide near the surface, where the static pressure vanishes: Jenike's grows there
without bound.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr

from silostudy.cube.silence import silences
from silostudy.figures.style import HATCHES, WIDTH, foot, headline, look, name, save, title

LARGEST = "largest pressure over largest static pressure"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: median, least and largest over all the other axes of the study."""
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    whole, cube = cube, cube.sel({"phase": "discharge"})
    pressure = cube["wall_normal_pressure"]
    static = pressure / cube["overpressure_factor"]
    panels = {
        LARGEST: pressure.max(level) / static.max(level),
        "mean pressure over mean static pressure": pressure.mean(level) / static.mean(level),
    }
    numbers = pd.concat([_summary(values, quantity) for quantity, values in panels.items()], ignore_index=True)
    figure, axes = plt.subplots(1, 2, figsize=(WIDTH, 5.8), sharey=True)
    for panel, quantity in zip(axes, panels, strict=True):
        shown = numbers[numbers.quantity == quantity]
        for place, (method, group) in enumerate(shown.groupby("pressure_method", sort=False)):
            style = {**look(cube, method), "markersize": 9 - 0.6 * place}  # so that curves that coincide all show
            label = title(cube, method) if panel is axes[0] else None
            panel.plot(group.slenderness, group["median"], linewidth=1.4, label=label, **style)
            hatch = {"hatch": HATCHES[place % len(HATCHES)], "facecolor": style["color"], "edgecolor": style["color"]}
            panel.fill_between(group.slenderness, group["min"], group["max"], alpha=0.15, linewidth=0, **hatch)
        panel.set(xlabel="cylinder depth over diameter H/D", title=quantity)
        panel.axhline(1, color="black", linewidth=0.8)
    axes[0].set_ylim(0, None)  # once both panels hold their bands
    axes[0].set_ylabel("overpressure factor\nover the method's own static Janssen")
    headline(figure, _message(cube, numbers))
    unspoken = [*silences(whole, in_every_case=True, titles=True), *silences(_gapped(cube, numbers), titles=True)]
    read = f"{cube.attrs['title']}; line: median over the study's other axes; band: least to largest"
    foot(figure, read, *unspoken, handles=axes[0].get_legend_handles_labels()[0])
    save(figure, numbers, stem)


def _message(cube: xr.Dataset, numbers: pd.DataFrame) -> str:
    """Message of the figure, in numbers: the methods with the least and the largest factor of the most slender silos."""
    largest = numbers[numbers.quantity == LARGEST]
    slender = largest[largest.slenderness == largest.slenderness.max()].sort_values("median")
    least, most = (slender.iloc[place] for place in (0, -1))
    return (
        f"At H/D = {least.slenderness:g} discharge raises the largest pressure {least['median']:.1f} times"
        f" by {name(cube, least.pressure_method)}, {most['median']:.1f} times by {name(cube, most.pressure_method)}"
    )


def _gapped(cube: xr.Dataset, numbers: pd.DataFrame) -> xr.Dataset:
    """The methods whose curve leaves out some slendernesses: lone points are to be explained."""
    points = numbers.groupby("pressure_method").slenderness.nunique()
    gapped = points.index[points < cube.sizes["slenderness"]]
    return cube.sel(pressure_method=list(gapped)).expand_dims("phase")


def _summary(values: xr.DataArray, quantity: str) -> pd.DataFrame:
    others = [dim for dim in values.dims if dim not in ("pressure_method", "slenderness")]
    table = xr.Dataset(
        {
            "median": values.median(others),
            "min": values.min(others),
            "max": values.max(others),
            "cases": values.count(others),
        }
    ).to_dataframe()
    table = table.reset_index()[["pressure_method", "slenderness", "median", "min", "max", "cases"]]
    order = {str(method): place for place, method in enumerate(values["pressure_method"].values)}
    table = table[table["cases"] > 0].sort_values("pressure_method", key=lambda names: names.map(order), kind="stable")
    return table.assign(quantity=quantity)
