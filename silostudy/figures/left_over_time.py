"""Share of the spheres that is left in a silo over the time of its discharge: mean of the fillings, least and largest."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.beside import settings, told
from silostudy.figures.style import plt, save

FILLING = "filling"
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line a setting with the band of its fillings."""
    figure, panel = plt.subplots(figsize=(8.0, 5.0))
    others = [axis for axis in cube.attrs["sweep_axes"].split() if axis != FILLING]
    numbers, widest = [], 0.0
    for number, (setting, one) in enumerate(settings(cube.assign_attrs(sweep_axes=" ".join(others)))):
        table, colour = left(one), COLOURS[number % len(COLOURS)]
        panel.fill_between(table["time_s"], table["least_left"], table["most_left"], color=colour, alpha=0.2, linewidth=0)
        panel.plot(table["time_s"], table["share_left"], color=colour, label=told(setting))
        widest = max(widest, float((table["most_left"] - table["least_left"]).max()))
        numbers.append(table.assign(**setting))
    panel.set(xlabel="time from the opening (s)", ylabel="share of the spheres that is left", xlim=(0.0, None), ylim=(0.0, 1.0))
    panel.legend(fontsize=8)
    figure.suptitle(f"{cube.attrs['title']}\nfillings differ by {100.0 * widest:.2g} % of all spheres at most", fontsize=10)
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def left(one: xr.Dataset) -> pd.DataFrame:
    """A row a moment (s): share that is left, mean of the fillings, least and largest."""
    share = one["share_left"].transpose("flow_share", FILLING).values
    span = float((one["end_time"] - one["first_event_time"]).mean())
    return pd.DataFrame({
        "time_s": one["flow_share"].values * span, "share_left": np.nanmean(share, axis=1),
        "least_left": np.nanmin(share, axis=1), "most_left": np.nanmax(share, axis=1),
    })  # fmt: skip
