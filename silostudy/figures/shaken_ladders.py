"""Changes of the effective mass of shaken spheres with each setting, means over fillings."""

from pathlib import Path

import xarray as xr

from silostudy.figures.ladders import AXES, draw_ladders

QUANTITIES = {"walls": "effective mass that the wall carries", "ring_share": "ring that wall friction carries"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    walls, ring = cube["carried_in_phase"].sel(carrier="walls"), cube["ring_share"]
    draw_ladders(cube, stem, {"walls": walls.transpose(*AXES).values, "ring_share": ring.transpose(*AXES).values}, QUANTITIES)
