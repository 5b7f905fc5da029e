"""Mass that leaves a scene of grains through its outlets, in time."""

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


def flow_of(cube: xr.Dataset, passing: str, mass: str, filled: str, column: str, unit: str) -> Flow:
    """Mass that had left at the times of a name, by outlet where they have names; mass, filled: names in the cube."""
    table = pd.DataFrame({"time_s": [], "outlet": [], column: []})
    if passing in cube:
        through = cube[f"outlet_{mass}"] if "outlet" in cube else cube[mass].expand_dims(outlet=["outlet"])
        table = through.to_dataframe(column).reset_index().rename(columns={passing: "time_s"})
    return Flow(table[["time_s", "outlet", column]], column, float(cube.attrs.get("began_with_kg", cube[filled].sum())), unit)


def draw_flow(panel: Axes, flow: Flow) -> None:
    """A step a grain and a line an outlet, black as no surface's is alone, and told apart by dashes where there are several."""
    outlets = list(flow.table.groupby("outlet", sort=False))
    for number, (name, group) in enumerate(outlets):
        look = {"color": "black", "linestyle": LINES[number % len(LINES)], "linewidth": 1.8}
        look |= {"marker": MARKERS[number // len(LINES) - 1], "markevery": 0.1} if number >= len(LINES) else {}
        panel.plot(group["time_s"], group[flow.mass], drawstyle="steps-post", label=str(name).replace("_", " "), **look)
    if len(outlets) > 1:
        panel.legend(loc="upper left", frameon=True, framealpha=1.0, edgecolor="white")
    panel.set(title="mass through the outlet" + "s" * (len(outlets) > 1), ylim=(0, None))
