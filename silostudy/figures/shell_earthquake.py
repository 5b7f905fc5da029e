"""A steel wall over its depth without (dashed) and with (full) an earthquake: force, pressure, and utilisation by rule."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.lines import Line2D

from silostudy.figures import rules
from silostudy.figures.steps import over_depth
from silostudy.figures.style import BLUE, VERMILION, WIDTH, foot, headline, look, save, title

WITHOUT = {"linestyle": (0, (4, 2)), "linewidth": 1.0}
WITH = {"linestyle": "-", "linewidth": 1.7}
NEEDED = "beside the buckling rules: thickness that a wall of one thickness needs by {}, without and with the earthquake"
SIDES = {"pressed": VERMILION, "lifted": BLUE}
PRESSURES = {"pressed": ("upper_internal_pressure", "largest"), "lifted": ("lower_internal_pressure", "smallest guaranteed")}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers; pressures and utilisation are the first method's."""
    first = str(cube["pressure_method"].values[0])
    figure, panels = plt.subplots(1, 3, figsize=(WIDTH, 7.4), sharey=True, width_ratios=(1, 1, 1.25))
    _forces(panels[0], cube)
    _pressures(panels[1], cube.sel(pressure_method=first))
    _utilisations(panels[2], cube.sel(pressure_method=first))
    labels = ("axial wall force (kN/m)", "internal pressure (kPa)", "utilisation,\nsafety factor included")
    for panel, label in zip(panels, labels, strict=True):
        panel.set(xlabel=label, xlim=(0, None))
    panels[0].set(ylabel="depth z (m)", ylim=(float(cube["depth"].max()), 0))
    panels[0].set_title("every method, worst\nphase, pressed side")
    panels[1].set_title(title(cube, first))
    panels[2].set_title(f"{title(cube, first)},\nworst phase and side")
    methods = [Line2D([], [], label=title(cube, key), **look(cube, key)) for key in map(str, cube["pressure_method"].values)]
    headline(figure, _message(cube.sel(pressure_method=first)))
    told = [*_told(cube), *_masked(cube.sel(pressure_method=first)), NEEDED.format(title(cube, first))]
    foot(figure, *told, handles=[*methods, *panels[1].get_legend_handles_labels()[0], *_rules(cube, first)])
    save(figure, _numbers(cube), stem)


def _forces(panel, cube: xr.Dataset) -> None:
    z = cube["depth"].values
    for method in map(str, cube["pressure_method"].values):
        shown, marks = cube.sel(pressure_method=method), {**look(cube, method), "markevery": max(1, len(z) // 8)}
        panel.plot(shown["axial_wall_force"].max("phase") / 1e3, z, **marks, **WITHOUT)
        panel.plot(shown["earthquake_axial_wall_force"].sel(side="pressed").max("phase") / 1e3, z, **marks, **WITH)


def _pressures(panel, shown: xr.Dataset) -> None:
    """Draws the pressures that steady the wall (less if lifted) and that make its foot yield (more if pressed)."""
    z = shown["depth"].values
    for side, (name, text) in PRESSURES.items():
        dashes = {**WITHOUT, "linestyle": (0, (4, 4)) if side == "pressed" else (4, (1, 2, 1, 4))}  # the two may coincide
        panel.plot(shown[name] / 1e3, z, color=SIDES[side], **dashes, label=f"{text} pressure, static")
        shaken = shown[f"earthquake_{name}"].sel(side=side) / 1e3
        marker = {"marker": "^" if side == "pressed" else "v", "markevery": max(1, len(z) // 8), "markersize": 5}
        panel.plot(shaken, z, color=SIDES[side], **WITH, **marker, label=f"{text} pressure, {side} side")


def _utilisations(panel, shown: xr.Dataset) -> None:
    z = shown["depth"].values
    for rule in map(str, shown["rule"].values):
        here, marks = shown.sel({"rule": rule}), {**rules.look(shown, rule), "markevery": max(1, len(z) // 8)}
        over_depth(panel, rules.worst(here, "utilisation", "phase").values, z, **marks | WITHOUT)
        over_depth(panel, rules.worst(here, "earthquake_utilisation", ["phase", "side"]).values, z, **marks | WITH)
    panel.axvline(1, color="black", linewidth=0.8)


def _rules(cube: xr.Dataset, method: str) -> list[Line2D]:
    """Handles for every rule, with the thickness that a wall of one thickness needs without and with the earthquake."""
    handles, needed = [], _needed(cube.sel(pressure_method=method))
    for rule in map(str, cube["rule"].values):
        own = needed.sel({"rule": rule})
        static, shaken = ("masked" if np.isnan(own[key]) else f"{float(own[key]) * 1e3:.1f} mm" for key in ("static", "shaken"))
        label = f"{rules.name(cube, rule)}: {static}, {shaken}"
        handles.append(Line2D([], [], **rules.look(cube, rule) | WITH, label=label))
    return handles


def _needed(cube: xr.Dataset) -> xr.Dataset:
    """Thickness (m) that a wall of one thickness needs, static and with the earthquake; NaN where a depth is not judged."""
    static = rules.worst(cube, "required_thickness", "depth")
    shaken = rules.worst(cube, "earthquake_required_thickness", ["side", "depth"])
    return xr.Dataset({"static": static, "shaken": shaken.where(~(static > shaken), static)})


def _masked(shown: xr.Dataset) -> list[str]:
    """Number of depths at which the shown curves and thicknesses are masked, and why."""
    names = ("required_thickness", "earthquake_required_thickness", "utilisation", "earthquake_utilisation")
    return rules.passed_over(shown, *names)


def _message(shown: xr.Dataset) -> str:
    """Message of the figure, in numbers: the utilisation by the rule that the earthquake drives highest."""
    shaken = rules.worst(shown, "earthquake_utilisation", ["phase", "side"]).max("depth")
    worst = str(shaken.idxmax("rule").values)
    static = float(rules.worst(shown, "utilisation", "phase").max("depth").sel(rule=worst))
    rise = f"from {static:.2f} to {float(shaken.max()):.2f}"
    return f"The earthquake raises the largest utilisation of the wall {rise} by {rules.name(shown, worst)}"


def _told(cube: xr.Dataset) -> list[str]:
    """Words on the silo and the shaking, and on how the lines are to be read."""
    told = cube.attrs
    end = {-1: " (lowest candidate)", 1: " (highest candidate)"}.get(told["earthquake_mass_coefficient_end"], "")
    shear, moment = told["earthquake_base_shear_N"] / 1e6, told["earthquake_base_moment_N_m"] / 1e6
    moved = f"C_eff = {told['earthquake_mass_coefficient']:.2f}{end}: base shear {shear:.2f} MN, base moment {moment:.1f} MN m"
    read = "dashed: static; full: with the earthquake; characteristic values; no combination factors"
    return [f"{told['title']}; {read}", f"base: {told['earthquake_base_motion']}; {moved}"]


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
