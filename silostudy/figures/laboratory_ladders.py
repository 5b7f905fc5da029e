"""Changes of a solid's properties with settings of its virtual laboratory and with narrower cells: means over fillings."""

from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.figures.ladders import AXES, draw_ladders

QUANTITIES = {
    "tested_lateral_pressure_ratio": "lateral pressure ratio",
    "internal_friction_angle": "internal friction angle",
    "wall_friction_angle": "wall friction angle",
    "tested_unit_weight": "unit weight",
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    *narrower, widest = cube["cell"].values
    last, others = cube.isel(cell=-1, normal_stress=-1), cube.isel(setting=0, cell=slice(-1), normal_stress=-1)
    values = {
        name: np.concatenate([_of(last, name).transpose(*AXES), _of(others, name).transpose("cell", "filling")])
        for name in QUANTITIES
    }
    draw_ladders(cube, stem, values, QUANTITIES, [f"cell {width:g} grains wide, not {widest:g}" for width in narrower])


def _of(tested: xr.Dataset, name: str) -> xr.DataArray:
    """A quantity by its name; an angle (rad) is that of a peak ratio of shear to normal stress."""
    if name in tested:
        return tested[name]
    return xr.apply_ufunc(np.arctan, tested[name.replace("friction_angle", "peak_shear_ratio")])
