"""Parts that figures of grains beside codes share: the settings of a cube, means over fillings with their interval."""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from scipy.stats import t as student

SURE = 0.95  # share of the intervals that hold the mean of all fillings
# verdicts on a method's pressure over the grains' peak
COVERS = "covers it"
MAY_COVER = "may cover it"
SHORT = "does not cover it"
NONE_HERE = "gives none here"
NO_INTERVAL = "no interval: fewer than two fillings have a value"


def settings(cube: xr.Dataset) -> Iterator[tuple[dict[str, Any], xr.Dataset]]:
    """Settings of the axes, by the title of the scene where they set one, each with the cube there."""
    axes = cube.attrs["sweep_axes"].split()
    for place in product(*(range(cube.sizes[axis]) for axis in axes)):
        silo = cube.isel(dict(zip(axes, place, strict=True)))
        yield {axis: silo.get(f"{axis}_title", silo[axis]).item() for axis in axes}, silo


def told(setting: dict[str, Any], case: xr.Dataset) -> str:
    """Settings of the axes of a cube's case, in words with their units."""
    return ", ".join(_worded(name, value, case) for name, value in setting.items()) or "the silo"


def _worded(name: str, value: Any, case: xr.Dataset) -> str:
    if isinstance(value, str):
        return value
    unit = case[name].attrs.get("units", "1")
    return f"{name.replace('_', ' ')} {value:.4g}{'' if unit == '1' else f' {unit}'}"


def interval(values: np.ndarray) -> tuple[float, float, float]:
    """Mean of fillings and the ends of its interval by Student's t; NaN ends of fewer than two."""
    values = values[np.isfinite(values)]
    if not len(values):
        return np.nan, np.nan, np.nan
    mean = float(values.mean())
    if len(values) < 2:
        return mean, np.nan, np.nan
    half = float(student.ppf(0.5 + SURE / 2, len(values) - 1) * values.std(ddof=1) / np.sqrt(len(values)))
    return mean, mean - half, mean + half


def row(values: xr.DataArray, **about: Any) -> dict[str, Any]:
    """A row of a table: what it is about, mean over the fillings, its interval, and how many fillings."""
    fillings = values.values.ravel()
    mean, low, high = interval(fillings)
    return {**about, "mean": mean, "low_95": low, "high_95": high, "fillings": int(np.isfinite(fillings).sum())}


def judged(values: xr.DataArray, **about: Any) -> dict[str, Any]:
    """A row of a method's load over the grains', with the verdict by its interval."""
    ratio = row(values, **about)
    return {**ratio, "verdict": verdict(ratio["low_95"], ratio["high_95"])}


def verdict(low: float, high: float) -> str:
    """A plain word for the ends of the interval of a method's pressure over the grains' peak."""
    if not np.isfinite([low, high]).all():
        return NO_INTERVAL
    if low >= 1.0:
        return COVERS
    return SHORT if high < 1.0 else MAY_COVER


def hopper_rise(silo: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Largest pressure around the hopper in flow over that at rest (1) of each filling, and how high on it that is (1)."""
    factor = silo["hopper_switch_factor"]
    place = silo["hopper_level_position"].isel(wall_level=factor.fillna(-1.0).argmax("wall_level"))
    most = factor.max("wall_level")
    return most, (1.0 - place).where(most.notnull())


def methods_of(silo: xr.Dataset, phase: str) -> list[str]:
    """Methods that say anything of the wall in a phase."""
    given = silo["code_wall_pressure"].sel(phase=phase).notnull().any("wall_level")
    return [str(method) for method in silo["pressure_method"].values[given.values]]


def columns_of(count: int) -> int:
    """Columns of so many panels: a row of up to three, two rows of more."""
    return min(count, 3) if count < 4 else -(-count // 2)


def span(low: float, high: float, digits: int = 2) -> str:
    """Two numbers as a range in words, one where they are told alike."""
    least, most = (f"{value:.{digits}g}" for value in (low, high))
    return least if least == most else f"{least} to {most}"


def profile(pressure: xr.DataArray, depth: xr.DataArray, **about: Any) -> pd.DataFrame:
    """Mean over the fillings of a profile, its least and largest, by the mean depth of each level (m)."""
    return pd.DataFrame({
        **about, "depth_m": depth.mean("filling").values, "pressure_Pa": pressure.mean("filling").values,
        "least_Pa": pressure.min("filling").values, "largest_Pa": pressure.max("filling").values,
    }).dropna(subset=["depth_m", "pressure_Pa"])  # fmt: skip
