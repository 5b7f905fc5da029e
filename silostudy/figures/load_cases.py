"""Load cases of each silo: which are computed, what they sum to, and why the others are not computed."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.cube.load import given_cases, of_case
from silostudy.figures.style import save_table

FORCES = ("wall_force", "hopper_force", "bottom_force", "horizontal_force")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a row for each load case, one for each of its sets where it has a field of its own."""
    silos = [None] if not cube.attrs["sweep_axes"] else list(map(str, cube["case"].values.ravel()))
    rows = [row for silo in silos for row in _rows(of_case(cube, silo), silo)]
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _rows(loads: xr.Dataset, silo: str | None) -> list[dict]:
    given, meanings = given_cases(loads), loads["load_case_state"].attrs["flag_meanings"].split()
    rows = []
    for key in map(str, loads["load_case"].values):
        here = loads.sel(load_case=key)
        about = {"case": silo or "", "load_case": key, "title": str(here["load_case_title"].values)}
        about |= {
            "state": meanings[int(here["load_case_state"])].replace("_", " "),
            "why": str(here["load_case_reason"].values),
        }
        rows += [about | _forces(here, values) for values in given.get(key, [])] or [about]
    return rows


def _forces(here: xr.Dataset, values: str) -> dict:
    """Sums of a field (kN, kN m), and their quotient by the weight (1)."""
    field = here.sel(value_set=values)
    row = {"values": values, "weight_kN": float(here["load_weight"]) / 1e3}
    row |= {f"{name}_kN": float(field[f"load_{name}"]) / 1e3 for name in FORCES}
    moment = float(field["load_overturning_moment"]) / 1e3
    return row | {"overturning_moment_kNm": moment, "imbalance": float(field["load_imbalance"])}
