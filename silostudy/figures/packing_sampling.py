"""Size that a peak seems to have by how often one looks: single contacts of walls and floor, every step against instants."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.patheffects import withStroke

from silostudy.figures import ensembles
from silostudy.figures.style import BLUE, VERMILION, WIDTH, foot, headline, save

SHOWN: dict[int, dict] = {
    12: {"color": BLUE, "marker": "o"},
    18: {"color": VERMILION, "marker": "s", "linestyle": (0, (4, 2))},
}
PRINTED = {
    "contact_overpressure": ((2, 5), "source, 17/18: 2 to 5"),
    "floor_overpressure": ((7.5, 12.5), "source, 17/18: about 10"),
}
SELDOM = "50 ms"  # what plots of the time show
NAMES = {"contact_overpressure": "side walls", "floor_overpressure": "floor and the slit's edges"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: median and middle four fifths of the runs by interval between looks."""
    cube = ensembles.first(cube)
    figure, panels = plt.subplots(1, 2, figsize=(WIDTH, 6.0), sharey=True)
    places, numbers = np.arange(cube.sizes["look"]), []
    for panel, (variable, ((low, high), text)) in zip(panels, PRINTED.items(), strict=True):
        panel.axhspan(low, high, color="black", alpha=0.08, linewidth=0)
        label = panel.text(0.6, low, text, transform=panel.get_yaxis_transform(), ha="center", va="bottom", fontsize="small")
        label.set_path_effects([withStroke(linewidth=2.5, foreground="white")])
        for across in [int(s) for s in cube["packing"].values if int(s) in SHOWN]:
            values = ensembles.runs(cube[variable].sel(packing=across))
            ensembles.bundle(panel, places, values, label=ensembles.name(across), faint=False, **SHOWN[across])
            numbers.append(_summary(cube, variable, across, values))
        panel.set_xticks(places, [text.replace("step", "every\nstep") for text in cube["look"].values])
        panel.set(yscale="log", xlabel="time between looks", title=NAMES[variable])
        panel.set_yticks([1, 2, 5, 10, 20, 50], ["1", "2", "5", "10", "20", "50"])
    panels[0].set_ylabel("largest contact force seen over the largest at rest")
    table = pd.concat(numbers, ignore_index=True)
    headline(figure, _message(table))
    about = f"Median and middle four fifths of {cube.sizes['run'] - 1} runs, by packing."
    foot(figure, f"{cube.attrs['title']}.", about, handles=panels[0].get_legend_handles_labels()[0])
    save(figure, table, stem)


def _message(table: pd.DataFrame) -> str:
    """Message: how large the peaks of the last packing seem to who looks at every step, and to who looks seldom."""
    packing = table["packing"].iloc[-1]
    told = []
    for place, group in table[table["packing"] == packing].groupby("quantity", sort=False):
        often, seldom = group.iloc[0], group[group["look"] == SELDOM].iloc[0]
        told.append(f"{often['median']:.1f} times rest on the {place} in any step, {seldom['median']:.1f} seen every {SELDOM}")
    return f"In {packing} a contact peaks at {'; '.join(told)}"


def _summary(cube: xr.Dataset, variable: str, across: int, values: np.ndarray) -> pd.DataFrame:
    low, middle, high = ensembles.spread(values)
    table = {"look": cube["look"].values, "tenth": low, "median": middle, "nine_tenths": high}
    return pd.DataFrame({"packing": ensembles.name(across), "quantity": NAMES[variable], **table})
