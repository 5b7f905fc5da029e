"""Checks of a laboratory's tests, and whether they hold: said too while it is written."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.cube.laboratory import checks
from silostudy.figures.style import save_table


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a line a check."""
    made = list(checks(cube))
    for check in made:
        print(f"check: {check}")
    columns = {"what": "check", "value": "value", "least": "least", "greatest": "greatest", "holds": "holds"}
    table = {column: [getattr(check, name) for check in made] for name, column in columns.items()}
    save_table(pd.DataFrame(table), stem.with_suffix(".csv"))
