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
from matplotlib.patches import Patch

from silostudy.cube.silence import reason
from silostudy.figures.style import AID, BLUE, LINES, VERMILION, WIDTH, foot, headline, name, save, title

SIDES = {
    "normal": (1, "wall_normal_pressure", "hopper_normal_pressure"),
    "friction": (-1, "wall_friction_traction", "hopper_friction_traction"),
}
HATCHES = {"normal": "////", "friction": "...."}
COLOURS = {"normal": VERMILION, "friction": BLUE}
SAVED = ("side", "depth_m", "wall_radius_m", "pressure_kPa", "from_axis_m", "tip_from_axis_m", "tip_depth_m")
STAR = "*"  # marks what SETS says
SETS = "pressure, friction and load each by their own set of characteristic values: no single state of the silo"
WIDEST = 0.6  # diameters that the largest pressure reaches out
WORDS = 0.6  # heights of the silo that are kept free beside it, for words


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the pressures it shows."""
    methods = [
        m for m in map(str, cube["pressure_method"].values) if cube["hopper_balance"].sel(pressure_method=m).notnull().any()
    ]
    phases = [phase for phase in ("filling", "switch", "discharge") if phase in cube["phase"].values]
    given = {(method, phase): state(cube, method, phase) for method in methods for phase in phases}
    states = {where: table for where, table in given.items() if table is not None}
    largest = max(float(table.pressure_kPa.max()) for table in states.values())
    states = {where: off_the_wall(table, cube, largest) for where, table in states.items()}
    figure, panels = plt.subplots(
        len(methods), len(phases), figsize=(WIDTH, 2.7 * len(methods) + 1.4), squeeze=False, sharex=True, sharey=True
    )
    for row, method in zip(panels, methods, strict=True):
        for panel, phase in zip(row, phases, strict=True):
            panel.set_title(f"{title(cube, method)}{STAR * of_sets(cube, method)}: {phase}", fontsize="small")
            panel.set_aspect("equal")
            _silo(panel, cube)
            if (method, phase) in states:
                _pressures(panel, states[method, phase])
                _forces(panel, cube, method, phase)
            else:
                panel.text(1.4 * diameter(cube), 0, _why_not(cube, method, phase), va="top", fontsize="small")
            panel.tick_params(labelbottom=True)
    _frame(panels, cube, largest)
    several = any(of_sets(cube, method) for method in methods)
    numbers = pd.concat([t.assign(pressure_method=m, phase=p) for (m, p), t in states.items()], ignore_index=True)
    headline(figure, _message(cube, numbers))
    foot(figure, cube.attrs["title"], f"{STAR} {SETS}" * several, handles=_handles())
    save(figure, numbers[["pressure_method", "phase", *SAVED]], stem)


def _message(cube: xr.Dataset, numbers: pd.DataFrame) -> str:
    """Message of the figure, in numbers: the largest normal pressure and its place, method by method."""
    normal = numbers[numbers.side == "normal"]
    told = []
    for method, table in normal.groupby("pressure_method", sort=False):
        top = table.loc[table.pressure_kPa.idxmax()]
        told.append(f"{name(cube, str(method))} {top.pressure_kPa:.0f} kPa ({top.phase}, {top['part']})")
    return f"The largest pressures normal to the wall: {'; '.join(told)}"


def _handles() -> list[Patch]:
    """Entries of the legend: what is drawn off the two sides of the wall."""
    told = {"normal": "normal pressure, right", "friction": "wall friction, left"}
    looks: dict[str, dict[str, Any]] = {side: {"edgecolor": COLOURS[side], "hatch": HATCHES[side]} for side in SIDES}
    return [Patch(facecolor="none", label=words, **looks[side]) for side, words in told.items()]


def of_sets(cube: xr.Dataset, method: str) -> bool:
    """Whether a method reckons its quantities with different characteristic values: what is drawn does not act at once."""
    values = str(cube["pressure_method_values"].sel(pressure_method=method).values)
    return len([text for text in values.split("; ") if not text.startswith("every quantity")]) > 1


def _why_not(cube: xr.Dataset, method: str, phase: str) -> str:
    """Words in a panel without pressures."""
    quantity = "switch_force" if phase == "switch" else "wall_normal_pressure"
    return "not given:\n" + fill(reason(cube, quantity, method, phase), 20)


def diameter(cube: xr.Dataset) -> float:
    """Width (m) of the cylinder, from the hopper's height and angle."""
    return 2 * float(cube["hopper_height"]) * np.tan(float(cube["hopper_half_angle"]))


def wall(cube: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Depth and radius (m) of the places on the hopper wall."""
    radius = diameter(cube) / 2
    outlet = float(cube["outlet_width"]) / 2
    inside = radius - cube["hopper_position"].values * (radius - outlet)
    return float(cube["cylinder_depth"]) + (radius - inside) / np.tan(float(cube["hopper_half_angle"])), inside


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
    filling, flow = (pressure.sel({"phase": phase}).values for phase in ("filling", "discharge"))
    return np.where(pressure["hopper_position"].values < 0.5, filling, flow)


def _silo(panel: Axes, cube: xr.Dataset) -> None:
    radius, (depth, inside) = diameter(cube) / 2, wall(cube)
    for sign in (1, -1):
        panel.plot(
            [sign * radius] * 2 + list(sign * inside),
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
        panel.plot(*outline.T, color=COLOURS[side], linestyle=LINES[list(SIDES).index(side)], linewidth=1.3)
    here = table[table.side == "normal"]
    top = here.loc[here.pressure_kPa.idxmax()]
    tip, text = (top.tip_from_axis_m, top.tip_depth_m), f"{top.pressure_kPa:.0f} kPa"
    panel.annotate(text, tip, xytext=(3, 2), textcoords="offset points", fontsize="small", va="center")


def _forces(panel: Axes, cube: xr.Dataset, method: str, phase: str) -> None:
    """Ring force at its place, and the balance of vertical forces on the hopper's contents (kN) in the middle."""
    here = cube.sel(pressure_method=method, phase=phase)
    depth, radius = wall(cube)
    if phase == "switch":
        place = int(np.argmin(np.abs(cube["hopper_position"].values - 0.5)))
        ring = float(here["switch_force"][place])
        text = f"switch half-way up,\nring {ring / 1e3:.0f} kN"
        most = int(np.nanargmax(here["switch_force"].values))
        together = str(here["pressure_method_initial_state"].values).replace(" = ", "\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}")
        text += "\n" + fill(f"from the {together}", 20)
        if cube["hopper_normal_pressure"].sel(pressure_method=method, phase="discharge").isnull().all():
            text += "\n(flow below: not given)"
        text += f"\nat most {float(here['switch_force'][most]) / 1e3:.0f} kN at {depth[most]:.1f} m"
    else:
        if here["hopper_normal_pressure"].isnull().all():
            why = reason(cube, "hopper_normal_pressure", method, phase)
            told = "hopper not given:\n" + fill(why, 20)
            panel.text(1.4 * diameter(cube), 0, told, va="top", fontsize="small")
            return
        place, ring = 0, float(here["ring_force"]) if "ring_force" in here else np.nan
        kilo = {
            name: float(here[name]) / 1e3 for name in ("hopper_weight", "transition_force", "hopper_wall_force", "outlet_force")
        }
        ring_text = f"\nring     {ring / 1e3:5.0f}" if ring == ring else ""
        text = (
            f"hopper (kN)\ncontents {kilo['hopper_weight']:5.0f}\nload     {kilo['transition_force']:5.0f}\nwall     "
            f"{kilo['hopper_wall_force']:5.0f}{ring_text}\noutlet   {kilo['outlet_force']:5.0f}\n"
            f"off by % {100 * abs(float(here['hopper_balance'])):5.0e}"
        )
    panel.text(1.4 * diameter(cube), 0, text, va="top", fontsize="small", family="monospace")
    if ring > 0:
        arrow = {"arrowstyle": "-|>", "linewidth": 2.2, "color": "black", "shrinkA": 0, "shrinkB": 0}
        start = (-radius[place] - 0.25 * diameter(cube), depth[place] - 0.12 * diameter(cube))
        label: dict[str, Any] = {"xytext": start, "arrowprops": arrow, "fontsize": "small", "ha": "right", "va": "bottom"}
        panel.annotate(f"P {ring / 1e3:.0f} kN", (-radius[place], depth[place]), **label)


def _frame(panels: np.ndarray, cube: xr.Dataset, largest: float) -> None:
    width, bottom = diameter(cube), float(wall(cube)[0][-1])
    bar = max(n * 10.0**power for power in range(-3, 7) for n in (1, 2, 5) if n * 10.0**power <= largest / 2)
    length = bar * WIDEST * width / largest
    for panel in panels.flat:
        right = 1.25 * width + WORDS * bottom
        panel.set(
            xlim=(-1.6 * width, right),
            ylim=(bottom + 0.45 * width, -0.06 * width),
            xticks=[sign * round(width) for sign in (-1, 0, 1)],
        )
        panel.plot([2.2 * width, 2.2 * width + length], [bottom + 0.3 * width] * 2, color="black", linewidth=2, gid=AID)
        panel.text(
            2.2 * width + length / 2, bottom + 0.27 * width, f"{bar:.0f} kPa", ha="center", va="bottom", fontsize="small"
        )
        panel.grid(False)
    for panel in panels[:, 0]:
        panel.set_ylabel("depth z (m)")
    for panel in panels[-1]:
        panel.set_xlabel("distance from the axis (m)")
