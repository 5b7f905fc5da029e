"""What must hold of a laboratory's tests, and whether it does: said too while it is written."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.cube.laboratory import checks
from silostudy.figures.style import save_table


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a line a check."""
    found = list(checks(cube))
    for one in found:
        print(f"check: {one}")
    columns = {"what": "check", "value": "value", "least": "least", "greatest": "greatest", "holds": "holds"}
    table = {column: [getattr(one, name) for one in found] for name, column in columns.items()}
    save_table(pd.DataFrame(table), stem.with_suffix(".csv"))
