"""Error against CPU time of the problems of the group shells."""

from pathlib import Path

import xarray as xr

from silostudy.figures.work_precision import draw_group


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its points."""
    draw_group(cube, "shells", stem)
