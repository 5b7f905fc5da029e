"""Look of buckling rules and of Miller's tests in every figure."""

import numpy as np
import xarray as xr
from matplotlib.lines import Line2D

from silostudy.cube.contract import SCOPE
from silostudy.errors import BadInput

KPA_PER_PSI = 6.894757293
NO_LOAD = "load_or_pressure_masked"
PSI = KPA_PER_PSI * 1e3
# group of tests -> (marker, filled, label); markers tell them apart without colour
GROUPS = {
    "unstiffened": ("o", "small, no rings"),
    "ringed": ("^", "small, rings"),
    "large": ("s", "large, rings"),
}


def look(cube: xr.Dataset, rule: str) -> dict:
    """Colour, line and marker of a rule, as line properties."""
    row = cube.sel({"rule": rule})
    drawn = {"color": row.rule_colour, "linestyle": row.rule_line, "marker": row.rule_marker}
    return {key: str(value.values) for key, value in drawn.items()}


def handles(cube: xr.Dataset, heading: str = "") -> list[Line2D]:
    """Entries of a legend for every rule; heading: what stands before their names."""
    return [Line2D([], [], label=heading + name(cube, rule), **look(cube, rule)) for rule in map(str, cube["rule"].values)]


def name(cube: xr.Dataset, rule: str) -> str:
    """Name of a rule for a legend."""
    return str(cube.sel({"rule": rule}).rule_title.values)


def limits(cube: xr.Dataset, rule: str) -> list[str]:
    """The limits of its range that mask a rule somewhere in a buckling cube, in words."""
    numbers = np.unique(cube["rule_limit_broken"].sel({"rule": rule}))
    return [str(cube["rule_limit"].values[number]) for number in numbers if number > 0]


def unjudged(cube: xr.Dataset, name: str) -> xr.DataArray:
    """Mask of places where a variable of the shell is masked though the wall is loaded: the rest does not speak for it."""
    flags = cube[name + SCOPE]
    return cube[name].isnull() & (flags != 0) & (flags != loadless(flags))


def worst(cube: xr.Dataset, name: str, dims: str | list[str]) -> xr.DataArray:
    """The largest over some dimensions; NaN where one of them is not judged, as the rest would look like a sound wall."""
    return cube[name].max(dims).where(~unjudged(cube, name).any(dims))


def loadless(flags: xr.DataArray) -> int:
    """The flag that says that a wall has no load, or an unknown one."""
    return flags.attrs["flag_meanings"].split().index(NO_LOAD)


def passed_over(cube: xr.Dataset, *names: str) -> list[str]:
    """Lines that say at how many depths, by rule, variables of the shell are masked in curves that have a load, and why."""
    lines: list[str] = []
    for name in names:
        level = str(cube[name].dims[-1])
        flags, meanings = cube[name + SCOPE], cube[name + SCOPE].attrs["flag_meanings"].split()
        loaded = (flags != loadless(flags)).any(level)
        counts = [(cube[name].isnull() & (flags == place) & loaded) for place in range(len(meanings))]
        for reason, masked in zip(meanings, counts, strict=True):
            counts_by_rule = masked.sum([dim for dim in masked.dims if dim != "rule"])
            told = [f"{title} {int(n)}" for title, n in zip(cube["rule_title"].values, counts_by_rule, strict=True) if n]
            if told:
                total = int(masked.size / cube.sizes["rule"])
                lines.append(
                    f"{name.replace('_', ' ')} masked ({reason.replace('_', ' ')}) at {', '.join(told)} of {total} depths"
                )
    return lines


def is_rival(cube: xr.Dataset, rule: str) -> bool:
    """Whether a name on the rule axis is a rival reading of a source rather than a rule."""
    return rule in cube.attrs["rival_readings"].split()


def group(cube: xr.Dataset) -> np.ndarray:
    """Group that each test belongs to: a key of GROUPS."""
    small = np.where(cube["ring_area"].values > 0, "ringed", "unstiffened")
    return np.where(cube["test_scale"].values == "large", "large", small)


def demand(cube: xr.Dataset, axis: str, values: tuple) -> None:
    """BadInput unless an axis of the study holds the values that a figure is drawn at."""
    missing = [value for value in values if value not in cube[axis].values]
    if missing:
        raise BadInput(f"axis {axis}", cube[axis].values.tolist(), f"the figure also needs {', '.join(map(str, missing))}")


def making(here: xr.Dataset) -> str:
    """Fabrication of the shells at one position of the making axis, in words."""
    told = (("making_manufacture", "{} (Miller)"), ("making_quality", "class {} (EN)"))
    words = [text.format(here[coord].values) for coord, text in told if coord in here.coords]
    return ", ".join(words).replace("_", " ") or f"making {here['making'].values}"
