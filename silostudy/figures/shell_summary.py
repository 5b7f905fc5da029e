"""Largest utilisation of a steel wall: by rule, method, phase and wall friction, with what governs there."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.rules import loadless
from silostudy.figures.style import save_table


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a row for each rule, method, phase and case that loads the wall; without numbers where the rule gives none."""
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    axes = cube.attrs["sweep_axes"].split()
    loaded = (cube["utilisation_scope"] != loadless(cube["utilisation_scope"])).any(level)
    stacked = loaded.stack(row=["rule", "pressure_method", "phase", *axes])
    rows = []
    for place in stacked["row"].values[stacked.values]:
        keys = dict(zip(("rule", "pressure_method", "phase", *axes), place, strict=True))
        wall = cube.sel(keys)
        used = wall["utilisation"]
        worst = _worst(wall.isel({level: int(used.argmax(level))}), wall) if used.notnull().any() else {}
        rows.append({**keys, **worst, "masked_depths": int(used.isnull().sum()), "masked_why": _why(wall)})
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _worst(place: xr.Dataset, wall: xr.Dataset) -> dict:
    modes = str(wall["wall_buckling_mode"].attrs["flag_meanings"]).split()
    checks = str(wall["utilisation_check"].attrs["flag_meanings"]).split()
    sources = str(wall["axial_force_source"].attrs["flag_meanings"]).split()
    return {
        "utilisation": float(place["utilisation"]),
        "at_depth_m": float(place["depth"]),
        "thickness_mm": float(place["wall_thickness"]) * 1e3,
        "axial_stress_MPa": float(place["axial_wall_stress"]) / 1e6,
        "buckling_stress_MPa": float(place["wall_buckling_stress"]) / 1e6,
        "governed_by": checks[int(place["utilisation_check"])],
        "utilisation_at_strake_ends": float(wall["strake_utilisation"].max()),
        "mode": modes[int(place["wall_buckling_mode"])],
        "axial_force_from": sources[int(wall["axial_force_source"])],
        "carried_share": float(wall["carried_share"]),
        "uniform_thickness_needed_mm": float(wall["required_thickness"].max()) * 1e3,
    }


def _why(wall: xr.Dataset) -> str:
    """The reasons of the masked depths, in words."""
    flags = wall["utilisation_scope"]
    meanings = flags.attrs["flag_meanings"].split()
    return "; ".join(
        meanings[place].replace("_", " ") for place in np.unique(flags.where(wall["utilisation"].isnull(), 0)) if place
    )
