"""How large a peak seems by how often one looks: single contacts of side walls and floor, every step against instants apart."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import ensembles
from silostudy.figures.style import save

SHOWN = {12: "#0072b2", 18: "#d55e00"}
PRINTED = {
    "contact_overpressure": ((2, 5), "source, 17/18: 2 to 5"),
    "floor_overpressure": ((7.5, 12.5), "source, 17/18: about 10"),
}
NAMES = {"contact_overpressure": "side walls", "floor_overpressure": "floor and the slit's edges"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: median and middle four fifths of the runs by interval between looks."""
    cube = ensembles.first(cube)
    figure, panels = plt.subplots(1, 2, figsize=(11.5, 5), sharey=True)
    places, numbers = np.arange(cube.sizes["look"]), []
    for panel, (variable, ((low, high), text)) in zip(panels, PRINTED.items(), strict=True):
        panel.axhspan(low, high, color="black", alpha=0.08, linewidth=0, label=text)
        for across in [int(s) for s in cube["packing"].values if int(s) in SHOWN]:
            values = ensembles.runs(cube[variable].sel(packing=across))
            ensembles.bundle(panel, places, values, colour=SHOWN[across], label=ensembles.name(across), faint=False)
            numbers.append(_summary(cube, variable, across, values))
        panel.set_xticks(places, [text.replace("step", "every\nstep") for text in cube["look"].values])
        panel.set(yscale="log", xlabel="time between looks", title=NAMES[variable])
        panel.set_yticks([1, 2, 5, 10, 20, 50], ["1", "2", "5", "10", "20", "50"])
        panel.legend(fontsize=8)
    panels[0].set_ylabel("largest contact force seen over the largest at rest")
    figure.suptitle(f"{cube.attrs['title']}\nmedian and middle four fifths of {cube.sizes['run'] - 1} runs")
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def _summary(cube: xr.Dataset, variable: str, across: int, values: np.ndarray) -> pd.DataFrame:
    low, middle, high = ensembles.spread(values)
    table = {"look": cube["look"].values, "tenth": low, "median": middle, "nine_tenths": high}
    return pd.DataFrame({"packing": ensembles.name(across), "quantity": NAMES[variable], **table})
