"""Changes of a solid's properties with each setting of its virtual laboratory, means over fillings of the last cell."""

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
    last = cube.isel(cell=-1, normal_stress=-1)
    angles = {f"{name}_friction_angle": np.arctan(last[f"{name}_peak_shear_ratio"]) for name in ("internal", "wall")}
    values = {name: last.assign(angles)[name].transpose(*AXES).values for name in QUANTITIES}
    draw_ladders(cube, stem, values, QUANTITIES)
