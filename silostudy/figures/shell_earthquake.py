"""A steel wall over its depth without (dashed) and with (full) an earthquake: force, pressure, and utilisation by rule."""

import textwrap
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.lines import Line2D

from silostudy.figures import rules
from silostudy.figures.style import look, save, title

WITHOUT = {"linestyle": (0, (4, 2)), "linewidth": 1.0}
WITH = {"linestyle": "-", "linewidth": 1.7}
NEEDED = "buckling rules: thickness that a wall of one thickness needs by {}, without and with the earthquake"
SIDES = {"pressed": "#B2182B", "lifted": "#2166AC"}
PRESSURES = {"pressed": ("upper_internal_pressure", "largest"), "lifted": ("lower_internal_pressure", "smallest guaranteed")}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers; pressures and utilisation are the first method's."""
    first = str(cube["pressure_method"].values[0])
    figure, panels = plt.subplots(1, 3, figsize=(14.5, 8.2), sharey=True, width_ratios=(1, 1, 1.25))
    _forces(panels[0], cube)
    _pressures(panels[1], cube.sel(pressure_method=first))
    _utilisations(panels[2], cube.sel(pressure_method=first))
    labels = ("axial wall force (kN/m)", "internal pressure (kPa)", "utilisation, safety factor included")
    for panel, label in zip(panels, labels, strict=True):
        panel.set(xlabel=label, xlim=(0, None))
    panels[0].set(ylabel="depth z (m)", ylim=(float(cube["depth"].max()), 0))
    panels[0].set_title("every method, worst phase, pressed side", fontsize=9)
    panels[1].set_title(f"{title(cube, first)}", fontsize=9)
    panels[2].set_title(f"{title(cube, first)}, worst phase and side", fontsize=9)
    methods = [Line2D([], [], label=title(cube, key), **look(cube, key)) for key in map(str, cube["pressure_method"].values)]
    figure.legend(handles=methods, loc="outside lower left", ncols=1, fontsize=8, title="pressure methods")
    needed = NEEDED.format(title(cube, first))
    figure.legend(handles=_rules(cube, first), loc="outside lower right", ncols=2, fontsize=8, title=needed)
    figure.suptitle("\n".join([_head(cube), *_masked(cube.sel(pressure_method=first))]), fontsize=10)
    save(figure, _numbers(cube), stem)


def _forces(panel, cube: xr.Dataset) -> None:
    z = cube["depth"].values
    for method in map(str, cube["pressure_method"].values):
        one, marks = cube.sel(pressure_method=method), {"markevery": max(1, len(z) // 8), "markersize": 5, **look(cube, method)}
        panel.plot(one["axial_wall_force"].max("phase") / 1e3, z, **marks, **WITHOUT)
        panel.plot(one["earthquake_axial_wall_force"].sel(side="pressed").max("phase") / 1e3, z, **marks, **WITH)


def _pressures(panel, one: xr.Dataset) -> None:
    """What steadies the wall (on the lifted side less) and what makes its foot yield (on the pressed side more)."""
    z = one["depth"].values
    for side, (name, text) in PRESSURES.items():
        dashes = {**WITHOUT, "linestyle": (4 if side == "pressed" else 0, (4, 4))}  # the two may coincide
        panel.plot(one[name] / 1e3, z, color=SIDES[side], **dashes, label=f"{text}, static")
        shaken = one[f"earthquake_{name}"].sel(side=side) / 1e3
        marker = {"marker": "^" if side == "pressed" else "v", "markevery": max(1, len(z) // 8), "markersize": 5}
        panel.plot(shaken, z, color=SIDES[side], **WITH, **marker, label=f"{text}, {side} side")
    panel.legend(loc="upper right", fontsize=8)


def _utilisations(panel, one: xr.Dataset) -> None:
    z = one["depth"].values
    for rule in map(str, one["rule"].values):
        here = one.sel({"rule": rule})
        marks = {"color": rules.look(one, rule)["color"], "marker": str(here["rule_marker"].values), "markersize": 5}
        marks["markevery"] = max(1, len(z) // 8)
        panel.plot(rules.worst(here, "utilisation", "phase"), z, **marks, **WITHOUT)
        panel.plot(rules.worst(here, "earthquake_utilisation", ["phase", "side"]), z, **marks, **WITH)
    panel.axvline(1, color="black", linewidth=0.8)


def _rules(cube: xr.Dataset, method: str) -> list[Line2D]:
    """Handles for every rule, with the thickness that a wall of one thickness needs without and with the earthquake."""
    handles, needed = [], _needed(cube.sel(pressure_method=method))
    for rule in map(str, cube["rule"].values):
        one = needed.sel({"rule": rule})
        static, shaken = ("masked" if np.isnan(one[key]) else f"{float(one[key]) * 1e3:.1f} mm" for key in ("static", "shaken"))
        label = f"{rules.name(cube, rule)}: {static}, {shaken}"
        marker = str(one["rule_marker"].values)
        handles.append(Line2D([], [], color=rules.look(cube, rule)["color"], marker=marker, label=label))
    return handles


def _needed(cube: xr.Dataset) -> xr.Dataset:
    """Thickness (m) that a wall of one thickness needs, static and with the earthquake; NaN where a depth is not judged."""
    static = rules.worst(cube, "required_thickness", "depth")
    shaken = rules.worst(cube, "earthquake_required_thickness", ["side", "depth"])
    return xr.Dataset({"static": static, "shaken": shaken.where(~(static > shaken), static)})


def _masked(one: xr.Dataset) -> list[str]:
    """At how many depths the shown curves and thicknesses are masked, and why."""
    names = ("required_thickness", "earthquake_required_thickness", "utilisation", "earthquake_utilisation")
    return [text for line in rules.passed_over(one, *names) for text in textwrap.wrap(line, 150)]


def _head(cube: xr.Dataset) -> str:
    told = cube.attrs
    end = {-1: " (lowest candidate)", 1: " (highest candidate)"}.get(told["earthquake_mass_coefficient_end"], "")
    moved = (
        f"C_eff = {told['earthquake_mass_coefficient']:.2f}{end}: base shear {told['earthquake_base_shear_N'] / 1e6:.2f} MN, "
    )
    moved += f"base moment {told['earthquake_base_moment_N_m'] / 1e6:.1f} MN m"
    base = "\n".join(textwrap.wrap(f"base: {told['earthquake_base_motion']}; {moved}", 150))
    return f"{told['title']} (dashed: static; full: with the earthquake)\n{base}\ncharacteristic values; no combination factors"


def _numbers(cube: xr.Dataset) -> pd.DataFrame:
    """Worst utilisation over the phases at every depth, static and on both sides, forces (N/m) and pressures (Pa) behind it.

    The thickness (mm) is for the whole wall.
    """
    shown = {"static": rules.worst(cube, "utilisation", "phase")}
    for side in map(str, cube["side"].values):
        shown[side] = rules.worst(cube.sel(side=side, drop=True), "earthquake_utilisation", "phase")
    shown["worst_side"] = rules.worst(cube, "earthquake_utilisation", ["phase", "side"])
    shown["axial_wall_force"] = cube["axial_wall_force"].max("phase")
    shown["earthquake_axial_wall_force"] = cube["earthquake_axial_wall_force"].sel(side="pressed", drop=True).max("phase")
    for side, (name, _) in PRESSURES.items():
        shown[name], shown[f"earthquake_{name}"] = cube[name], cube[f"earthquake_{name}"].sel(side=side, drop=True)
    needed = _needed(cube) * 1e3
    shown |= {"needed_static_mm": needed["static"], "needed_with_earthquake_mm": needed["shaken"]}
    table = xr.Dataset(shown).to_dataframe(dim_order=["rule", "pressure_method", "depth"]).reset_index()
    return table[["rule", "pressure_method", "depth", *shown]].dropna(subset=["static", "axial_wall_force"], how="all")
