"""One silo to scale with its wall pressures drawn off the wall: normal pressure on the right, wall friction on the left.

A row for each method with a hopper, a column for each load case.  The switch is shown half-way up the hopper: flow field
below, initial field above, the ring force between them.
"""

from pathlib import Path
from textwrap import fill
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.cube.silence import reason
from silostudy.figures.style import AID, save, title

SIDES = {
    "normal": (1, "wall_normal_pressure", "hopper_normal_pressure"),
    "friction": (-1, "wall_friction_traction", "hopper_friction_traction"),
}
HATCHES = {"normal": "////", "friction": "...."}
COLOURS = {"normal": "#B2182B", "friction": "#2166AC"}
SAVED = ("side", "depth_m", "wall_radius_m", "pressure_kPa", "from_axis_m", "tip_from_axis_m", "tip_depth_m")
STAR, SETS = "*", "pressure, friction and load each by their own set of characteristic values: no single state of the silo"
WIDEST = 0.75  # diameters that the largest pressure reaches out


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the pressures it shows."""
    methods = [
        m for m in map(str, cube["pressure_method"].values) if cube["hopper_balance"].sel(pressure_method=m).notnull().any()
    ]
    phases = [phase for phase in ("filling", "switch", "discharge") if phase in cube["phase"].values]
    given = {(method, phase): state(cube, method, phase) for method in methods for phase in phases}
    states = {where: found for where, found in given.items() if found is not None}
    largest = max(float(table.pressure_kPa.max()) for table in states.values())
    states = {where: off_the_wall(table, cube, largest) for where, table in states.items()}
    figure, panels = plt.subplots(
        len(methods), len(phases), figsize=(4.3 * len(phases), 6.6 * len(methods)), squeeze=False, sharex=True, sharey=True
    )
    for row, method in zip(panels, methods, strict=True):
        for panel, phase in zip(row, phases, strict=True):
            panel.set_title(f"{title(cube, method)}{STAR * of_sets(cube, method)}: {phase}", fontsize=9)
            panel.set_aspect("equal")
            _silo(panel, cube)
            if (method, phase) in states:
                _pressures(panel, states[method, phase])
                _forces(panel, cube, method, phase)
            else:
                panel.text(0, float(cube["cylinder_depth"]) / 2, _why_not(cube, method, phase), ha="center", va="center")
            panel.tick_params(labelbottom=True)
    _frame(panels, cube, largest)
    several = any(of_sets(cube, method) for method in methods)
    figure.suptitle(cube.attrs["title"] + f"\n{STAR} {SETS}" * several)
    numbers = pd.concat([t.assign(pressure_method=m, phase=p) for (m, p), t in states.items()], ignore_index=True)
    save(figure, numbers[["pressure_method", "phase", *SAVED]], stem)


def of_sets(cube: xr.Dataset, method: str) -> bool:
    """Whether a method reckons its quantities with different characteristic values: what is drawn does not act at once."""
    values = str(cube["pressure_method_values"].sel(pressure_method=method).values)
    return len([text for text in values.split("; ") if not text.startswith("every quantity")]) > 1


def _why_not(cube: xr.Dataset, method: str, phase: str) -> str:
    """What stands in a panel without pressures."""
    name = "switch_force" if phase == "switch" else "wall_normal_pressure"
    return "not given:\n" + fill(reason(cube, name, method, phase), 20)


def diameter(cube: xr.Dataset) -> float:
    """Width (m) of the cylinder, from the hopper's height and angle."""
    return 2 * float(cube["hopper_height"]) * np.tan(float(cube["hopper_half_angle"]))


def wall(cube: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """(depth, radius) (m) of the places on the hopper wall."""
    radius = diameter(cube) / 2
    outlet = float(cube["outlet_width"]) / 2
    at = radius - cube["hopper_position"].values * (radius - outlet)
    return float(cube["cylinder_depth"]) + (radius - at) / np.tan(float(cube["hopper_half_angle"])), at


def state(cube: xr.Dataset, method: str, phase: str) -> pd.DataFrame | None:
    """Pressures (kPa) along the whole wall in a load case, both sides; None where the method does not treat it."""
    tables = []
    if phase == "switch" and cube["switch_force"].sel(pressure_method=method).isnull().all():
        return None
    for side, (_, on_cylinder, on_hopper) in SIDES.items():
        lower = _hopper(cube[on_hopper].sel(pressure_method=method), phase)
        upper = cube[on_cylinder].sel(pressure_method=method, phase=phase).values
        if np.isnan(upper).all():
            return None
        depth, radius = wall(cube)
        table = {
            "side": side,
            "part": ["cylinder"] * upper.size + ["hopper"] * lower.size,
            "depth_m": np.concatenate([cube["depth"].values, depth]),
            "wall_radius_m": np.concatenate([np.full(upper.size, diameter(cube) / 2), radius]),
            "pressure_kPa": np.concatenate([upper, lower]) / 1e3,
        }
        tables.append(pd.DataFrame(table))
    return pd.concat(tables, ignore_index=True)


def _hopper(pressure: xr.DataArray, phase: str) -> np.ndarray:
    if phase != "switch":
        return pressure.sel({"phase": phase}).values
    filling, flow = (pressure.sel({"phase": one}).values for one in ("filling", "discharge"))
    return np.where(pressure["hopper_position"].values < 0.5, filling, flow)


def _silo(panel: Axes, cube: xr.Dataset) -> None:
    radius, (depth, at) = diameter(cube) / 2, wall(cube)
    for sign in (1, -1):
        panel.plot(
            [sign * radius] * 2 + list(sign * at),
            [0, float(cube["cylinder_depth"]), *depth],
            color="black",
            linewidth=1.8,
            gid=AID,
        )
    panel.plot([-radius, radius], [0, 0], color="0.5", linewidth=0.8, gid=AID)
    across: dict[str, Any] = {"color": "0.6", "linewidth": 0.6, "linestyle": (0, (6, 4)), "gid": AID}
    panel.plot([-radius, radius], [float(cube["cylinder_depth"])] * 2, **across)


def off_the_wall(table: pd.DataFrame, cube: xr.Dataset, largest: float) -> pd.DataFrame:
    """A load case with the places (m) where its pressures are drawn: at right angles off the wall, friction on the left."""
    scale, hopper = WIDEST * diameter(cube) / largest, (table.part == "hopper").to_numpy()
    angle = np.where(hopper, float(cube["hopper_half_angle"]), 0.0)
    sign, length = table.side.map({side: sign for side, (sign, *_) in SIDES.items()}), table.pressure_kPa * scale
    return table.assign(
        from_axis_m=sign * table.wall_radius_m,
        tip_from_axis_m=sign * (table.wall_radius_m + length * np.cos(angle)),
        tip_depth_m=table.depth_m + length * np.sin(angle),
    )


def _pressures(panel: Axes, table: pd.DataFrame) -> None:
    for (side, _), group in table.dropna(subset="pressure_kPa").groupby(["side", "part"], sort=False):
        feet = group[["from_axis_m", "depth_m"]].to_numpy()[::-1]
        outline = np.concatenate([group[["tip_from_axis_m", "tip_depth_m"]].to_numpy(), feet])
        outline = np.vstack([outline, outline[:1]])
        panel.fill(*outline.T, facecolor=COLOURS[side], alpha=0.15, linewidth=0)
        panel.fill(*outline.T, facecolor="none", edgecolor=COLOURS[side], hatch=HATCHES[side], linewidth=0, alpha=0.45)
        panel.plot(*outline.T, color=COLOURS[side], linewidth=1.3)
    here = table[table.side == "normal"]
    top = here.loc[here.pressure_kPa.idxmax()]
    tip, text = (top.tip_from_axis_m, top.tip_depth_m), f"{top.pressure_kPa:.0f} kPa"
    panel.annotate(text, tip, xytext=(3, 2), textcoords="offset points", fontsize=8, va="center")


def _forces(panel: Axes, cube: xr.Dataset, method: str, phase: str) -> None:
    """Ring force at its place, and the balance of vertical forces on the hopper's contents (kN) in the middle."""
    one = cube.sel(pressure_method=method, phase=phase)
    depth, radius = wall(cube)
    if phase == "switch":
        place = int(np.argmin(np.abs(cube["hopper_position"].values - 0.5)))
        ring = float(one["switch_force"][place])
        text = f"switch half-way up\nring force {ring / 1e3:.0f} kN"
        most = int(np.nanargmax(one["switch_force"].values))
        together = str(one["pressure_method_initial_state"].values).replace(" = ", "\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}")
        text += "\n" + fill(f"from the {together}", 20)
        if cube["hopper_normal_pressure"].sel(pressure_method=method, phase="discharge").isnull().all():
            text += "\n(flow pressures\nbelow: not given)"
        text += f"\nlargest on its way\n{float(one['switch_force'][most]) / 1e3:.0f} kN at {depth[most]:.1f} m"
    else:
        if one["hopper_normal_pressure"].isnull().all():
            why = reason(cube, "hopper_normal_pressure", method, phase)
            middle = float(cube["cylinder_depth"]) * 0.45  # between the cylinder's walls, as the hopper is too narrow
            panel.text(0, middle, "hopper not given:\n" + fill(why, 20), ha="center", va="center", fontsize=7.5)
            return
        place, ring = 0, float(one["ring_force"]) if "ring_force" in one else np.nan
        kilo = {
            name: float(one[name]) / 1e3 for name in ("hopper_weight", "transition_force", "hopper_wall_force", "outlet_force")
        }
        ring_text = f"\nring      {ring / 1e3:7.0f}" if ring == ring else ""
        text = (
            f"hopper (kN)\ncontents  {kilo['hopper_weight']:7.0f}\nload      {kilo['transition_force']:7.0f}\nwall      "
            f"{kilo['hopper_wall_force']:7.0f}{ring_text}\noutlet    {kilo['outlet_force']:7.0f}\n"
            f"off by % {100 * abs(float(one['hopper_balance'])):8.0e}"
        )
    panel.text(0, float(cube["cylinder_depth"]) * 0.45, text, ha="center", va="center", fontsize=7.5, family="monospace")
    if ring > 0:
        arrow = {"arrowstyle": "-|>", "linewidth": 2.2, "color": "black", "shrinkA": 0, "shrinkB": 0}
        start = (-radius[place] - 0.4 * diameter(cube), depth[place] - 0.12 * diameter(cube))
        label: dict[str, Any] = {"xytext": start, "arrowprops": arrow, "fontsize": 8, "ha": "right", "va": "bottom"}
        panel.annotate(f"P {ring / 1e3:.0f} kN", (-radius[place], depth[place]), **label)


def _frame(panels: np.ndarray, cube: xr.Dataset, largest: float) -> None:
    width, bottom = diameter(cube), float(wall(cube)[0][-1])
    bar = max(n * 10.0**power for power in range(-3, 7) for n in (1, 2, 5) if n * 10.0**power <= largest / 2)
    length = bar * WIDEST * width / largest
    for panel in panels.flat:
        panel.set(xlim=(-1.45 * width, 1.45 * width), ylim=(bottom + 0.45 * width, -0.06 * width))
        panel.plot([-1.3 * width, -1.3 * width + length], [bottom + 0.3 * width] * 2, color="black", linewidth=2, gid=AID)
        panel.text(-1.3 * width + length / 2, bottom + 0.27 * width, f"{bar:.0f} kPa", ha="center", va="bottom", fontsize=8)
        panel.text(1.4 * width, 0.3, "normal\npressure", ha="right", va="top", color=COLOURS["normal"], fontsize=8)
        panel.text(-1.4 * width, 0.3, "wall\nfriction", ha="left", va="top", color=COLOURS["friction"], fontsize=8)
        panel.grid(False)
    for panel in panels[:, 0]:
        panel.set_ylabel("depth z (m)")
    for panel in panels[-1]:
        panel.set_xlabel("distance from the axis (m)")
