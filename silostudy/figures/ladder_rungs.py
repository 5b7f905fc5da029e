"""Ladders of settings of a scene of spheres: the first setting with those that differ from it in one thing."""

from dataclasses import dataclass

import xarray as xr


@dataclass(frozen=True)
class Ladder:
    """A varied setting: its title, unit and how many of them a value is; together: columns that go with it.

    end: which value is the finest, the least or the largest; neither: the others are held against the first setting.
    """

    title: str
    unit: str
    scale: float = 1.0
    end: str = ""
    together: tuple[str, ...] = ()


# by the column of the axis `setting` that is varied; coarser grains of equal mass are fewer: their number goes with their size
LADDERS = {
    "setting_step_factor": Ladder("time step", "of the chosen", end="least"),
    "setting_softened_modulus": Ladder("softened modulus", "MPa", 1e-6, "largest"),
    "setting_diameter": Ladder("size of grains", "mm", 1e3, "least", ("setting_count",)),
    "setting_mean": Ladder("size of grains", "mm", 1e3, "least", ("setting_deviation", "setting_least", "setting_largest")),
    "setting_spheres_restitution": Ladder("restitution", "", together=("setting_walls_restitution",)),
}


def rungs_of(cube: xr.Dataset, column: str) -> list[tuple[int, int]]:
    """Places of a ladder's rungs along the axis `setting`, by value, each with that of the rung it is held against."""
    names = [name for name in map(str, cube.coords) if name.startswith("setting_") and name != "setting_title"]
    free = {column, *LADDERS[column].together}
    fixed = [cube[name].values for name in names if name not in free]
    places = [k for k in range(cube.sizes["setting"]) if all(values[k] == values[0] for values in fixed)]
    worth = cube[column].values
    against = {"least": min, "largest": max}.get(LADDERS[column].end, lambda some, key: 0)(places, key=worth.__getitem__)
    return [(place, against) for place in sorted(places, key=worth.__getitem__)]


def rung_label(cube: xr.Dataset, column: str, place: int) -> str:
    """Value of a ladder's rung with its unit."""
    return f"{cube[column].values[place] * LADDERS[column].scale:.3g} {LADDERS[column].unit}".strip()


def setting_label(cube: xr.Dataset, place: int) -> str:
    """Names what a setting has other than the first one; of the first one all that is varied."""
    varied = [column for column in LADDERS if column in cube and len(set(cube[column].values.tolist())) > 1]
    own = [column for column in varied if not place or cube[column].values[place] != cube[column].values[0]]
    return ", ".join(f"{LADDERS[column].title} {rung_label(cube, column, place)}" for column in own)
