"""Largest wall pressure of the grains in flow over that at rest, by the area that it is the mean of, beside the codes."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.beside import interval, methods_of, settings, told
from silostudy.figures.style import look, plt, save, title

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
MARKS = "osD^vP"
ASIDE = 0.04  # between the points of two settings
AREAS = {"1x1": "one cell", "2x2": "2 by 2 cells", "4x4": "4 by 4 cells", "ring": "ring of a level"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line a setting over the areas, and a line a method across."""
    figure, panel = plt.subplots(figsize=(10.4, 5.4))
    numbers = [_grains(panel, setting, one, number) for number, (setting, one) in enumerate(settings(cube))]
    codes = factors(cube)
    for _, code in codes.iterrows():
        label = f"{title(cube, code['of'])}, largest discharge over filling: {code['factor']:.2f}"
        panel.axhline(code["factor"], color=look(cube, code["of"])["color"], linewidth=0.9, alpha=0.8, label=label)
    panel.axhline(1.0, color="black", linewidth=0.8)
    sides = cube["averaging_side"].mean([dim for dim in cube["averaging_side"].dims if dim != "averaging"]).values
    names = [f"{AREAS[str(area)]}\n{side:.2f} D" for area, side in zip(cube["averaging"].values, sides, strict=True)]
    panel.set_xticks(range(len(names)), names)
    panel.set(xlabel="area that the pressure is the mean of, and the root of it over the diameter", ylim=(0.0, None))
    panel.set(ylabel="largest in flow over the ring's mean at rest", xlim=(-0.4, len(names) - 0.6))
    figure.legend(loc="outside right center", fontsize=8)
    figure.suptitle(f"{cube.attrs['title']}\nthe smaller the area, the larger the peak")
    save(figure, pd.concat([*numbers, codes], ignore_index=True), stem)


def _grains(panel, setting: dict, one: xr.Dataset, number: int) -> pd.DataFrame:
    """Draws a setting, a little aside of the others; its numbers."""
    values = one["largest_over_rest"].sel(phase="discharge")
    areas = one["averaging"].values
    table = pd.DataFrame(
        [interval(values.sel(averaging=area).values) for area in areas], columns=["factor", "low_95", "high_95"]
    )
    spread = np.abs(table[["low_95", "high_95"]].to_numpy().T - table["factor"].to_numpy())
    place = np.arange(len(areas)) + ASIDE * ((number + 1) // 2) * (-1) ** number
    panel.errorbar(place, table["factor"], yerr=spread, color=COLOURS[number % len(COLOURS)], capsize=3,
                   marker=MARKS[number % len(MARKS)], label=f"grains, {told(setting)}")  # fmt: skip
    side = one["averaging_side"].mean("filling").values
    return table.assign(side_over_diameter=side, averaging=areas, of="grains", **setting)


def factors(cube: xr.Dataset) -> pd.DataFrame:
    """Largest ratio of each method's own pressures in discharge and filling, over all levels and settings."""
    pressure, found = cube["code_wall_pressure"], []
    ratio = pressure.sel(phase="discharge") / pressure.sel(phase="filling")
    for method in dict.fromkeys(name for _, one in settings(cube) for name in methods_of(one, "discharge")):
        largest = float(ratio.sel(pressure_method=method).max())
        if np.isfinite(largest) and not np.isclose(largest, 1.0):
            found.append({"of": method, "factor": largest})
    return pd.DataFrame(found, columns=["of", "factor"])
