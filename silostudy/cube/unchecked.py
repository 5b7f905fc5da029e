"""Checks of a cube that were not made, in which combinations, and why: for tables in the terminal and for figures."""

import numpy as np
import xarray as xr

from silostudy.cube.contract import SCOPE

PARTS = {"steel_check": "design_check_utilisation", "hopper_check": "hopper_check_utilisation",
         "support_check": "support_check_utilisation"}  # fmt: skip
IDLE = "not_in_this_combination"
NO_LOAD = "load_or_pressure_masked"


def unchecked(cube: xr.Dataset) -> list[str]:
    """A line for every reason: the checks and the combinations in which no place of the silo was looked at for it."""
    checks_by_reason: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    count = 0
    for axis, name in PARTS.items():
        if name not in cube:
            continue
        for check in map(str, cube[axis].values):
            count += 1
            for why, combinations in _reasons(cube[name + SCOPE].sel({axis: check})).items():
                checks_by_reason.setdefault((why, tuple(combinations)), []).append(check)
    lines = [
        f"{'every check' if len(checks) == count else ', '.join(checks)}: not checked in {', '.join(combinations)}: {why}"
        for (why, combinations), checks in checks_by_reason.items()
    ]
    absent = [] if "hopper_check" in cube else ["hopper's wall: not checked: no hopper, or no hopper_position"]
    left_out = cube.attrs["one_source_left_out"]
    told = [f"{left_out}: not checked: one source alone, and not named in checks.one_source"] if left_out else []
    if uneven := cube.attrs["uneven_methods"]:
        told.append(f"{uneven}: not checked: pressures differ round the wall; what they sum to stands in the pressure cube")
    if without := cube.attrs["not_given"]:
        told.append(f"not given, so in no combination: {without}")
    return [*lines, *absent, *told]


def worst_combination(values: xr.DataArray, scope: xr.DataArray) -> tuple[float, str]:
    """Largest utilisation (1) of a check and its combination; NaN and the reason where no place has one.

    NaN and nothing where no combination makes the check.
    """
    others = [dim for dim in values.dims if dim != "combination"]
    unloaded = (scope == scope.attrs["flag_meanings"].split().index(NO_LOAD)).all(others)
    if unloaded.any():
        return np.nan, f"no load of this method in {', '.join(map(str, scope['combination'].values[unloaded.values]))}"
    if values.isnull().all():
        return np.nan, ""
    most = values.max(others)
    return float(most.max()), str(most["combination"].values[int(np.nanargmax(most.values))])


def _reasons(scope: xr.DataArray) -> dict[str, list[str]]:
    """Reason in words -> the combinations in which it keeps the check from being made anywhere."""
    meanings = scope.attrs["flag_meanings"].split()
    reasons: dict[str, list[str]] = {}
    for combination in map(str, scope["combination"].values):
        flags = scope.sel(combination=combination).values
        if flags.size and (flags > 0).all():
            counts = np.bincount(flags.ravel())
            reasons.setdefault(_words(meanings[int(counts.argmax())]), []).append(combination)
    idle = reasons.pop(_words(IDLE), [])
    return reasons if reasons or len(idle) < scope.sizes["combination"] else {"no combination has what it is for": idle}


def _words(meaning: str) -> str:
    return (
        meaning.replace("needs_", "needs ").replace("_and_", " and ")
        if meaning.startswith("needs_")
        else meaning.replace("_", " ")
    )
