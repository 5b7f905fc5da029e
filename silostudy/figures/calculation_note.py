"""The calculation note of every silo of a study: HTML that any browser prints."""

from pathlib import Path

import xarray as xr

from silostudy.cube.silos import silos
from silostudy.files import replacing
from silostudy.note.page import page


def draw(cube: xr.Dataset, stem: Path, checks: xr.Dataset | None = None) -> None:
    """Writes STEM-CASE.html for every silo of a cube of pressures; checks: the cube of the checks, if there is one."""
    for case in silos(cube):
        path = stem.with_name(f"{stem.name}-{case}.html")
        with replacing(path) as temporary:
            temporary.write_text(page(cube, checks, case), encoding="utf-8")
