"""One silo's steel wall over its depth: force, pressure, stress and strength, utilisation; mean and upper friction."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from silostudy.figures import rules
from silostudy.figures.steps import over_depth
from silostudy.figures.style import WIDTH, foot, headline, look, name, save, title

READ = "dashed: mean wall friction; full: upper wall friction (more axial force, less pressure)"
ENDS = {"mean": {"linestyle": (0, (4, 2)), "linewidth": 1.0}, "upper": {"linestyle": "-", "linewidth": 1.7}}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers; stress, strength and utilisation are the first method's, at its worst phase."""
    rules.demand(cube, "wall_friction_end", tuple(ENDS))
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    first = str(cube["pressure_method"].values[0])
    figure, axes = plt.subplots(1, 4, figsize=(WIDTH, 6.8), sharey=True)
    for end, line in ENDS.items():
        here = cube.sel(wall_friction_end=end)
        _every_method(axes[:2], here, line)
        _every_rule(axes[2:], here.sel(pressure_method=first), line)
    _write_strakes(axes[0], cube)
    labels = ("axial wall force\n(kN/m)", "smallest guaranteed\nwall pressure (kPa)", "axial stress; buckling\nstress (MPa)")
    for panel, label in zip(axes, (*labels, "utilisation"), strict=True):
        panel.set(xlabel=label, xlim=(0, None))
    axes[3].axvline(1, color="black", linewidth=0.8)
    axes[0].set(ylabel="depth z (m)", ylim=(float(cube["depth"].max()), 0), title="every method,\nworst phase")
    axes[1].set_title("every method:\nsteadies the wall")
    axes[2].set_title(f"{title(cube, first)}: stress\n(black) and strength")
    axes[3].set_title(f"{title(cube, first)}, safety\nfactor included")
    headline(figure, _message(cube, level))
    methods = [Line2D([], [], label=title(cube, key), **look(cube, key)) for key in map(str, cube["pressure_method"].values)]
    masked = rules.passed_over(cube.sel(pressure_method=first), "utilisation")
    foot(figure, f"{cube.attrs['title']}; {READ}", *masked, handles=[*methods, *rules.handles(cube)])
    save(figure, _numbers(cube, level), stem)


def _message(cube: xr.Dataset, level: str) -> str:
    """Message of the figure, in numbers: the least and the largest utilisation that rules give by the first method."""
    used = rules.worst(cube.isel(pressure_method=0), "utilisation", ["phase", "wall_friction_end"])
    depth = float(cube["depth"].isel({level: int(used.max("rule").argmax(level))}))
    peaks = used.max(level).dropna("rule")
    peaks = peaks.sortby(peaks)
    ends = (f"{float(peak):.2f} by {rules.name(cube, str(peak['rule'].values))}" for peak in (peaks[0], peaks[-1]))
    by = name(cube, str(cube["pressure_method"].values[0]))
    return f"Under the pressures of {by} the wall is used up to {' to '.join(ends)}, there at {depth:.1f} m"


def _every_method(panels: Sequence[Axes], here: xr.Dataset, line: dict) -> None:
    """Force and pressure of every method over depth."""
    z = here["depth"].values
    for method in map(str, here["pressure_method"].values):
        shown = here.sel(pressure_method=method)
        style = {**look(here, method), "markevery": max(1, len(z) // 8), "markersize": 5, **line}
        over_depth(panels[0], shown["axial_wall_force"].max("phase").values / 1e3, z, **style)
        over_depth(panels[1], shown["lower_internal_pressure"].values / 1e3, z, **style)


def _every_rule(panels: Sequence[Axes], here: xr.Dataset, line: dict) -> None:
    """Stress, and strength and utilisation by every rule, over depth, with their steps from strake to strake."""
    z = here["depth"].values
    over_depth(panels[0], here["axial_wall_stress"].max("phase").values / 1e6, z, color="black", **line)
    for rule in map(str, here["rule"].values):
        judged = here.sel({"rule": rule})
        style = {**rules.look(here, rule), "markevery": max(1, len(z) // 8), "markersize": 5, **line}
        over_depth(panels[0], judged["wall_buckling_stress"].values / 1e6, z, **style)
        over_depth(panels[1], rules.worst(judged, "utilisation", "phase").values, z, **style)


def _write_strakes(panel: Axes, cube: xr.Dataset) -> None:
    """The thickness of each strake, at the right of a panel."""
    wall = cube["wall_thickness"].isel(wall_friction_end=0).to_dataframe().reset_index()
    for thickness, part in wall.groupby("wall_thickness", sort=False):
        place = (0.98, part.depth.min() + 0.03 * wall.depth.max())
        words: dict = {"xycoords": ("axes fraction", "data"), "ha": "right", "fontsize": "small"}
        panel.annotate(f"t = {thickness * 1e3:g} mm", place, **words)
        panel.axhline(part.depth.max(), color="black", linewidth=0.6, alpha=0.5)


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
