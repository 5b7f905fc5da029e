"""Plane slots that jam: the share of fillings that stop before enough is out, and the power that the flow grows with."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.ticker import LogLocator
from scipy.stats import beta, linregress

from silostudy.figures.beside import settings, told
from silostudy.figures.style import WIDTH, foot, headline, plt, save, series

SURE = 0.95  # share of the intervals that hold the share of all fillings
FREE = "flow_kg_m_s"  # column: mean flow of fillings that do not jam
WITH_JAMS = "flow_with_jams_kg_m_s"  # column: mean flow of all
FLOWS: tuple[tuple[str, str, dict], ...] = (  # column, whose mean it is, how its curve differs
    (FREE, "fillings that do not jam", {}),
    (WITH_JAMS, "all fillings", {"linestyle": ":", "markerfacecolor": "none"}),
)
ASIDE = 0.05  # diameters by which the marks of a setting stand beside those of the one before
OWN = ("outlet_width", "filling")  # axes that the panels show


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a line a setting, the share that jams on the left and the mean flow on the right."""
    figure, (jams, flows) = plt.subplots(1, 2, figsize=(WIDTH, 4.8))
    others, numbers = [axis for axis in cube.attrs["sweep_axes"].split() if axis not in OWN], []
    for number, (setting, case) in enumerate(settings(cube.assign_attrs(sweep_axes=" ".join(others)))):
        table = over_outlet(case).assign(**setting)
        numbers.append(_panels(jams, flows, table, told(setting, case), number))
    jams.set(xlabel="width of the slot over the discs' diameter", ylabel="share of the fillings that jam", ylim=(-0.03, 1.03))
    flows.set(xlabel="width of the slot over the discs' diameter", ylabel="mean flow (kg m⁻¹ s⁻¹)")
    flows.set(xscale="log", yscale="log")
    for axis in (flows.xaxis, flows.yaxis):
        _plain_numbers(axis)
    shown = pd.concat(numbers, ignore_index=True)
    headline(figure, _message(shown))
    read = f"{cube.attrs['title']}; bars: 95 % intervals by Clopper and Pearson, set side by side; dotted: a jam's time counted"
    left_out = "Widths at which nothing flows have no place on a logarithmic axis, and no part in a power."
    foot(
        figure,
        read,
        left_out if (shown[[FREE, WITH_JAMS]] == 0.0).any(axis=None) else "",
        handles=flows.get_legend_handles_labels()[0],
    )
    save(figure, shown, stem)


def _panels(jams: Axes, flows: Axes, table: pd.DataFrame, name: str, number: int) -> pd.DataFrame:
    """Draws a setting in both panels; its table with the powers of its flows."""
    style, place = series(number), table["outlet_diameters"]
    table = table.assign(setting=name, drawn_at_diameters=place + ASIDE * number)
    spread = [table["share_jammed"] - table["low_95"], table["high_95"] - table["share_jammed"]]
    jams.errorbar(table["drawn_at_diameters"], table["share_jammed"], yerr=spread, capsize=3, **style)
    for column, of, look in FLOWS:
        grows = power(table, column)
        flows.plot(
            place,
            table[column].where(table[column] > 0.0),
            label=f"{name}, {of}: {_power_told(grows, table[column])}",
            **style | look,
        )
        table = table.assign(**{f"power_of_{column}": grows})
    return table


def _plain_numbers(axis: Axis) -> None:
    """Writes the ticks of a logarithmic axis as plain numbers: 1, 2 and 5 alone where they span much more than a decade."""
    low, high = axis.get_view_interval()
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter("{x:g}")
    if high > 20.0 * low:
        axis.set_minor_locator(LogLocator(subs=(2.0, 5.0)))


def _power_told(grows: float, flows: pd.Series) -> str:
    """Words for the power of flows, and how many widths have no part in it."""
    still = int((flows == 0.0).sum())
    told = "no power of fewer than two flows" if np.isnan(grows) else f"power {grows:.2f}"
    return f"{told}, {still} of no flow left out" if still else told


def _message(table: pd.DataFrame) -> str:
    """Sentence on what the figure says: the widest slot that jams and in which setting, and the powers there."""
    jammed = table[table["jammed"] > 0]
    if jammed.empty:
        return f"No slot of {table['outlet_diameters'].min():g} diameters or more jams"
    widest, others = jammed.loc[jammed["outlet_diameters"].idxmax()], jammed["setting"].nunique() - 1
    where, too = "", ""
    if table["setting"].nunique() > 1:
        where = f"{widest['setting']}: "
        too = f" (in {others} other settings at most as wide ones)" if others else " (in no other setting any)"
    means = {FREE: "flows that do not jam", WITH_JAMS: "means that count jams"}
    powers = {whose: widest[f"power_of_{column}"] for column, whose in means.items()}
    known = "".join(f"; {whose} grow with a power of {value:.1f}" for whose, value in powers.items() if np.isfinite(value))
    told = f"{where}slots of up to {widest['outlet_diameters']:g} diameters jam{too}{known}"
    return told[0].upper() + told[1:]


def over_outlet(case: xr.Dataset) -> pd.DataFrame:
    """A row an outlet: share of the fillings that jam with its interval, mean flow (kg/(m s)) of those that do not, and of all.

    A filling jams that has not let out what its last event waits for when the time is over.
    """
    diameter, rows = float(case["mean_grain_diameter"].mean()), []
    for position in range(case.sizes["outlet_width"]):
        here = case.isel(outlet_width=position)
        stopped, flow = here["limit_reached"].values, here["mean_discharge_rate"].values
        known = np.isfinite(flow)  # of one that never came to rest nothing opened
        jammed, count = int(stopped[known].sum()), int(known.sum())
        low, high = share_interval(jammed, count)
        through = flow[known & (stopped == 0.0)]
        rows.append({
            "outlet_diameters": float(here["outlet_width"]) / diameter, "fillings": count, "jammed": jammed,
            "share_jammed": jammed / count if count else np.nan, "low_95": low, "high_95": high,
            FREE: through.mean() if len(through) else np.nan, WITH_JAMS: np.nanmean(flow),
        })  # fmt: skip
    return pd.DataFrame(rows)


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
