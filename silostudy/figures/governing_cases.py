"""Governing load case of each part of a silo's steel: parts against combinations, with utilisation and check."""

from itertools import pairwise
from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch, Rectangle

from silostudy.cube.governing import parts
from silostudy.figures import rules
from silostudy.figures.style import WIDTH, foot, headline, save, title

STEPS = (0.0, 0.25, 0.5, 0.75, 1.0, 1e9)  # of utilisation, with a colour each
COLOURS = ("#F7F7F7", "#D1E5F0", "#92C5DE", "#FDDBC7", "#D6604D")
BLANK = "#FFFFFF"
UNCHECKED = "not checked"
READ = "utilisation (1), the check behind it, load case of the contents (filling: with its patch, if it has one)"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the table of parts by combinations for the first method and rule, and the numbers for all of them."""
    methods, judges = (list(map(str, cube[name].values)) for name in ("pressure_method", "rule"))
    table = pd.concat(
        [
            pd.DataFrame(parts(cube, method, rule)).assign(pressure_method=method, rule=rule)
            for method in methods
            for rule in judges
        ],
        ignore_index=True,
    )
    shown = _made(table[(table.pressure_method == methods[0]) & (table["rule"] == judges[0])])
    names, keys = list(dict.fromkeys(shown["part"])), list(dict.fromkeys(shown.combination))
    figure, axes = plt.subplots(figsize=(WIDTH, 2.4 + 0.68 * len(names)))
    _fields(axes, shown, names, keys)
    axes.set_xticks(range(len(keys)), [_head(cube, key) for key in keys])
    axes.set_yticks(range(len(names)), [_part(cube, name) for name in names])
    axes.tick_params(length=0, top=True, bottom=False, labeltop=True, labelbottom=False)
    axes.grid(False)
    axes.spines[:].set_visible(False)
    wall = f"{title(cube, methods[0])}; buckling by {rules.name(cube, judges[0])}{_cases(cube)}"
    unseen = ", ".join(key for key in map(str, cube["combination"].values) if key not in keys)
    told = f"; not checked: {unseen}" if unseen else ""
    headline(figure, _message(cube, shown))
    foot(figure, f"{cube.attrs['title']}; {wall}{told}", READ, handles=_handles())
    save(figure, table[["pressure_method", "rule", *table.columns.drop(["pressure_method", "rule"])]], stem)


def _message(cube: xr.Dataset, shown: pd.DataFrame) -> str:
    """Message of the table, in numbers: the part that is used most, with its check and combination."""
    worst = shown.loc[shown.utilisation.idxmax()]
    words = str(cube["combination_title"].sel(combination=worst.combination).values)
    check = worst.governed_by.replace("_", " ")
    check = "" if check == worst["part"] else f", by {check}"
    return f"Used most: {worst['part']}, to {worst.utilisation:.2f}{check}, under {worst.combination} ({words})"


def _made(table: pd.DataFrame) -> pd.DataFrame:
    """The rows of parts and combinations of which something was looked at."""
    looked_at = table[table.state != UNCHECKED]
    return table[table["part"].isin(looked_at["part"]) & table.combination.isin(looked_at.combination)]


def _cases(cube: xr.Dataset) -> str:
    axes = cube.attrs["sweep_axes"].replace("_", " ").split(" ") if cube.attrs["sweep_axes"] else []
    return f"; the worst over {' '.join(axes)}" if axes else ""


def _fields(axes, shown: pd.DataFrame, names: list[str], keys: list[str]) -> None:
    """A field for each part and combination; the governing one of each part has a frame."""
    used = shown.pivot(index="part", columns="combination", values="utilisation").loc[names, keys].to_numpy()
    axes.imshow(used, cmap=ListedColormap(COLOURS), norm=BoundaryNorm(STEPS, len(COLOURS)), aspect="auto")
    for record in shown.itertuples():
        row, column = names.index(record.part), keys.index(record.combination)
        governs = record.utilisation > 0 and record.utilisation == np.nanmax(used[row])
        axes.text(
            column,
            row,
            _words(record, 110 // len(keys)),
            ha="center",
            va="center",
            fontsize="small",
            weight="bold" if governs else "normal",
        )
        if governs:
            axes.add_patch(Rectangle((column - 0.48, row - 0.46), 0.96, 0.92, fill=False, edgecolor="black", linewidth=2))


def _words(record, width: int) -> str:
    if not np.isfinite(record.utilisation):
        return "-" if record.state == UNCHECKED else record.state
    check = record.governed_by.replace("_", " ")
    lines = [f"{record.utilisation:.2f}", "" if check == record.part else fill(check, width), fill(record.load_case, width)]
    return "\n".join(dict.fromkeys(line for line in lines if line))


def _head(cube: xr.Dataset, key: str) -> str:
    words = str(cube["combination_title"].sel(combination=key).values)
    return f"{key}\n{fill(words, 16)}"


def _part(cube: xr.Dataset, name: str) -> str:
    """A part's name, of a strake with its depths and thickness where all cases have the same."""
    word, _, number = name.partition(" ")
    if word != "strake":
        return fill(name, 16)
    inside = cube["place_strake"] == int(number)
    depth, thickness = (cube[f"place_{what}"].where(inside) for what in ("depth", "thickness"))
    if not np.isclose(float(thickness.min()), float(thickness.max())):
        return name
    return f"{name}, {float(thickness.max()) * 1e3:g} mm\n{float(depth.min()):.1f} to {float(depth.max()):.1f} m"


def _handles() -> list[Patch]:
    ends = [f"above {low:g}" if high == STEPS[-1] else f"{low:g} to {high:g}" for low, high in pairwise(STEPS)]
    shades = [Patch(facecolor=colour, edgecolor="0.6", label=end) for colour, end in zip(COLOURS, ends, strict=True)]
    return [
        *shades,
        Patch(facecolor=BLANK, edgecolor="black", linewidth=2, label="governs the part"),
        Patch(alpha=0, label="-  not checked"),
    ]
