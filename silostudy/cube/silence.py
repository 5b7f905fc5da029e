"""Which methods of a cube give nothing, and why: for tables in the terminal and for figures."""

import numpy as np
import xarray as xr

from silostudy.cube.contract import SCOPE

PRESSURE = "wall_normal_pressure"


def silences(cube: xr.Dataset) -> list[str]:
    """A line for every method and phase that gives no wall pressure in some case, with the reasons."""
    cases = int(np.prod([cube.sizes[dim] for dim in cube[PRESSURE].dims if dim not in ("pressure_method", "phase", *DEPTHS)]))
    lines = []
    for method in map(str, cube["pressure_method"].values):
        one = cube.sel(pressure_method=method)
        covered = [phase for phase in map(str, cube["phase"].values) if _reasons(one, phase) != ["phase not covered"]]
        if not covered:
            lines.append(f"{method}: gives nothing: phase not covered")
        for phase in covered:
            silent = int(_silent(one, phase).sum())
            if silent:
                count = "" if cases == 1 else f" in {silent} of {cases} cases"
                lines.append(f"{method}, {phase}: gives nothing{count}: {'; '.join(_reasons(one, phase))}")
    return lines


DEPTHS = ("depth", "relative_depth")


def _silent(one: xr.Dataset, phase: str) -> xr.DataArray:
    pressure = one[PRESSURE].sel({"phase": phase})
    return pressure.isnull().all([dim for dim in DEPTHS if dim in pressure.dims])


def _reasons(one: xr.Dataset, phase: str) -> list[str]:
    """Why a method is silent in a phase, in words; the limits that are broken in place of their flag."""
    silent, flags = _silent(one, phase), one[PRESSURE + SCOPE]
    meanings = flags.attrs["flag_meanings"].split()
    here = flags.sel({"phase": phase}).where(silent)
    found = [meanings[int(flag)].replace("_", " ") for flag in np.unique(here.values[np.isfinite(here.values)])]
    if "limit_broken" not in one:
        return found
    numbers = one["limit_broken"].sel({"phase": phase}).where(silent)
    limits = [str(one["limit"].values[int(n)]) for n in np.unique(numbers.values[np.isfinite(numbers.values)]) if n > 0]
    return [reason for reason in found if not (limits and reason == "outside published range")] + [
        f"outside {words}" for words in limits
    ]
