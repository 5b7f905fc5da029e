"""One silo's steel wall over its depth: force, pressure, stress and strength, utilisation; mean and upper friction."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from silostudy.figures import rules
from silostudy.figures.style import look, save, title

ENDS = {"mean": {"linestyle": (0, (4, 2)), "linewidth": 1.0}, "upper": {"linestyle": "-", "linewidth": 1.7}}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers; stress, strength and utilisation are the first method's, at its worst phase."""
    rules.demand(cube, "wall_friction_end", tuple(ENDS))
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    first = str(cube["pressure_method"].values[0])
    figure, axes = plt.subplots(1, 4, figsize=(17, 8.4), sharey=True)
    for end, style in ENDS.items():
        here = cube.sel(wall_friction_end=end)
        z = here["depth"].values
        for method in map(str, cube["pressure_method"].values):
            one = here.sel(pressure_method=method)
            lines = {"color": look(cube, method)["color"], **style}
            marks = {"marker": look(cube, method)["marker"], "markevery": max(1, len(z) // 8), "markersize": 5}
            axes[0].plot(one["axial_wall_force"].max("phase") / 1e3, z, **lines, **marks)
            axes[1].plot(one["lower_internal_pressure"] / 1e3, z, **lines, **marks)
        stress = here["axial_wall_stress"].sel(pressure_method=first).max("phase")
        axes[2].plot(stress / 1e6, z, color="black", **style)
        for rule in map(str, cube["rule"].values):
            strength = here["wall_buckling_stress"].sel(pressure_method=first, rule=rule)
            used = rules.worst(here.sel(pressure_method=first, rule=rule), "utilisation", "phase")
            lines = {"color": rules.look(cube, rule)["color"], **style}
            marks = {
                "marker": str(cube.sel({"rule": rule}).rule_marker.values),
                "markevery": max(1, len(z) // 8),
                "markersize": 5,
            }
            axes[2].plot(strength / 1e6, z, **lines, **marks)
            axes[3].plot(used, z, **lines, **marks)
    _write_strakes(axes[0], cube)
    labels = ("axial wall force (kN/m)", "smallest guaranteed wall pressure (kPa)")
    for panel, label in zip(axes, (*labels, "axial stress; buckling stress (MPa)", "utilisation"), strict=True):
        panel.set(xlabel=label, xlim=(0, None))
    axes[3].axvline(1, color="black", linewidth=0.8)
    axes[0].set(ylabel="depth z (m)", ylim=(float(cube["depth"].max()), 0))
    axes[0].set_title("worst phase of every method", fontsize=9)
    axes[1].set_title("every method: steadies the wall", fontsize=9)
    axes[2].set_title(f"{title(cube, first)}: stress (black, no marks) and strength", fontsize=9)
    axes[3].set_title(f"{title(cube, first)}, safety factor included", fontsize=9)
    figure.legend(
        handles=_legend(cube, "pressure_method"), loc="outside lower left", ncols=3, fontsize=8, title="pressure methods"
    )
    figure.legend(handles=_legend(cube, "rule"), loc="outside lower right", ncols=3, fontsize=8, title="buckling rules")
    told = "dashed: mean wall friction; full: upper wall friction (more axial force, less pressure)"
    masked = rules.passed_over(cube.sel(pressure_method=first), "utilisation")
    figure.suptitle("\n".join([cube.attrs["title"], told, *masked]))
    save(figure, _numbers(cube, level), stem)


def _write_strakes(panel: Axes, cube: xr.Dataset) -> None:
    """The thickness of each strake, at the right of a panel."""
    wall = cube["wall_thickness"].isel(wall_friction_end=0).to_dataframe().reset_index()
    for thickness, part in wall.groupby("wall_thickness", sort=False):
        at = (0.98, part.depth.min() + 0.03 * wall.depth.max())
        panel.annotate(f"t = {thickness * 1e3:g} mm", at, xycoords=("axes fraction", "data"), ha="right", fontsize=8)
        panel.axhline(part.depth.max(), color="black", linewidth=0.6, alpha=0.5)


def _legend(cube: xr.Dataset, axis: str) -> list[Line2D]:
    """Handles for every method or every rule."""
    names = [str(key) for key in cube[axis].values]
    if axis == "pressure_method":
        return [Line2D([], [], label=title(cube, key), **look(cube, key)) for key in names]
    marks = [str(marker) for marker in cube["rule_marker"].values]
    return [
        Line2D([], [], color=rules.look(cube, key)["color"], marker=marker, label=rules.name(cube, key))
        for key, marker in zip(names, marks, strict=True)
    ]


def _numbers(cube: xr.Dataset, level: str) -> pd.DataFrame:
    names = [
        "axial_wall_force",
        "axial_wall_stress",
        "lower_internal_pressure",
        "wall_thickness",
        "wall_buckling_stress",
        "utilisation",
    ]
    table = cube[names].to_dataframe().reset_index().dropna(subset="utilisation")
    return table[["rule", "pressure_method", "phase", "wall_friction_end", level, *names]]
