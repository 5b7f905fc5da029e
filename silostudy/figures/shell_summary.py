"""Where a steel wall is used most: by rule, method, phase and wall friction, with what governs there."""

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
        one = cube.sel(keys)
        used = one["utilisation"]
        worst = _worst(one.isel({level: int(used.argmax(level))}), one) if used.notnull().any() else {}
        rows.append({**keys, **worst, "masked_depths": int(used.isnull().sum()), "masked_why": _why(one)})
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _worst(at: xr.Dataset, one: xr.Dataset) -> dict:
    modes = str(one["wall_buckling_mode"].attrs["flag_meanings"]).split()
    checks = str(one["utilisation_check"].attrs["flag_meanings"]).split()
    sources = str(one["axial_force_source"].attrs["flag_meanings"]).split()
    return {
        "utilisation": float(at["utilisation"]),
        "at_depth_m": float(at["depth"]),
        "thickness_mm": float(at["wall_thickness"]) * 1e3,
        "axial_stress_MPa": float(at["axial_wall_stress"]) / 1e6,
        "buckling_stress_MPa": float(at["wall_buckling_stress"]) / 1e6,
        "governed_by": checks[int(at["utilisation_check"])],
        "utilisation_at_strake_ends": float(one["strake_utilisation"].max()),
        "mode": modes[int(at["wall_buckling_mode"])],
        "axial_force_from": sources[int(one["axial_force_source"])],
        "carried_share": float(one["carried_share"]),
        "uniform_thickness_needed_mm": float(one["required_thickness"].max()) * 1e3,
    }


def _why(one: xr.Dataset) -> str:
    """The reasons of the masked depths, in words."""
    flags = one["utilisation_scope"]
    meanings = flags.attrs["flag_meanings"].split()
    return "; ".join(
        meanings[place].replace("_", " ") for place in np.unique(flags.where(one["utilisation"].isnull(), 0)) if place
    )
