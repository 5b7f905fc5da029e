"""The picture of what is shown, in the style of the figures, for a report."""

import io

import pandas as pd
import xarray as xr

from silostudy.explore.shown import Selection, downward, said
from silostudy.figures.style import plt, series


def png(cube: xr.Dataset, choice: Selection, table: pd.DataFrame, title: str) -> io.BytesIO:
    """The curves as PNG, told apart by marker and line too."""
    figure, axes = plt.subplots(figsize=(7.5, 5.5))
    deep = downward(cube, choice.along)
    for k, (curve, rows) in enumerate(table.groupby("curve", sort=False)):
        across, up = (choice.quantity, choice.along) if deep else (choice.along, choice.quantity)
        axes.plot(rows[across], rows[up], label=curve, markevery=max(1, len(rows) // 8), **series(k))
    names = said(cube[choice.quantity]), said(cube[choice.along])
    axes.set(xlabel=names[0] if deep else names[1], ylabel=names[1] if deep else names[0], title=title)
    if deep:
        axes.invert_yaxis()
    axes.legend()
    held = io.BytesIO()
    figure.savefig(held, format="png", dpi=160)
    plt.close(figure)
    held.seek(0)
    return held
