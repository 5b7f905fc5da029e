"""Plane slots that jam: the share of fillings that stop before enough is out, and the power that the flow grows with."""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.ticker import ScalarFormatter
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
        axis.set_major_formatter(ScalarFormatter())
        axis.set_minor_formatter(ScalarFormatter())
    shown = pd.concat(numbers, ignore_index=True)
    headline(figure, _message(shown))
    read = f"{cube.attrs['title']}; bars: 95 % intervals by Clopper and Pearson, set side by side; dotted: a jam's time counted"
    foot(figure, read, handles=flows.get_legend_handles_labels()[0])
    save(figure, shown, stem)


def _panels(jams: Axes, flows: Axes, table: pd.DataFrame, name: str, number: int) -> pd.DataFrame:
    """Draws a setting in both panels; its table with the powers of its flows."""
    style, place = series(number), table["outlet_diameters"]
    table = table.assign(drawn_at_diameters=place + ASIDE * number)
    spread = [table["share_jammed"] - table["low_95"], table["high_95"] - table["share_jammed"]]
    jams.errorbar(table["drawn_at_diameters"], table["share_jammed"], yerr=spread, capsize=3, **style)
    for column, of, look in FLOWS:
        grows = power(table, column)
        flows.plot(place, table[column], label=f"{name}, {of}: power {grows:.2f}", **style | look)
        table = table.assign(**{f"power_of_{column}": grows})
    return table


def _message(table: pd.DataFrame) -> str:
    """Sentence on what the figure says: the widest slot that jams, and the powers with jams and without."""
    jammed = table[table["jammed"] > 0]
    if jammed.empty:
        return f"No slot of {table['outlet_diameters'].min():g} diameters or more jams"
    widest = jammed.loc[jammed["outlet_diameters"].idxmax()]
    return (
        f"Slots of up to {widest['outlet_diameters']:g} diameters jam; flows that do not jam grow with a power of "
        f"{widest[f'power_of_{FREE}']:.1f}, means that count jams with one of {widest[f'power_of_{WITH_JAMS}']:.1f}"
    )


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
