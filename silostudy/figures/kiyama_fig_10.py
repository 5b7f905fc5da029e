"""Force on the side walls in time, after the source's Fig. 10: median, band and single runs of every packing."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import ensembles
from silostudy.figures.style import BLUE, VERMILION, WIDTH, foot, headline, save

LOOKS: dict[str, tuple[dict, Any]] = {  # look of the median, line of the ideal start
    "side_normal_force": ({"label": "normal force $P_y$", "color": BLUE}, (0, (3, 1.5))),
    "side_shear_force": ({"label": "shear, carrying positive", "color": VERMILION, "linestyle": (0, (6, 1))}, (0, (1, 1))),
}
PEAKS = (0.2, 0.3)  # s: when the source sees the peaks
COLUMNS = 4


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: forces on both walls over their normal force at rest, means of 10 ms."""
    cube = ensembles.first(cube)
    packings = cube["packing"].values
    columns = min(COLUMNS, len(packings))
    rows = -(-len(packings) // columns)
    figure, panels = plt.subplots(
        rows, columns, figsize=(WIDTH, 1.8 + (5.0 if rows == 1 else 3.0 * rows)), sharex=True, sharey=True, squeeze=False
    )
    numbers = []
    for panel, across in zip(panels.flat, packings, strict=False):
        silo = cube.sel(packing=across)
        for variable, (look, ideal) in LOOKS.items():
            values = silo[variable] / (2 * silo["rest_side_normal_force"].sum("layer"))
            ensembles.bundle(panel, silo["interval"].values, ensembles.runs(values), **look)
            panel.plot(silo["interval"], values.isel(run=0), color=look["color"], linewidth=0.9, linestyle=ideal)
            numbers.append(_summary(ensembles.name(across), variable, silo["interval"].values, values))
        panel.axhline(1, color="black", linewidth=0.8)
        panel.axhline(0, color="black", linewidth=0.5)
        panel.axvspan(*PEAKS, color="black", alpha=0.06, linewidth=0)
        panel.set_title(ensembles.name(across))
    for panel in panels[-1]:
        panel.set_xlabel("time since opening (s)")
    figure.supylabel("force on both side walls over static")
    table = pd.concat(numbers, ignore_index=True)
    headline(figure, _message(table))
    about = (
        f"Median and middle four fifths of {cube.sizes['run'] - 1} runs, single runs grey, ideal start thin; means of 10 ms; "
    )
    handles = panels[0, 0].get_legend_handles_labels()[0]
    foot(figure, f"{cube.attrs['title']}.", f"{about}grey: the source's time of the peaks.", handles=handles)
    save(figure, table, stem)


def _message(table: pd.DataFrame) -> str:
    """Message: how high single runs peak in normal force, in the packings where they do most and least, and when."""
    normal = table[table["quantity"] == "side_normal_force"].set_index(["packing", "time_s"]).filter(like="run_")
    peaks, times = normal.groupby("packing").max(), normal.groupby("packing").idxmax().map(lambda place: place[1])
    most, least = peaks.max(axis=1).idxmax(), peaks.max(axis=1).idxmin()
    inside = int(times.loc[most].between(*PEAKS).sum())
    highest, lowest = (f"{peaks.loc[packing].max():.1f}" for packing in (most, least))
    told = f"Side walls are pushed at up to {highest} times static in {most}, {lowest} in {least}"
    return f"{told}; {inside} of {peaks.shape[1]} runs of {most} peak {PEAKS[0]} to {PEAKS[1]} s after opening"


def _summary(packing: str, variable: str, time: np.ndarray, values: xr.DataArray) -> pd.DataFrame:
    low, middle, high = ensembles.spread(ensembles.runs(values))
    table = {"time_s": time, "tenth": low, "median": middle, "nine_tenths": high, "ideal_start": values.isel(run=0).values}
    table |= {f"run_{run}": values.isel(run=run).values for run in range(1, values.sizes["run"])}
    return pd.DataFrame({"packing": packing, "quantity": variable, **table})
