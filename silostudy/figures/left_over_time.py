"""Share of the spheres that is left in a silo over the time of its discharge: mean of the fillings, least and largest."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.beside import settings, told
from silostudy.figures.style import WIDTH, foot, headline, plt, save, series

FILLING = "filling"


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line a setting with the band of its fillings."""
    figure, panel = plt.subplots(figsize=(WIDTH, 5.4))
    others, numbers = [axis for axis in cube.attrs["sweep_axes"].split() if axis != FILLING], []
    for number, (setting, case) in enumerate(settings(cube.assign_attrs(sweep_axes=" ".join(others)))):
        table, style = left(case), series(number)
        panel.fill_between(
            table["time_s"], table["least_left"], table["most_left"], color=style["color"], alpha=0.2, linewidth=0
        )
        panel.plot(table["time_s"], table["share_left"], label=told(setting, case), markevery=0.1, **style)
        numbers.append(table.assign(**setting))
    panel.set(xlabel="time from the opening (s)", ylabel="share of the spheres that is left", ylim=(0.0, 1.0))
    shown = pd.concat(numbers, ignore_index=True)
    panel.set_xlim(0.0, shown["time_s"].max())
    headline(figure, _message(numbers))
    read = f"{cube.attrs['title']}; line: mean of the fillings, band: least to largest"
    foot(figure, read, handles=panel.get_legend_handles_labels()[0])
    save(figure, shown, stem)


def _message(numbers: list[pd.DataFrame]) -> str:
    """Sentence on what the figure says: what is left in the end, and how far fillings are apart."""
    ends = [100.0 * float(table["share_left"].iloc[-1]) for table in numbers]
    apart = max(100.0 * float((table["most_left"] - table["least_left"]).max()) for table in numbers)
    left_over = f"{min(ends):.0f} to {max(ends):.0f} %" if len(ends) > 1 else f"{ends[0]:.0f} %"
    return f"In the end {left_over} of the spheres are left; fillings differ by {apart:.2g} % of all spheres at most"


def left(case: xr.Dataset) -> pd.DataFrame:
    """A row a moment (s): share that is left, mean of the fillings, least and largest."""
    share = case["share_left"].transpose("flow_share", FILLING).values
    span = float((case["end_time"] - case["first_event_time"]).mean())
    return pd.DataFrame({
        "time_s": case["flow_share"].values * span, "share_left": np.nanmean(share, axis=1),
        "least_left": np.nanmin(share, axis=1), "most_left": np.nanmax(share, axis=1),
    })  # fmt: skip
