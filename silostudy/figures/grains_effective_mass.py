"""Effective mass of shaken grains over the last axis: what walls and floor carry, and how much of the motion is lost."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.beside import span
from silostudy.figures.style import BLACK, WIDTH, foot, headline, save, series
from silostudy.tables.constants import STANDARD_GRAVITY

AXES = {
    "amplitude": ("amplitude of the base's acceleration (g)", 1 / STANDARD_GRAVITY),
    "frequency": ("frequency of the sine (Hz)", 1.0),
    "slenderness": ("nominal height of the fill over width", 1.0),
}
BOXES = {"disc": "Plane discs in a rigid box", "sphere": "Spheres in a rigid round silo with a flat floor"}
EIGHTY = 0.8  # sasaki_yoshimura_effective_mass, section 1: what ACI 313 and AIJ accept


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: mean and standard deviation over the fillings."""
    *outer, axis = cube.attrs["sweep_axes"].split()
    label, factor = AXES.get(axis, (axis.replace("_", " "), 1.0))
    groups = cube.stack(group=outer) if outer else cube.expand_dims("group")
    figure, (walls, whole, damping) = plt.subplots(1, 3, figsize=(WIDTH, 6.6))
    for number in range(groups.sizes["group"]):
        group = groups.isel(group=number)
        x = np.asarray(group[axis], dtype=float) * factor
        look = series(number) | {"capsize": 2, "linewidth": 1.5, "markersize": 5}
        _line(walls, x, group["carried_in_phase"].sel(carrier="walls"), _name(group, outer), look)
        _line(whole, x, group["carried_in_phase"].sel(carrier="all"), None, look)
        _line(damping, x, group["contents_damping"] * 100, None, look)
        walls.plot(x, group["ring_share"].mean("filling"), color="0.6", linewidth=0.9, marker=look["marker"], markersize=4,
                   markerfacecolor="none", label="ring that wall friction carries" if number == 0 else None)  # fmt: skip
    code = groups["grains_code_share"].mean("filling").isel(group=0)
    walls.plot(np.asarray(groups[axis], dtype=float) * factor, code, color="0.5", linewidth=3.0,
               label="EN 1998-4, its pressure summed (circular)")  # fmt: skip
    walls.axhline(EIGHTY, color=BLACK, linewidth=1, linestyle="--", label="80 % (ACI 313, AIJ)")
    _dress(walls, whole, damping, label)
    headline(figure, _message(cube))
    about = f"{BOXES[cube.attrs['shaken_body']]}; {_fillings(cube)}. Damping: where half or more moves with the box."
    foot(figure, f"{cube.attrs['title']}.", about, handles=walls.get_legend_handles_labels()[0])
    save(figure, _numbers(cube, axis), stem)


def _line(panel, x, values: xr.DataArray, label: str | None, look: dict) -> None:
    panel.errorbar(x, values.mean("filling"), values.std("filling", ddof=_lost(values)), label=label, **look)


def _lost(values: xr.DataArray | xr.Dataset) -> int:
    """Degrees of freedom that a standard deviation over the fillings loses: one, of a single filling none."""
    return min(1, values.sizes["filling"] - 1)


def _message(cube: xr.Dataset) -> str:
    """Message: the share of the contents that the walls carry, beside what EN 1998-4's pressure and the usual codes say."""
    carried = cube["carried_in_phase"].sel(carrier="walls").mean("filling")
    code = cube["grains_code_share"].mean("filling")
    low, high = (100 * float(value) for value in (carried.min(), carried.max()))
    told = f"Walls carry {low:.0f} to {high:.0f} % of the contents in phase"
    return f"{told}; codes say {100 * EIGHTY:.0f} %, EN 1998-4 {span(100 * float(code.min()), 100 * float(code.max()))} %"


def _name(group: xr.Dataset, outer: list[str]) -> str:
    return ", ".join(_setting(axis, group[axis].item()) for axis in outer) or f"{group.attrs['shaken_body']}s"


def _setting(axis: str, value: float | str) -> str:
    """A value of an outer axis in words; an amplitude as on an axis of its own, in g."""
    shown = f"{value * AXES[axis][1]:.2g} g" if axis == "amplitude" and not isinstance(value, str) else value
    return f"{axis} {shown}".replace("_", " ")


def _dress(walls, whole, damping, label: str) -> None:
    panels = {
        walls: ("share carried in phase", "walls"),
        whole: ("share carried in phase", "walls and floor"),
        damping: ("damping ratio of the contents (%)", "contents"),
    }
    for panel, (text, title) in panels.items():
        panel.set(xlabel=fill(label, 28), ylabel=text, title=title)
    for panel in (whole, damping):
        panel.axhline(1 if panel is whole else 0, color="black", linewidth=0.8)
    walls.set_ylim(bottom=min(0.0, walls.get_ylim()[0]))
    whole.set_ylim(min(0.9, whole.get_ylim()[0]), max(1.1, whole.get_ylim()[1]))


def _fillings(cube: xr.Dataset) -> str:
    grains = cube["disc_count"]
    text = f"{cube.sizes['filling']} fillings a point (bars: one standard deviation), "
    text += f"{int(grains.min())} to {int(grains.max())} {cube.attrs['shaken_body']}s"
    if float(cube["came_to_rest"].min()) < 1:
        speed = float(cube["start_speed"].max()) * 1e3
        text += f"; some fillings still rang at up to {speed:.2g} mm/s when the shaking began"
    return text


def _numbers(cube: xr.Dataset, axis: str) -> pd.DataFrame:
    carried = cube["carried_in_phase"]
    shares = {f"{carrier}_in_phase": carried.sel(carrier=carrier, drop=True) for carrier in ("walls", "floor", "all")}
    others = ["contents_damping", "ring_share", "grains_code_share", "settled_slenderness", "start_speed", "momentum_error"]
    table = xr.Dataset({**shares, **{name: cube[name] for name in others}}, coords={axis: cube[axis]}).drop_vars("case")
    parts = {"mean": table.mean("filling").to_dataframe(), "std": table.std("filling", ddof=_lost(cube)).to_dataframe()}
    return pd.concat(parts, names=["over"]).reset_index()
