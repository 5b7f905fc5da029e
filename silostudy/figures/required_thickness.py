"""The wall thickness that each pressure method and buckling rule asks for: how far the choice of theory moves the steel."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures import rules
from silostudy.figures.style import WIDTH, foot, headline, look, save, title
from silostudy.tables.outputs import output_of

STAR = "* the method's friction would carry more than the contents weigh (wall friction times a design pressure)"
# the silo of the matrices; the nearest of the study is taken
DIAMETER = 10.0  # m
SLENDERNESS = 2.0  # H/D
# what the curves hold fixed in turn
(RULE,) = output_of(__name__).rules
(METHOD,) = output_of(__name__).methods


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers, all for the thickest strake (the largest over depth and phases), in mm."""
    rules.demand(cube, "wall_friction_end", ("mean", "upper"))
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    needed = rules.worst(cube, "required_thickness", level) * 1e3
    covered = needed.notnull().any([dim for dim in needed.dims if dim != "pressure_method"])
    speaking = {"pressure_method": np.flatnonzero(covered)}
    cube, needed = cube.isel(speaking), needed.isel(speaking)
    upper = needed.sel(wall_friction_end="upper")
    here = {"diameter": DIAMETER, "slenderness": SLENDERNESS}
    silo, place = upper.sel(here, method="nearest"), needed.sel(here, method="nearest")
    figure, axes = plt.subplot_mosaic("aa;bc;de", figsize=(WIDTH, 9.4), height_ratios=(1.3, 1, 1))
    change = ((place.sel(wall_friction_end="upper") / place.sel(wall_friction_end="mean") - 1) * 100).round()
    _matrix(axes["a"], silo, change, cube)
    panels = [axes["b"], axes["c"]], [axes["d"], axes["e"]]
    fixed = {"diameter": {"slenderness": SLENDERNESS}, "slenderness": {"diameter": DIAMETER}}
    for row, (axis, label) in zip(panels, (("diameter", "diameter D (m)"), ("slenderness", "H/D")), strict=True):
        _curves(row, upper.sel(fixed[axis], method="nearest"), cube, axis, label)
    by_method, by_rule = (float((upper.max(axis) / upper.min(axis)).median()) for axis in ("pressure_method", "rule"))
    headline(figure, f"The choice of pressure method moves the wall's thickness {by_method:.2f} times, that of buckling rule"
             f" {by_rule:.2f} times (largest over smallest, median of all silos)")  # fmt: skip
    foot(figure, f"{cube.attrs['title']}; {STAR}", *rules.passed_over(cube, "required_thickness"), handles=_legend(panels[0]))
    save(figure, pd.concat([_numbers(needed), _changes(change)], ignore_index=True), stem)


def _matrix(panel: Axes, silo: xr.DataArray, change: xr.DataArray, cube: xr.Dataset) -> None:
    """A matrix rule by method with its thicknesses (mm) written in, and what the upper wall friction makes of them (%)."""
    field, rise = (values.transpose("rule", "pressure_method") for values in (silo, change))
    panel.imshow(field, cmap="Greys", aspect="auto", vmin=0, vmax=2 * float(np.nanmax(field)))
    heavy = _beyond_weight(cube)
    for (i, j), value in np.ndenumerate(field.values):
        text = f"{value:.1f}{'*' * heavy[j]} ({rise.values[i, j] + 0.0:+g} %)" if np.isfinite(value) else "-"
        panel.text(j, i, text, ha="center", va="center", fontsize="small")
    methods = (fill(title(cube, str(method)), 14) for method in field["pressure_method"].values)
    panel.set_xticks(range(field.sizes["pressure_method"]), list(methods))
    panel.set_yticks(range(field.sizes["rule"]), [rules.name(cube, str(rule)) for rule in field["rule"].values])
    size = f"D {float(silo.diameter):g} m, H/D {float(silo.slenderness):g}"
    panel.set_title(f"thickness (mm), {size}, upper wall friction (in brackets: its change from mean friction)")
    panel.grid(False)


def _beyond_weight(cube: xr.Dataset) -> list[bool]:
    """Methods whose axial force at the matrix's silo exceeds the weight of the contents."""
    here = {"diameter": DIAMETER, "slenderness": SLENDERNESS}
    share = cube["carried_share"].sel(here, method="nearest").sel(wall_friction_end="upper").max("phase")
    return [bool(value > 1) for value in share.values]


def _curves(row, needed: xr.DataArray, cube: xr.Dataset, axis: str, label: str) -> None:
    """Draws, left, every method by one rule and, right, every rule by one method, over one axis."""
    left, right = row
    right.sharey(left)
    for method in map(str, needed["pressure_method"].values):
        values = needed.sel(pressure_method=method, rule=RULE)
        left.plot(needed[axis], values, linewidth=1.3, markersize=5, label=title(cube, method), **look(cube, method))
    for rule in map(str, needed["rule"].values):
        values = needed.sel(pressure_method=METHOD, rule=rule)
        shown = _ends(cube, rule) if values.isnull().any() else rules.name(cube, rule)
        right.plot(needed[axis], values, markersize=5, label=shown, **rules.look(cube, rule))
    fixed = f"H/D {float(needed.slenderness):g}" if axis == "diameter" else f"D {float(needed.diameter):g} m"
    for panel, heading in ((left, f"every method, {rules.name(cube, RULE)}"), (right, f"every rule, {title(cube, METHOD)}")):
        panel.set(xlabel=label, title=f"{heading},\n{fixed}", ylim=(0, None))
    left.set_ylabel("required thickness (mm)")


def _legend(row) -> list:
    """Entries of the legend: every method, and every rule."""
    return [handle for panel in row for handle in panel.get_legend_handles_labels()[0]]


def _ends(cube: xr.Dataset, rule: str) -> str:
    """A rule's name, and why its curve ends before the others where it gives nothing."""
    curve = cube.sel(rule=rule, pressure_method=METHOD, wall_friction_end="upper")
    flags = curve["required_thickness_scope"]
    missing = np.unique(flags.values[curve["required_thickness"].isnull().values])
    reasons = [flags.attrs["flag_meanings"].split()[flag].replace("_", " ") for flag in missing]
    return rules.name(cube, rule) + (f"; ends: {', '.join(reasons)}" if reasons else "")


def _changes(change: xr.DataArray) -> pd.DataFrame:
    """The matrix of changes (%) from mean to upper wall friction."""
    table = change.rename("change_percent").to_dataframe().reset_index()
    return table[["rule", "pressure_method", "diameter", "slenderness", "change_percent"]].dropna()


def _numbers(needed: xr.DataArray) -> pd.DataFrame:
    columns = ["rule", "pressure_method", "diameter", "slenderness", "wall_friction_end", "required_thickness_mm"]
    return needed.rename("required_thickness_mm").to_dataframe().reset_index()[columns].dropna()
