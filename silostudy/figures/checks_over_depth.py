"""A steel wall under combinations of actions over its depth: axial force, utilisation and thickness needed, by every check."""

from pathlib import Path
from textwrap import fill
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from silostudy.cube.unchecked import unchecked
from silostudy.figures import rules
from silostudy.figures.style import save, title

COLOURS = ("#4477AA", "#228833", "#CCBB44", "#EE6677", "#AA3377", "#66CCEE", "#EE8866", "#777777")  # of checks, in order
BAND: dict[str, Any] = {"linewidth": 9, "alpha": 0.3, "solid_capstyle": "butt"}
UTILISATION = ("design_buckling_utilisation", "design_check_utilisation", "design_utilisation")
CHECKED = ("steel_check", "wall_friction_end", "place")
THICKNESS = ("design_buckling_thickness", "design_check_thickness", "design_thickness")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers for the first method, the worst of all combinations and ends of the wall friction."""
    method = str(cube["pressure_method"].values[0])
    one = cube.sel(pressure_method=method)
    figure, panels = plt.subplots(1, 3, figsize=(16, 9.2), sharey=True, width_ratios=(1, 1.2, 1.2))
    _forces(panels[0], one)
    _checks(panels[1], one, UTILISATION, 1.0)
    panels[1].axvline(1, color="black", linewidth=0.8)
    _checks(panels[2], one, THICKNESS, 1e3)
    wall = one.isel(wall_friction_end=0)
    panels[2].plot(wall["place_thickness"] * 1e3, wall["place_depth"], color="black", linewidth=2.2)
    labels = (
        "axial wall force with its factors (kN/m)",
        "utilisation as built",
        "thickness (mm): needed by a wall of one thickness; as built (black)",
    )
    for panel, label in zip(panels, labels, strict=True):
        panel.set(xlabel=label)
    panels[0].set(ylabel="depth z (m)", ylim=(float(cube["place_depth"].max()), 0))
    panels[1].set_xlim(0, None)
    panels[2].set_xlim(0, None)
    panels[0].legend(fontsize=8, title="combination", loc="upper right")
    heading = "checks; wide band: the check that governs, with the rule "
    figure.legend(handles=_handles(cube), loc="outside lower left", ncols=2, fontsize=8,
                  title=heading + rules.name(cube, str(cube["rule"].values[0])))  # fmt: skip
    told = [fill(line, 105) for line in unchecked(cube)]
    figure.legend(handles=[Line2D([], [], linestyle="", label=line) for line in told], loc="outside lower right", fontsize=7.5,
                  title="not checked", handlelength=0)  # fmt: skip
    figure.suptitle(f"{cube.attrs['title']}\n{title(cube, method)}; worst combination and end of the wall friction")
    save(figure, _numbers(one), stem)


def _worst(values: xr.DataArray) -> xr.DataArray:
    """The largest over the ends of the wall friction, and over the combinations where they stand apart."""
    return values.max([dim for dim in ("combination", "wall_friction_end") if dim in values.dims])


def _made(one: xr.Dataset) -> list[str]:
    """The combinations that the cube could compute."""
    made = (one["design_check_utilisation_scope"] == 0).any([dim for dim in CHECKED if dim in one.dims])
    return [str(key) for key in one["combination"].values[made.values]]


def _force(one: xr.Dataset, combination: str) -> np.ndarray:
    """Axial force (kN/m) of a combination at its worst end of the wall friction."""
    return one["design_axial_wall_force"].sel(combination=combination).max("wall_friction_end").values / 1e3


def _forces(panel: Axes, one: xr.Dataset) -> None:
    """Axial force of every combination that the cube could compute."""
    z, lines = one["place_depth"].isel(wall_friction_end=0), ("-", "--", "-.", ":")
    for number, combination in enumerate(_made(one)):
        line, width = lines[number % 4], 1 + number // 4
        label = f"{combination}  {one['combination_title'].sel(combination=combination).values}"
        panel.plot(_force(one, combination), z, color="black", label=label, linestyle=line, linewidth=width)
    panel.axvline(0, color="black", linewidth=0.5)


def _checks(panel: Axes, one: xr.Dataset, names: tuple[str, str, str], scale: float) -> None:
    """A line for every rule and every check, and a band where a check governs with the first rule."""
    z = one["place_depth"].isel(wall_friction_end=0).values
    buckling, checked, largest = (one[name] * scale for name in names)
    _band(panel, one, names[2], largest, z)
    for rule in map(str, one["rule"].values):
        marker = str(one.sel({"rule": rule}).rule_marker.values)
        values, every = _worst(buckling.sel({"rule": rule})), max(1, len(z) // 8)
        panel.plot(values, z, marker=marker, markevery=every, markersize=5, **rules.look(one, rule))
    for number, check in enumerate(map(str, one["steel_check"].values)):
        values = _worst(checked.sel(steel_check=check))
        if values.notnull().any():
            panel.plot(values, z, color=COLOURS[number % len(COLOURS)], linewidth=1.6)


def _band(panel: Axes, one: xr.Dataset, name: str, values: xr.DataArray, z: np.ndarray) -> None:
    governing, check = _governing(one, name, values)
    names = [str(key) for key in one["steel_check"].values]
    for k in range(len(z) - 1):
        colour = COLOURS[names.index(check[k]) % len(COLOURS)] if check[k] in names else rules.look(one, _first(one))["color"]
        panel.plot(governing[k : k + 2], z[k : k + 2], color=colour, **BAND)


def _first(one: xr.Dataset) -> str:
    return str(one["rule"].values[0])


def _governing(one: xr.Dataset, name: str, values: xr.DataArray) -> tuple[np.ndarray, list[str]]:
    """(largest number at every place, the check behind it) with the first rule, over the ends of the wall friction."""
    here = values.isel(rule=0)
    flags, meanings = one[f"{name}_check"].isel(rule=0), one[f"{name}_check"].attrs["flag_meanings"].split()
    end = here.fillna(-np.inf).argmax("wall_friction_end")
    return here.isel(wall_friction_end=end).values, [meanings[flag] for flag in flags.isel(wall_friction_end=end).values]


def _handles(cube: xr.Dataset) -> list[Line2D]:
    handles = [
        Line2D([], [], marker=str(marker), label=f"buckling, {rules.name(cube, rule)}", **rules.look(cube, rule))
        for rule, marker in zip(map(str, cube["rule"].values), cube["rule_marker"].values, strict=True)
    ]
    for number, check in enumerate(map(str, cube["steel_check"].values)):
        handles.append(Line2D([], [], color=COLOURS[number % len(COLOURS)], label=check.replace("_", " ")))
    return handles


def _numbers(one: xr.Dataset) -> pd.DataFrame:
    """Every place with force (kN/m), utilisation and thickness (mm) by combination and check, and what governs, by rule."""
    wall, rows = one.isel(wall_friction_end=0), []
    shared = {"place": one["place"].values, "depth_m": wall["place_depth"], "built_mm": wall["place_thickness"] * 1e3}
    shared |= {f"force_{key}_kN_m": _force(one, key) for key in _made(one)}
    for rule in map(str, one["rule"].values):
        found = {"rule": rule, **shared}
        for what, names, scale in (("utilisation", UTILISATION, 1.0), ("needed_mm", THICKNESS, 1e3)):
            found |= _by_check(one.sel({"rule": [rule]}), what, names, scale)
        rows.append(pd.DataFrame(found))
    return pd.concat(rows, ignore_index=True)


def _by_check(one: xr.Dataset, what: str, names: tuple[str, str, str], scale: float) -> dict:
    """A column for the largest number with what governs, for axial buckling, and for each check."""
    largest, check = _governing(one, names[2], one[names[2]])
    found = {f"governing_{what}": largest * scale, f"{what}_governed_by": check}
    found[f"buckling_{what}"] = _worst(one[names[0]]).values[0] * scale
    for key in map(str, one["steel_check"].values):
        found[f"{key}_{what}"] = _worst(one[names[1]].sel(steel_check=key)).values * scale
    return found
