"""Price of each effect of spheres and each optional part of their scenes: share of time, instructions and memory."""

from pathlib import Path

import xarray as xr

from silostudy.figures.effect_prices import draw_rooms

ROOMS = ("spheres", "scenes of spheres")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the price list of spheres."""
    draw_rooms(cube, stem, ROOMS)
