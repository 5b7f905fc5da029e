"""Changes of the effective mass of shaken spheres with each setting, means over fillings."""

from pathlib import Path

import xarray as xr

from silostudy.figures.ladders import AXES, draw_ladders

QUANTITIES = {
    "walls": "effective mass of wall",
    "contents_damping": "damping of contents",
    "ring_share": "ring of wall friction",
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    values = {
        "walls": cube["carried_in_phase"].sel(carrier="walls").transpose(*AXES).values,
        **{name: cube[name].transpose(*AXES).values for name in ("contents_damping", "ring_share")},
    }
    draw_ladders(cube, stem, values, QUANTITIES)
