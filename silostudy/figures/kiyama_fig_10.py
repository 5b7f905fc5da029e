"""Force on the side walls in time, after the source's Fig. 10: median, band and single runs of every packing."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import ensembles
from silostudy.figures.style import save

LOOKS = {"side_normal_force": ("normal force $P_y$", "#0072b2"), "side_shear_force": ("shear, carrying positive", "#d55e00")}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: forces on both walls over their normal force at rest, means of 10 ms."""
    cube = ensembles.first(cube)
    packings = cube["packing"].values
    columns = min(4, len(packings))
    figure, panels = plt.subplots(
        -(-len(packings) // columns), columns, figsize=(13.5, 6.6), sharex=True, sharey=True, squeeze=False
    )
    numbers = []
    for panel, across in zip(panels.flat, packings, strict=False):
        one = cube.sel(packing=across)
        for variable, (label, colour) in LOOKS.items():
            values = one[variable] / (2 * one["rest_side_normal_force"].sum("layer"))
            ensembles.bundle(panel, one["interval"].values, ensembles.runs(values), colour=colour, label=label)
            panel.plot(one["interval"], values.isel(run=0), color=colour, linewidth=0.9, linestyle=(0, (3, 1.5)))
            numbers.append(_summary(ensembles.name(across), variable, one["interval"].values, values))
        panel.axhline(1, color="black", linewidth=0.8)
        panel.axhline(0, color="black", linewidth=0.5)
        panel.axvspan(0.2, 0.3, color="black", alpha=0.06, linewidth=0)
        panel.set_title(ensembles.name(across))
    for panel in panels[-1]:
        panel.set_xlabel("time since the slit was opened (s)")
    for panel in panels[:, 0]:
        panel.set_ylabel("force on both side walls over static")
    panels[0, 0].legend(loc="upper right", fontsize=8)
    figure.suptitle(
        f"{cube.attrs['title']}\nmedian and middle four fifths of {cube.sizes['run'] - 1} runs, single runs faint, ideal start"
        " dashed; grey: the source's time of the peaks"
    )
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _summary(packing: str, variable: str, time: np.ndarray, values: xr.DataArray) -> pd.DataFrame:
    low, middle, high = ensembles.spread(ensembles.runs(values))
    table = {"time_s": time, "tenth": low, "median": middle, "nine_tenths": high, "ideal_start": values.isel(run=0).values}
    table |= {f"run_{run}": values.isel(run=run).values for run in range(1, values.sizes["run"])}
    return pd.DataFrame({"packing": packing, "quantity": variable, **table})
