"""Plane slots that jam: the share of fillings that stop before enough is out, and the power that the flow grows with."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.ticker import ScalarFormatter
from scipy.stats import beta, linregress

from silostudy.figures.beside import settings, told
from silostudy.figures.style import plt, save

SURE = 0.95  # share of the intervals that hold the share of all fillings
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")
OWN = ("outlet_width", "filling")  # axes that the panels show


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line a setting, the share that jams on the left and the mean flow on the right."""
    figure, (jams, flows) = plt.subplots(1, 2, figsize=(11.0, 4.8))
    numbers = []
    others = [axis for axis in cube.attrs["sweep_axes"].split() if axis not in OWN]
    for number, (setting, one) in enumerate(settings(cube.assign_attrs(sweep_axes=" ".join(others)))):
        table, colour, name = over_outlet(one), COLOURS[number % len(COLOURS)], told(setting)
        place = table["outlet_diameters"]
        spread = [table["share_jammed"] - table["low_95"], table["high_95"] - table["share_jammed"]]
        jams.errorbar(place, table["share_jammed"], yerr=spread, fmt="o-", capsize=3, color=colour, label=name)
        for column, marks, of in (("flow_kg_m_s", "o-", "fillings that do not jam"), ("flow_with_jams_kg_m_s", "s:", "all")):
            grows = power(table, column)
            flows.plot(place, table[column], marks, color=colour, label=f"{name}, {of}: power {grows:.2f}")
            table[f"power_of_{column}"] = grows
        numbers.append(table.assign(**setting))
    jams.set(xlabel="width of the slot over the discs' diameter", ylabel="share of the fillings that jam", ylim=(-0.03, 1.03))
    flows.set(xlabel="width of the slot over the discs' diameter", ylabel="mean flow (kg m⁻¹ s⁻¹)")
    flows.set(xscale="log", yscale="log")
    for axis in (flows.xaxis, flows.yaxis):
        axis.set_major_formatter(ScalarFormatter())
        axis.set_minor_formatter(ScalarFormatter())
    for panel in (jams, flows):
        panel.legend(fontsize=8)
    figure.suptitle(f"{cube.attrs['title']}\nmeans over jams count them as slow flow, and ask for a larger power")
    save(figure, pd.concat(numbers, ignore_index=True), stem)


def over_outlet(one: xr.Dataset) -> pd.DataFrame:
    """A row an outlet: share of the fillings that jam with its interval, mean flow (kg/(m s)) of those that do not, and of all.

    A filling jams that has not let out what its last event waits for when the time is over.
    """
    diameter, found = float(one["mean_grain_diameter"].mean()), []
    for position in range(one.sizes["outlet_width"]):
        here = one.isel(outlet_width=position)
        stopped, flow = here["limit_reached"].values, here["mean_discharge_rate"].values
        known = np.isfinite(flow)  # of one that never came to rest nothing opened
        jammed, count = int(stopped[known].sum()), int(known.sum())
        low, high = share_interval(jammed, count)
        through = flow[known & (stopped == 0.0)]
        found.append({
            "outlet_diameters": float(here["outlet_width"]) / diameter, "fillings": count, "jammed": jammed,
            "share_jammed": jammed / count if count else np.nan, "low_95": low, "high_95": high,
            "flow_kg_m_s": through.mean() if len(through) else np.nan, "flow_with_jams_kg_m_s": np.nanmean(flow),
        })  # fmt: skip
    return pd.DataFrame(found)


def share_interval(hits: int, count: int) -> tuple[float, float]:
    """Ends of the interval of a share by Clopper and Pearson."""
    tail = 0.5 * (1.0 - SURE)
    low = float(beta.ppf(tail, hits, count - hits + 1)) if hits else 0.0
    return low, float(beta.ppf(1.0 - tail, hits + 1, count - hits)) if hits < count else 1.0


def power(table: pd.DataFrame, column: str) -> float:
    """Power (1) of the outlet's width that a flow grows with; NaN of fewer than two outlets that flow."""
    flows = table[table[column] > 0.0]
    if len(flows) < 2:
        return np.nan
    return float(linregress(np.log(flows["outlet_diameters"]), np.log(flows[column])).slope)
