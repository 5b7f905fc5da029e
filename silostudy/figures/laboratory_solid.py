"""The row of a solid that a laboratory's tests give, in the columns of the solids table: a file that `materials` may name."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.cube.laboratory import MeasuredSolid
from silostudy.figures.style import save_table


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the row."""
    save_table(pd.DataFrame([MeasuredSolid.of(cube).row(cube)]), stem.with_suffix(".csv"))
