"""A scene of grains in time: forces on its surfaces, mass through its outlets, what happened, and a sentence on all of it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from silostudy.errors import BadInput
from silostudy.figures.bin import opened_at
from silostudy.figures.style import INK, REST, series

FELT = 0.05  # of the largest force at rest: surfaces with less are not said to carry anything
CLOSEST = 0.06  # share of the axis of time between two events whose words are both written
SHOWN = 11  # surfaces with a look of their own, the most loaded ones; further ones are grey


@dataclass(frozen=True)
class Flow:
    """Mass that had left (table of time_s, outlet and the column `mass`), of how much, and the unit of it in words."""

    table: pd.DataFrame
    mass: str
    filled: float
    unit: str

    def told(self) -> str:
        """Mass that left, and how fast it did between the first grain and the last."""
        if self.table.empty:
            return "nothing leaves"
        through = self.table.groupby("time_s")[self.mass].sum()
        lasts, after_first = float(np.ptp(through.index)), float(through.iloc[-1] - through.iloc[0])
        rate = f", {after_first / lasts:.3g} {self.unit}/s on average" if lasts > 0.0 else ""
        return f"{through.iloc[-1]:.3g} of {self.filled:.3g} {self.unit} leave{rate}"


def check_recorded(cube: xr.Dataset, force: str) -> None:
    """Refuses a cube without forces of that name on whole surfaces, or without snapshots."""
    asked = {force: "record.wall_force_window_s", "snapshot_time": "record.snapshots_s"}
    for name, key in asked.items():
        if name not in cube:
            raise BadInput(key, "nothing", "must be given: the figure of a scene shows what it records")


def flow_of(cube: xr.Dataset, passing: str, mass: str, filled: str, column: str, unit: str) -> Flow:
    """Mass that had left at the times of a name, by outlet where they have names; mass, filled: names in the cube."""
    table = pd.DataFrame({"time_s": [], "outlet": [], column: []})
    if passing in cube:
        through = cube[f"outlet_{mass}"] if "outlet" in cube else cube[mass].expand_dims(outlet=["outlet"])
        table = through.to_dataframe(column).reset_index().rename(columns={passing: "time_s"})
    return Flow(table[["time_s", "outlet", column]], column, float(cube[filled].sum()), unit)


def snapshots(cube: xr.Dataset, passing: str) -> tuple[int, int]:
    """The last snapshot before anything has passed the outlet, at the times of that name, and the last of all."""
    time = cube["snapshot_time"].values
    left = cube[passing].values if passing in cube else time[:0]
    before = np.flatnonzero(time < left[0]) if left.size else np.arange(len(time))
    return (int(before[-1]) if before.size else 0), len(time) - 1


def forces(time: np.ndarray, force: np.ndarray, surfaces: Iterable[str], column: str) -> pd.DataFrame:
    """Force on each surface that is ever touched, mean of each window (by its end), as a long table."""
    tables = [pd.DataFrame({"surface": name, "time_s": time, column: values})
              for name, values in zip(surfaces, force.T, strict=True) if values.any()]  # fmt: skip
    return pd.concat(tables, ignore_index=True) if tables else pd.DataFrame(columns=["surface", "time_s", column])


def draw_forces(panel: Axes, table: pd.DataFrame, column: str, opened: float) -> list[Line2D]:
    """A step a window and a line a surface, thick where the force rises most; nothing while a surface is not touched."""
    ranked = list(table.groupby("surface")[column].max().sort_values(ascending=False).index)
    most, _ = pushed(table, column, opened)
    lines = []
    for name, group in table.groupby("surface", sort=False):
        number, touched = ranked.index(name), group[column].where(group[column] != 0.0)
        style = series(number) | {"markersize": 4, "markevery": max(1, len(group) // 8)} if number < SHOWN else REST
        style |= {"linestyle": "-", "linewidth": 2.0 if name == most else 0.9}
        lines += panel.plot(group["time_s"], touched, drawstyle="steps-pre", label=name.replace("_", " "), **style)
    panel.set(title="forces on the surfaces", xlabel="time (s)", xlim=(0, None), ylim=(0, None))
    return lines


def draw_flow(panel: Axes, flow: Flow) -> None:
    """A step a grain and a line an outlet, with its name at its end where there are several."""
    outlets = list(flow.table.groupby("outlet", sort=False))
    for number, (name, group) in enumerate(outlets):
        look = series(number) | {"marker": "none", "linewidth": 1.8}
        panel.plot(group["time_s"], group[flow.mass], drawstyle="steps-post", **look)
        if len(outlets) > 1:
            panel.annotate(
                str(name),
                (group["time_s"].iloc[-1], group[flow.mass].iloc[-1]),
                (-4, 4),
                textcoords="offset points",
                ha="right",
                fontsize="small",
            )
    panel.set(title="mass through the outlet" + "s" * (len(outlets) > 1), xlabel="time (s)", ylim=(0, None))


def mark_events(panels: Sequence[Axes], cube: xr.Dataset) -> None:
    """A line at each event, with its words in the first panel where they have room."""
    low, high = panels[0].get_xlim()
    written = -np.inf
    for when, what in zip(cube["event_time"].values, cube["event_action"].values, strict=True):
        for panel in panels:
            panel.axvline(when, color="0.6", linewidth=0.8)
        if when - written > CLOSEST * (high - low):
            words, place = str(what).split(": ")[-1].replace("_", " "), panels[0].get_xaxis_transform()
            panels[0].text(when, 0.98, words, transform=place, rotation=90, va="top", ha="right", fontsize="small", color=INK)
            written = when


def message(cube: xr.Dataset, table: pd.DataFrame, column: str, flow: Flow) -> str:
    """Message: what leaves, and the surface whose force rises most over that at rest once the outlet opens."""
    opened = opened_at(cube)
    surface, rise = pushed(table, column, opened)
    if not np.isfinite(opened):
        return f"At rest the largest force is that on {_quoted(surface)}" if surface else "Nothing touches a surface"
    rises = (
        f"; the force on {_quoted(surface)} comes to {rise:.2g} times that at rest, more than on any other" if surface else ""
    )
    return f"Once the outlet opens {flow.told()}{rises}"


def pushed(table: pd.DataFrame, column: str, opened: float) -> tuple[str, float]:
    """The surface with the largest force over that at rest, and this ratio; without a flow that with the largest at rest."""
    rest = table[table["time_s"] <= opened].groupby("surface")[column].last()
    peak = table[table["time_s"] > opened].groupby("surface")[column].max()
    carrying = rest[(rest > 0.0) & (rest >= FELT * rest.max())]
    if carrying.empty:
        return "", np.nan
    rises = (peak / carrying).dropna()
    return (str(carrying.idxmax()), np.nan) if rises.empty else (str(rises.idxmax()), float(rises.max()))


def _quoted(surface: str) -> str:
    """The name of a surface in quotes."""
    return f"\N{LEFT DOUBLE QUOTATION MARK}{surface.replace('_', ' ')}\N{RIGHT DOUBLE QUOTATION MARK}"
