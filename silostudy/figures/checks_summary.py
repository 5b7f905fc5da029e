"""Every part of a silo's steel under combinations of actions: utilisation, thickness, what governs, what is unchecked."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.contract import SCOPE
from silostudy.cube.unchecked import PARTS, unchecked, worst_combination
from silostudy.figures.style import save_table


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a row for each strake by rule, method and case, one for each check of the other parts, and what is not checked."""
    axes = cube.attrs["sweep_axes"].split()
    rows = [*_strakes(cube, axes), *_parts(cube, axes), *({"part": "not checked", "remark": line} for line in unchecked(cube))]
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _strakes(cube: xr.Dataset, axes: list[str]) -> Iterator[dict]:
    """A row for each strake: as built, needed, utilised, each with its governing check and combination."""
    names = ("design_strake_thickness", "design_strake_utilisation")
    for keys in _places(cube[names[0]], ("rule", "pressure_method", "strake", *axes)):
        wall = cube.sel(keys)
        needed, used = (_governed(wall, name) for name in names)
        here = wall["place_thickness"].values[wall["place_strake"].values == int(keys["strake"])]
        yield {
            "part": "strake",
            **keys,
            "thickness_mm": float(here[0]) * 1e3,
            "needed_mm": needed[0] * 1e3,
            "needed_governed_by": needed[1],
            "needed_in": needed[2],
            "utilisation": used[0],
            "governed_by": used[1],
            "in": used[2],
        }


def _governed(wall: xr.Dataset, name: str) -> tuple[float, str, str]:
    value = float(wall[name])
    words = [
        wall[f"{name}_{what}"].attrs["flag_meanings"].split()[int(wall[f"{name}_{what}"])] for what in ("check", "combination")
    ]
    return (value, words[0], words[1]) if np.isfinite(value) else (value, "masked", "")


def _parts(cube: xr.Dataset, axes: list[str]) -> Iterator[dict]:
    """A row for each check of hopper, ring, beam and anchors with the combination in which it is used most."""
    for axis, name in PARTS.items():
        if axis not in cube.dims or axis == "steel_check":
            continue
        for keys in _places(cube[name], (axis, "pressure_method", *axes)):
            wall, part = cube.sel(keys), axis.removesuffix("_check")
            used, where = worst_combination(wall[name], wall[name + SCOPE])
            if where:
                row = {"part": part, **keys, "governed_by": keys[axis], "utilisation": used}
                needed = wall.get(f"{part}_required_thickness")
                row |= {} if needed is None else {"needed_mm": float(needed.max()) * 1e3}
                row |= {"remark": where} if np.isnan(used) else {"in": where}
                yield {key: value for key, value in row.items() if key != axis}


def _places(values: xr.DataArray, dims: tuple[str, ...]) -> Iterator[dict]:
    for place in values.stack(row=list(dims))["row"].values if len(dims) > 1 else []:
        yield dict(zip(dims, place, strict=True))
