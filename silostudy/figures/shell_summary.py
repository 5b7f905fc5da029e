"""Where a steel wall is used most: by rule, method, phase and wall friction, with what governs there."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.figures.style import save_table


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a row for each rule, method, phase and case that the method covers."""
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    axes = cube.attrs["sweep_axes"].split()
    stacked = cube["utilisation"].stack(row=["rule", "pressure_method", "phase", *axes]).dropna("row", how="all")
    rows = []
    for place in stacked["row"].values:
        keys = dict(zip(("rule", "pressure_method", "phase", *axes), place, strict=True))
        one = cube.sel(keys)
        rows.append({**keys, **_worst(one.isel({level: int(one["utilisation"].argmax(level))}), one)})
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
        "masked_depths": int(one["utilisation"].isnull().sum()),
        "axial_force_from": sources[int(one["axial_force_source"])],
        "carried_share": float(one["carried_share"]),
        "uniform_thickness_needed_mm": float(one["required_thickness"].max()) * 1e3,
    }
