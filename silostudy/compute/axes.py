"""Coordinates of the sweep axes: SI numbers with their unit, or keys as text."""

from typing import Any

import numpy as np

from silostudy.config.study import Axis, BaseStudy
from silostudy.tables.units import split_unit


def axis_coordinates(study: BaseStudy) -> dict[str, tuple]:
    """xarray coordinates of every axis: one key gives the axis its values, several hang beside a plain count."""
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
