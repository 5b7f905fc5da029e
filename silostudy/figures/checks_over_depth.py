"""A steel wall under combinations of actions over its depth: axial force, utilisation and thickness needed, by every check."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from silostudy.cube.unchecked import unchecked
from silostudy.figures import rules
from silostudy.figures.steps import over_depth
from silostudy.figures.style import WIDTH, foot, headline, save, series, title

BAND: dict[str, Any] = {"linewidth": 9, "color": "0.83", "solid_capstyle": "butt", "zorder": 1}
UTILISATION = ("design_buckling_utilisation", "design_check_utilisation", "design_utilisation")
CHECKED = ("steel_check", "wall_friction_end", "place")
THICKNESS = ("design_buckling_thickness", "design_check_thickness", "design_thickness")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers for the first method, the worst of all combinations and ends of the wall friction."""
    method = str(cube["pressure_method"].values[0])
    wall = cube.sel(pressure_method=method)
    figure, panels = plt.subplots(1, 3, figsize=(WIDTH, 7.8), sharey=True, width_ratios=(1, 1.2, 1.2))
    _forces(panels[0], wall)
    _checks(panels[1], wall, UTILISATION, 1.0)
    panels[1].axvline(1, color="black", linewidth=0.8)
    _checks(panels[2], wall, THICKNESS, 1e3)
    built = wall.isel(wall_friction_end=0)
    depth = built["place_depth"].values
    over_depth(panels[2], built["place_thickness"].values * 1e3, depth, color="black", linewidth=2.2)
    labels = (
        "axial wall force\nwith its factors (kN/m)",
        "utilisation as built",
        "thickness (mm): needed by a wall\nof one thickness; as built (black)",
    )
    for panel, label in zip(panels, labels, strict=True):
        panel.set(xlabel=label)
    panels[0].set(ylabel="depth z (m)", ylim=(float(cube["place_depth"].max()), 0))
    panels[1].set_xlim(0, None)
    panels[2].set_xlim(0, None)
    panels[0].legend(title="combination", loc="upper right")
    headline(figure, _message(wall, depth))
    read = f"{title(cube, method)}; worst combination and end of the wall friction"
    band = f"wide grey band: the check that governs, with the rule {rules.name(cube, _first(cube))}"
    foot(figure, f"{cube.attrs['title']}; {read}; {band}", *_told(wall), handles=_handles(cube))
    save(figure, _numbers(wall), stem)


def _message(wall: xr.Dataset, depth: np.ndarray) -> str:
    """Message of the figure, in numbers: the largest utilisation with the first rule, its check and depth."""
    used, check = _governing(wall, UTILISATION[2], wall[UTILISATION[2]])
    place = int(np.nanargmax(used))
    words = check[place].replace("_", " ")
    rule = rules.name(wall, _first(wall))
    return f"With {rule} the wall is used up to {used[place]:.2f}, by {words} at a depth of {depth[place]:.1f} m"


def _told(wall: xr.Dataset) -> list[str]:
    """Words on the combinations, and on what the figure does not check and why."""
    names = (f"{key} {wall['combination_title'].sel(combination=key).values}" for key in _made(wall))
    return ["; ".join(names), *unchecked(wall)]


def _worst(values: xr.DataArray) -> xr.DataArray:
    """The largest over the ends of the wall friction, and over the combinations where they stand apart."""
    return values.max([dim for dim in ("combination", "wall_friction_end") if dim in values.dims])


def _made(wall: xr.Dataset) -> list[str]:
    """The combinations that the cube could compute."""
    made = (wall["design_check_utilisation_scope"] == 0).any([dim for dim in CHECKED if dim in wall.dims])
    return [str(key) for key in wall["combination"].values[made.values]]


def _force(wall: xr.Dataset, combination: str) -> np.ndarray:
    """Axial force (kN/m) of a combination at its worst end of the wall friction."""
    return wall["design_axial_wall_force"].sel(combination=combination).max("wall_friction_end").values / 1e3


def _forces(panel: Axes, wall: xr.Dataset) -> None:
    """Axial force of every combination that the cube could compute."""
    z, lines = wall["place_depth"].isel(wall_friction_end=0), ("-", "--", "-.", ":")
    for number, combination in enumerate(_made(wall)):
        line, width = lines[number % 4], 1 + number // 4
        label = combination
        panel.plot(_force(wall, combination), z, color="black", label=label, linestyle=line, linewidth=width)
    panel.axvline(0, color="black", linewidth=0.5)


def _checks(panel: Axes, wall: xr.Dataset, names: tuple[str, str, str], scale: float) -> None:
    """A line for every rule and every check, and a band where a check governs with the first rule."""
    z = wall["place_depth"].isel(wall_friction_end=0).values
    buckling, checked, largest = (wall[name] * scale for name in names)
    panel.plot(_governing(wall, names[2], largest)[0], z, **BAND)
    every = max(1, len(z) // 8)
    for rule in map(str, wall["rule"].values):
        values = _worst(buckling.sel({"rule": rule}))
        over_depth(panel, values.values, z, markevery=every, markersize=5, **rules.look(wall, rule))
    for number, check in enumerate(map(str, wall["steel_check"].values)):
        values = _worst(checked.sel(steel_check=check))
        if values.notnull().any():
            over_depth(panel, values.values, z, markevery=every, markersize=5, **series(number))


def _first(wall: xr.Dataset) -> str:
    return str(wall["rule"].values[0])


def _governing(wall: xr.Dataset, name: str, values: xr.DataArray) -> tuple[np.ndarray, list[str]]:
    """Largest number at every place and the check behind it with the first rule, over the ends of the wall friction."""
    here = values.isel(rule=0)
    flags, meanings = wall[f"{name}_check"].isel(rule=0), wall[f"{name}_check"].attrs["flag_meanings"].split()
    end = here.fillna(-np.inf).argmax("wall_friction_end")
    return here.isel(wall_friction_end=end).values, [meanings[flag] for flag in flags.isel(wall_friction_end=end).values]


def _handles(cube: xr.Dataset) -> list[Line2D]:
    """Entries of the legend: every rule, and every check."""
    checks = [check.replace("_", " ") for check in map(str, cube["steel_check"].values)]
    return [*rules.handles(cube, "buckling, "), *(Line2D([], [], label=words, **series(k)) for k, words in enumerate(checks))]


def _numbers(wall: xr.Dataset) -> pd.DataFrame:
    """Every place with force (kN/m), utilisation and thickness (mm) by combination and check, and what governs, by rule."""
    built, rows = wall.isel(wall_friction_end=0), []
    shared = {"place": wall["place"].values, "depth_m": built["place_depth"], "built_mm": built["place_thickness"] * 1e3}
    shared |= {f"force_{key}_kN_m": _force(wall, key) for key in _made(wall)}
    for rule in map(str, wall["rule"].values):
        table = {"rule": rule, **shared}
        for what, names, scale in (("utilisation", UTILISATION, 1.0), ("needed_mm", THICKNESS, 1e3)):
            table |= _by_check(wall.sel({"rule": [rule]}), what, names, scale)
        rows.append(pd.DataFrame(table))
    return pd.concat(rows, ignore_index=True)


def _by_check(wall: xr.Dataset, what: str, names: tuple[str, str, str], scale: float) -> dict:
    """A column for the largest number with what governs, for axial buckling, and for each check."""
    largest, check = _governing(wall, names[2], wall[names[2]])
    columns = {f"governing_{what}": largest * scale, f"{what}_governed_by": check}
    columns[f"buckling_{what}"] = _worst(wall[names[0]]).values[0] * scale
    for key in map(str, wall["steel_check"].values):
        columns[f"{key}_{what}"] = _worst(wall[names[1]].sel(steel_check=key)).values * scale
    return columns
