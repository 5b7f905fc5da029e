"""Largest wall pressure of the grains in flow over that at rest, by the area that it is the mean of, beside the codes."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.apart import apart
from silostudy.figures.beside import interval, methods_of, settings, span, told
from silostudy.figures.style import AID, BLACK, REST, WIDTH, foot, headline, plt, save, series, title

ASIDE = 0.05  # between the points of two settings
CLOSEST = 0.045  # share of the height of the panel between two names of codes
AREAS = {"1x1": "one cell", "2x2": "2 by 2 cells", "4x4": "4 by 4 cells", "ring": "ring of a level"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line a setting over the areas, and a line a method across."""
    figure, panel = plt.subplots(figsize=(WIDTH, 6.2))
    grains = pd.concat([_grains(panel, setting, silo, k) for k, (setting, silo) in enumerate(settings(cube))])
    codes = factors(cube)
    panel.set_ylim(0.0, 1.06 * np.nanmax([*grains["factor"], *grains["high_95"], *codes["factor"]]))
    _draw_codes(panel, cube, codes)
    panel.axhline(1.0, color=BLACK, linewidth=0.8)
    sides = (cube["averaging_side"].sel(averaging=area) for area in cube["averaging"].values)
    wide = [span(float(side.min()), float(side.max())) for side in sides]
    names = [f"{AREAS[str(area)]}\n{side} D" for area, side in zip(cube["averaging"].values, wide, strict=True)]
    panel.set_xticks(range(len(names)), names)
    panel.set(xlabel="area that the pressure is the mean of, and the root of it over the diameter D")
    panel.set(ylabel="largest in flow over the ring's mean at rest", xlim=(-0.4, len(names) - 0.6))
    headline(figure, _message(grains, codes))
    across = "Grey lines: largest ratio of a method's own pressures in discharge and after filling, over all silos and levels "
    across += "half a diameter deep and deeper; dashed: with its patch load, on the patch."
    about = f"{cube.attrs['title']}. Points: mean of the fillings and its interval, 95 %."
    foot(figure, about, across, handles=panel.get_legend_handles_labels()[0])
    save(figure, pd.concat([grains, codes], ignore_index=True), stem)


def _grains(panel: Axes, setting: dict, silo: xr.Dataset, number: int) -> pd.DataFrame:
    """Draws a setting, a little aside of the others; its numbers."""
    values = silo["largest_over_rest"].sel(phase="discharge")
    areas = silo["averaging"].values
    table = pd.DataFrame(
        [interval(values.sel(averaging=area).values) for area in areas], columns=["factor", "low_95", "high_95"]
    )
    if table["factor"].notna().any():
        spread = np.abs(table[["low_95", "high_95"]].to_numpy().T - table["factor"].to_numpy())
        place = np.arange(len(areas)) + ASIDE * ((number + 1) // 2) * (-1) ** number
        panel.errorbar(place, table["factor"], yerr=spread, capsize=3, linewidth=1.6, label=f"grains, {told(setting, silo)}",
                       **series(number))  # fmt: skip
    side = silo["averaging_side"].mean("filling").values
    return table.assign(side_over_diameter=side, averaging=areas, of="grains", **setting)


def _draw_codes(panel: Axes, cube: xr.Dataset, codes: pd.DataFrame) -> None:
    """A grey line a method, with its name beside the panel."""
    places = apart(codes["factor"], CLOSEST * panel.get_ylim()[1])
    for row, place in zip(codes.to_dict("records"), places, strict=True):
        panel.axhline(row["factor"], **REST | {"linestyle": "--" if row["patch"] else "-"})
        words = f"{title(cube, row['of'])}{', patch' if row['patch'] else ''}: {row['factor']:.2f}"
        line = {"color": REST["color"], "linewidth": 0.8, "clip_on": False, "transform": panel.get_yaxis_transform()}
        panel.plot([1.0, 1.015], [row["factor"], place], gid=AID, **line)
        panel.text(1.02, place, words, transform=panel.get_yaxis_transform(), fontsize="small", va="center")


def _message(grains: pd.DataFrame, codes: pd.DataFrame) -> str:
    """Peaks of the smallest and the largest area over all silos, and the methods whose factor is larger than them."""
    small, large = (grains[grains["averaging"] == area]["factor"] for area in ("1x1", "ring"))
    if not small.notna().any():
        return "No silo is deep enough for peaks over rest"
    over, many = codes[codes["factor"] >= small.max()]["of"].nunique(), codes["of"].nunique()
    return (
        f"Peaks in flow are {span(small.min(), small.max())} times rest on one cell, {span(large.min(), large.max())} times "
        f"around a ring; {over} of {many} methods raise their filling by as much as the highest of them"
    )


def factors(cube: xr.Dataset) -> pd.DataFrame:
    """Largest ratio of each method's own pressures in discharge and filling, over all deep levels and settings, least first.

    Of a method with a patch load in discharge once more, with it.
    """
    rows = []
    for method in dict.fromkeys(name for _, silo in settings(cube) for name in methods_of(silo, "discharge")):
        own = cube.sel(pressure_method=method)
        ratio = own["code_largest_over_rest"]
        patch = own["code_patch_factor"].sel(phase="discharge").fillna(0.0) if "code_patch_factor" in own else xr.DataArray(0.0)
        rows.append({"of": method, "factor": float(ratio.max()), "patch": False})
        rows += [{"of": method, "factor": float((ratio * (1.0 + patch)).max()), "patch": True}] if patch.max() > 0.0 else []
    table = pd.DataFrame(rows, columns=["of", "factor", "patch"]).dropna(subset=["factor"])
    return table.sort_values("factor", ignore_index=True)
