"""Mass that leaves a scene of grains through its outlets, in time."""

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.style import LINES, MARKERS


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

    @property
    def begins(self) -> float:
        """Time (s) at which the first grain leaves; endless where none does."""
        return float(self.table["time_s"].min()) if len(self.table) else np.inf

    @property
    def halfway(self) -> float:
        """Time (s) at which half of what leaves has left."""
        through = self.table.groupby("time_s")[self.mass].sum()
        return float(through.index[through >= 0.5 * through.iloc[-1]][0])


def flow_of(cube: xr.Dataset, filled: str, column: str, unit: str) -> Flow:
    """Mass that had left from the first grain on, by outlet where they have names; filled: name of the grains' mass."""
    table = pd.DataFrame({"time_s": [], "outlet": [], column: []})
    if "outflow_mass" in cube:
        left = cube.isel(outflow_time=cube["outflow_mass"].values > 0.0)
        through = left["outlet_outflow_mass"] if "outlet" in cube else left["outflow_mass"].expand_dims(outlet=["outlet"])
        table = through.to_dataframe(column).reset_index().rename(columns={"outflow_time": "time_s"})
    return Flow(table[["time_s", "outlet", column]], column, float(cube.attrs.get("began_with_kg", cube[filled].sum())), unit)


def draw_flow(panel: Axes, flow: Flow, unseen: Collection[str] = ()) -> None:
    """A step a grain and a line an outlet, black as no surface's is alone, and told apart by dashes where there are several.

    unseen: names of outlets that the slice beside it does not show.
    """
    outlets = list(flow.table.groupby("outlet", sort=False))
    for number, (name, group) in enumerate(outlets):
        look = {"color": "black", "linestyle": LINES[number % len(LINES)], "linewidth": 1.8}
        look |= {"marker": MARKERS[number // len(LINES) - 1], "markevery": 0.1} if number >= len(LINES) else {}
        label = str(name).replace("_", " ") + ", off the slice" * (name in unseen)
        panel.plot(group["time_s"], group[flow.mass], drawstyle="steps-post", label=label, **look)
    if len(outlets) > 1:
        panel.legend(loc="upper left", frameon=True, framealpha=1.0, edgecolor="white")
    title = "mass through the outlets" if len(outlets) > 1 else "mass through the outlet" + ", off the slice" * bool(unseen)
    panel.set(title=title, ylim=(0, None))
