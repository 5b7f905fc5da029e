"""Numbers behind each check of the wall where it is used most in every strake: for readers who follow it."""

from collections.abc import Mapping, Sequence

import numpy as np

from silostudy.buckling.family import BEHIND
from silostudy.checks.family import call
from silostudy.compute.checks_actions import of_contents, of_earthquake, of_wind
from silostudy.compute.checks_wall import WallActions
from silostudy.cube.variables import flags

FORCES = ("own_weight", "solid", "patch", "roof", "snow", "wind", "earthquake")


def strakes_behind(rules, rows, loads: WallActions, built: Mapping, by_rule: np.ndarray, by_check: np.ndarray) -> dict:
    """Utilisation, place, combination and BEHIND of every check in every strake, (followed_check, method, axes..., strake).

    by_rule: (rule, combination, method, ...), by_check: (check, combination, method, ...): the utilisations.
    """
    members, used = [*rules, *rows], [*by_rule, *by_check]
    numbers = [_numbers(row, built, loads.shape) for row in members]
    forces, shears = parts(loads)
    lists: dict[str, list] = {}
    for row, values in zip(numbers, used, strict=True):
        for name, value in _in_strakes(values, row, forces, shears, loads.source.places.strake).items():
            lists.setdefault(name, []).append(value)
    arrays = {name: np.array(value) for name, value in lists.items()}
    combination = (
        arrays.pop("followed_combination"),
        flags("in which combination", [acting.key for acting in loads.combinations]),
    )
    for name in ("followed_axial_force_part", "followed_shear_force_part"):
        arrays[name] = np.moveaxis(arrays[name], 1, 0)
    return {
        "followed_check": [row.key for row in members],
        "force_part": list(FORCES),
        "followed_combination": combination,
        **{name: value for name, value in arrays.items() if not (value.dtype.kind == "f" and np.isnan(value).all())},
    }


def _numbers(row, built: Mapping, shape) -> dict[str, np.ndarray]:
    """The numbers behind a check at every place; nothing for a row that names none."""
    if row.behind is None:
        return {}
    known = {**built, "shell_radius": built["inner_radius"] + built["thickness"] / 2}
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        values = call(row.behind, known)
    return {name: np.broadcast_to(values[name], shape) for name in BEHIND if name in values}


def _in_strakes(used: np.ndarray, numbers: Mapping, forces: np.ndarray, shears: np.ndarray, strake: np.ndarray) -> dict:
    """Everything at the place and in the combination of the largest utilisation, (..., method, axes..., strake)."""
    strakes = []
    for number in range(int(strake.max()) + 1):
        here = np.moveaxis(np.where(strake == number, used, np.nan), 0, -2)  # (method, axes..., combination, place)
        flat = here.reshape(*here.shape[:-2], -1)
        place = np.argmax(np.where(np.isnan(flat), -np.inf, flat), axis=-1)[..., None]

        def there(values, place=place):
            values = np.moveaxis(values, -used.ndim, -2)
            values = values.reshape(*values.shape[:-2], -1)
            index = np.broadcast_to(place, (*values.shape[:-1], 1))
            return np.take_along_axis(values, index, axis=-1)[..., 0]

        largest, count = there(np.where(strake == number, used, np.nan)), used.shape[-1]
        known = ~np.isnan(largest)
        strakes.append(
            {
                "followed_utilisation": largest,
                "followed_combination": np.where(known, place[..., 0] // count, 0).astype(np.int8),
                "followed_place": np.where(known, place[..., 0] % count + 1, 0),
                "followed_axial_force_part": np.where(known, there(forces), np.nan),
                "followed_shear_force_part": np.where(known, there(shears), np.nan),
                **{f"followed_{name}": np.where(known, there(numbers[name]), np.nan) if name in numbers else largest * np.nan
                   for name in BEHIND},
            }
        )  # fmt: skip
    return {name: np.stack([of_strake[name] for of_strake in strakes], axis=-1) for name in strakes[0]}


def parts(loads: WallActions) -> tuple[np.ndarray, np.ndarray]:
    """Axial force and shear (N/m) of the wall by each of FORCES with factors, (part, combination, method, axes..., place)."""
    source, place = loads.source, loads.source.places
    axial, shear = [], []
    for combination in loads.combinations:
        solid, wind, shaken = of_contents(combination, source), of_wind(combination, source), of_earthquake(combination, source)
        pushed = -shaken["force"] if combination.side == "lifted" else shaken["force"]
        roof, snow = combination.permanent * source.numbers["roof"], combination.snow * source.numbers["snow"]
        own = combination.permanent * place.own_weight
        axial.append(_like([own, solid["force"], solid["patch_force"], roof, snow, wind["force"], pushed], loads.shape[1:]))
        shear.append(
            _like([0.0, 0.0, solid["patch_shear"], 0.0, 0.0, wind["shear"], shaken["shear"]], loads.shape[1:])
        )  # fmt: skip
    return np.stack(axial, axis=1), np.stack(shear, axis=1)


def _like(values: Sequence, shape: tuple[int, ...]) -> np.ndarray:
    return np.array([np.broadcast_to(value, shape) for value in values])
