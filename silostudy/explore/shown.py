"""Part of a cube that is shown: a quantity along one axis, a curve for each label of another, at a place on all others."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.catalogue import Family
from silostudy.checks import CHECKS
from silostudy.cube.contract import SCOPE
from silostudy.pressure import PRESSURE
from silostudy.tables.references import cite

# families of keys by the dimension that holds them
FAMILIES: Mapping[str, tuple[Family, ...]] = {"pressure_method": (PRESSURE,), "rule": (BUCKLING, RIVALS), "check": (CHECKS,)}
MOST_CURVES = 60  # longest axis whose labels can be curves
ELSEWHERE = "see the cube's references"


@dataclass(frozen=True)
class Selection:
    """A quantity along an axis; overlay: the axis whose labels are curves, empty for none; places: position on the others."""

    quantity: str
    along: str
    overlay: str
    labels: tuple[str, ...]
    places: Mapping[str, int]


def quantities(cube: xr.Dataset) -> dict[str, str]:
    """Name, meaning and unit -> name of each quantity with an axis and a value; those with a scope and many axes first."""
    names = [str(name) for name, variable in cube.data_vars.items() if variable.dtype.kind == "f" and _has_a_curve(variable)]
    ranked = sorted(names, key=lambda name: (name + SCOPE not in cube, -cube[name].ndim))
    return {f"{name}: {said(cube[name])}": name for name in ranked}


def _has_a_curve(variable: xr.DataArray) -> bool:
    return any(variable.sizes[dim] > 1 for dim in variable.dims) and bool(variable.notnull().any())


def said(variable: xr.DataArray) -> str:
    """Long name of a variable and its unit."""
    unit = str(variable.attrs.get("units", "1"))
    return f"{variable.attrs.get('long_name', variable.name)}{f' ({unit})' * (unit != '1')}"


def labels(cube: xr.Dataset, axis: str) -> list[str]:
    """Names of the places on an axis."""
    values = cube[axis].values  # places without labels of their own are numbered
    return [f"{value:.6g}" if values.dtype.kind == "f" else str(value) for value in values]


def overlays(cube: xr.Dataset, quantity: str, along: str) -> list[str]:
    """Axes whose labels may be curves, those of words first."""
    axes = [str(dim) for dim in cube[quantity].dims if dim != along and 1 < cube.sizes[dim] <= MOST_CURVES]
    return sorted(axes, key=lambda dim: cube[dim].dtype.kind in "iuf")


def usual_axis(cube: xr.Dataset, quantity: str) -> str:
    """The axis that a quantity is first shown along: depth where it has one, or its longest of numbers."""
    axes = [str(dim) for dim in cube[quantity].dims if cube.sizes[dim] > 1]
    return max(axes, key=lambda dim: (downward(cube, dim), cube[dim].dtype.kind in "iuf", cube.sizes[dim]))


def downward(cube: xr.Dataset, axis: str) -> bool:
    """Whether an axis counts depth."""
    return axis == "depth" or axis.endswith("_depth")


def usual_place(cube: xr.Dataset, quantity: str, axis: str) -> int:
    """The place on an axis at which a quantity has the most values that are not nil."""
    held = cube[quantity].notnull() & (cube[quantity] != 0.0)
    return int(np.argmax(held.sum([dim for dim in held.dims if dim != axis]).values))


def numbers(cube: xr.Dataset, choice: Selection) -> pd.DataFrame:
    """The numbers shown, a row a point of a curve: curve, place on the axis, value, scope and source."""
    variable = cube[choice.quantity]
    places = {dim: place for dim, place in choice.places.items() if dim in variable.dims}
    tables = [_curve(cube, choice, places, label) for label in (choice.labels if choice.overlay else ("",))]
    columns = ["curve", choice.along, choice.quantity, "scope", "source"]
    return pd.concat(tables, ignore_index=True) if tables else pd.DataFrame(columns=columns)


def _curve(cube: xr.Dataset, choice: Selection, places: Mapping[str, int], label: str) -> pd.DataFrame:
    position = dict(places)
    if choice.overlay:
        position[choice.overlay] = labels(cube, choice.overlay).index(label)
    part = cube.isel({dim: place for dim, place in position.items() if dim in cube.dims})
    table = {"curve": label or choice.quantity, choice.along: cube[choice.along].values}
    table[choice.quantity] = part[choice.quantity].values
    keys = {dim: str(cube[dim].values[position[dim]]) for dim in FAMILIES if dim in position}
    return pd.DataFrame(table | {"scope": _scope(part, choice), "source": "; ".join(sources(keys)) or ELSEWHERE})


def _scope(part: xr.Dataset, choice: Selection) -> np.ndarray | str:
    """Reason why a value is there or not, in the words of the cube."""
    flags = part.get(choice.quantity + SCOPE)
    if flags is None:
        return np.where(part[choice.quantity].isnull(), "no value", "in scope")
    meanings = np.array([word.replace("_", " ") for word in flags.attrs["flag_meanings"].split()])
    if choice.along not in flags.dims:
        return str(meanings[int(flags)])
    return meanings[flags.values]


def sources(keys: Mapping[str, str]) -> list[str]:
    """Source and place of the methods and rules that keys name, by the dimension of each."""
    rows = [family[key] for dim, key in keys.items() for family in FAMILIES[dim] if key in family]
    return [f"{cite(row.source)} {row.locator}" for row in rows]
