"""The wall thickness that each pressure method and buckling rule asks for: how far the choice of theory moves the steel."""

from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures import rules
from silostudy.figures.style import look, save, title
from silostudy.tables.outputs import output_of

DIAMETER, SLENDERNESS = 10.0, 2.0  # the silo of the matrices; the nearest of the study is taken
(RULE,), (METHOD,) = output_of(__name__).rules, output_of(__name__).methods  # what the curves hold fixed in turn


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers, all for the thickest strake (the largest over depth and phases), in mm."""
    rules.demand(cube, "wall_friction_end", ("mean", "upper"))
    level = "relative_depth" if "relative_depth" in cube.dims else "depth"
    needed = rules.worst(cube, "required_thickness", level) * 1e3
    covered = needed.notnull().any([dim for dim in needed.dims if dim != "pressure_method"])
    kept = {"pressure_method": np.flatnonzero(covered)}
    cube, needed = cube.isel(kept), needed.isel(kept)
    upper = needed.sel(wall_friction_end="upper")
    here = {"diameter": DIAMETER, "slenderness": SLENDERNESS}
    at, place = upper.sel(here, method="nearest"), needed.sel(here, method="nearest")
    figure = plt.figure(figsize=(14, 14))
    grid: Any = figure.subfigures(3, 1, height_ratios=(1.15, 1, 1))
    left, right = grid[0].subplots(1, 2, sharey=True)
    size = f"D {float(at.diameter):g} m, H/D {float(at.slenderness):g}"
    _matrix(left, at, cube, "{:.1f}", f"thickness (mm), {size}, wall friction at its upper end")
    change = ((place.sel(wall_friction_end="upper") / place.sel(wall_friction_end="mean") - 1) * 100).round()
    _matrix(right, change, cube, "{:+g}", "change of that thickness from mean to upper wall friction (%)")
    fixed = {"diameter": {"slenderness": SLENDERNESS}, "slenderness": {"diameter": DIAMETER}}
    for row, (axis, label) in zip(grid[1:], (("diameter", "diameter D (m)"), ("slenderness", "H/D")), strict=True):
        _curves(row, upper.sel(fixed[axis], method="nearest"), cube, axis, label)
    spread = float((upper.max("pressure_method") / upper.min("pressure_method")).median())
    head = [
        cube.attrs["title"],
        "* the method's friction would carry more than the contents weigh (wall friction times a design pressure)",
        f"largest over smallest method, median of all silos and rules: {spread:.2f}",
        *rules.passed_over(cube, "required_thickness"),
    ]
    figure.suptitle("\n".join(head))
    save(figure, pd.concat([_numbers(needed), _changes(change)], ignore_index=True), stem)


def _matrix(panel: Axes, values: xr.DataArray, cube: xr.Dataset, form: str, heading: str) -> None:
    """A matrix rule by method with its numbers written in."""
    field = values.transpose("rule", "pressure_method")
    panel.imshow(field, cmap="Greys", aspect="auto", vmin=0, vmax=2 * float(np.nanmax(field)))
    heavy = _beyond_weight(cube)
    for (i, j), value in np.ndenumerate(field.values):
        text = "-" if np.isnan(value) else form.format(value + 0.0) + ("*" if heavy[j] else "")
        panel.text(j, i, text, ha="center", va="center", fontsize=9)
    panel.set_xticks(
        range(field.sizes["pressure_method"]),
        [title(cube, str(m)) for m in field["pressure_method"].values],
        rotation=40,
        ha="right",
    )
    panel.set_yticks(range(field.sizes["rule"]), [rules.name(cube, str(r)) for r in field["rule"].values])
    panel.set_title(heading, fontsize=10)
    panel.grid(False)


def _beyond_weight(cube: xr.Dataset) -> list[bool]:
    """For each method whether its axial force at the matrix's silo exceeds the weight of the contents."""
    here = {"diameter": DIAMETER, "slenderness": SLENDERNESS}
    share = cube["carried_share"].sel(here, method="nearest").sel(wall_friction_end="upper").max("phase")
    return [bool(value > 1) for value in share.values]


def _curves(row, needed: xr.DataArray, cube: xr.Dataset, axis: str, label: str) -> None:
    """Left every method by one rule, right every rule by one method, over one axis."""
    left, right = row.subplots(1, 2, sharey=True)
    for method in map(str, needed["pressure_method"].values):
        values = needed.sel(pressure_method=method, rule=RULE)
        left.plot(needed[axis], values, linewidth=1.3, markersize=5, label=title(cube, method), **look(cube, method))
    for rule in map(str, needed["rule"].values):
        values = needed.sel(pressure_method=METHOD, rule=rule)
        marker = str(cube.sel({"rule": rule}).rule_marker.values)
        shown = _ends(cube, rule) if values.isnull().any() else rules.name(cube, rule)
        right.plot(needed[axis], values, marker=marker, markersize=5, label=shown, **rules.look(cube, rule))
    fixed = f"H/D {float(needed.slenderness):g}" if axis == "diameter" else f"D {float(needed.diameter):g} m"
    for panel, heading in ((left, f"every method, {rules.name(cube, RULE)}"), (right, f"every rule, {title(cube, METHOD)}")):
        panel.set(xlabel=label, title=f"{heading}, {fixed}", ylim=(0, None))
        panel.legend(fontsize=8)
    left.set_ylabel("required thickness (mm)")


def _ends(cube: xr.Dataset, rule: str) -> str:
    """A rule's name, and why its curve ends before the others where it gives nothing."""
    one = cube.sel(rule=rule, pressure_method=METHOD, wall_friction_end="upper")
    flags = one["required_thickness_scope"]
    missing = np.unique(flags.values[one["required_thickness"].isnull().values])
    reasons = [flags.attrs["flag_meanings"].split()[flag].replace("_", " ") for flag in missing]
    return rules.name(cube, rule) + (f"; ends: {', '.join(reasons)}" if reasons else "")


def _changes(change: xr.DataArray) -> pd.DataFrame:
    """The matrix of changes (%) from mean to upper wall friction."""
    table = change.rename("change_percent").to_dataframe().reset_index()
    return table[["rule", "pressure_method", "diameter", "slenderness", "change_percent"]].dropna()


def _numbers(needed: xr.DataArray) -> pd.DataFrame:
    keep = ["rule", "pressure_method", "diameter", "slenderness", "wall_friction_end", "required_thickness_mm"]
    return needed.rename("required_thickness_mm").to_dataframe().reset_index()[keep].dropna()
