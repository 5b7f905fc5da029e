"""Axes of a sweep in a cube, as SI numbers with their unit or keys as text, and the numbers of its cases in one."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from silostudy.config.study import Axis, BaseStudy
from silostudy.cube.assemble import Sweep
from silostudy.scene.expand import Expansion
from silostudy.tables.units import split_unit


def sweep_of(expansion: Expansion) -> Sweep:
    """The axes of a study and the ids of its cases."""
    cases = np.array([case.id for case in expansion.cases]).reshape(expansion.shape)
    return Sweep(axis_names(expansion.study), axis_coordinates(expansion.study), cases)


def stacked(cases: Sequence[Mapping[str, Any]], shape: tuple[int, ...]) -> dict[str, np.ndarray]:
    """The cases' numbers in one array a name, shape (axes..., own dimensions); shorter histories are filled up with NaN."""
    return {name: _in_one([np.asarray(case[name]) for case in cases], shape) for name in cases[0]}


def _in_one(arrays: list[np.ndarray], shape: tuple[int, ...]) -> np.ndarray:
    longest = tuple(np.max([array.shape for array in arrays], axis=0).astype(int))
    if any(array.shape != longest for array in arrays):
        gaps = [[(0, most - size) for most, size in zip(longest, array.shape, strict=True)] for array in arrays]
        arrays = [np.pad(array, gap, constant_values=np.nan) for array, gap in zip(arrays, gaps, strict=True)]
    return np.array(arrays).reshape((*shape, *longest))


def axis_names(study: BaseStudy) -> tuple[str, ...]:
    """Names of the sweep axes, which are dimensions of the cube."""
    return tuple(axis.axis for axis in study.sweep)


def axis_coordinates(study: BaseStudy) -> dict[str, tuple]:
    """Coordinates of every axis (xarray): one key gives the axis its values, several hang beside a plain count."""
    coords: dict[str, tuple] = {}
    for axis in study.sweep:
        columns = _columns(axis)
        if len(columns) == 1:
            ((key, values),) = columns.items()
            coords[axis.axis] = _coordinate(axis.axis, key, values)
        else:
            count = np.arange(len(axis.settings()))
            coords[axis.axis] = (axis.axis, count, {"long_name": f"position on {axis.axis}", "units": "1"})
            for key, values in columns.items():
                coords[f"{axis.axis}_{_short(key, columns)}"] = _coordinate(axis.axis, key, values)
    return coords


def _short(key: str, others: dict[str, Any]) -> str:
    """The last part of a dotted key without its unit; all of its parts where another key ends in the same."""
    last = key.split(".")[-1]
    whole = sum(other.split(".")[-1] == last for other in others) > 1
    return split_unit(key.replace(".", "_") if whole else last)[0]


def _columns(axis: Axis) -> dict[str, list[Any]]:
    settings = axis.settings()
    return {key: [setting[key] for setting in settings] for key in settings[0]}


def _coordinate(dim: str, key: str, values: list[Any]) -> tuple:
    _, unit, factor = split_unit(key)
    if all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in values):
        return dim, np.array(values, dtype=float) * factor, {"long_name": key, "units": unit}
    return dim, [str(value) for value in values], {"long_name": key}
