"""Fig. 4.2.11 again: the wall pressure of one silo over depth by every theory and code, and its ratio to Janssen's."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from silostudy.cube.silence import silences
from silostudy.figures.steps import over_depth
from silostudy.figures.style import PHASE_LINES, WIDTH, drawn, foot, headline, look, phases_of_its_own, save, title
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.outputs import output_of

KPA_PER_T_M2 = STANDARD_GRAVITY
READ = "; dashed: after filling, full: in discharge; numbers as in the source"
(STATIC,) = output_of(__name__).methods  # what the others are set against


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the curves it shows."""
    curves = _curves(cube)
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 7.6), sharey=True, width_ratios=(1.35, 1))
    for name, group in curves.groupby("curve", sort=False):
        style = _style(cube, group.iloc[0])
        depth = group.depth_m.to_numpy()
        over_depth(left, group.wall_normal_pressure_t_m2.to_numpy(), depth, label=name, **style)
        over_depth(right, group.ratio_to_janssen.to_numpy(), depth, **style)
    _number_ends(left, curves)
    left.set(xlabel="wall normal pressure (t/m²)", ylabel="depth z (m)", xlim=(0, None))
    left.yaxis.set_major_locator(MaxNLocator(10, steps=[1, 2, 5, 10]))
    kpa = left.secondary_xaxis("top", functions=(lambda t: t * KPA_PER_T_M2, lambda kpa: kpa / KPA_PER_T_M2))
    kpa.set_xlabel("wall normal pressure (kPa)")
    right.set(xlabel="ratio to static Janssen (curve 6)", xlim=(0.5, 6))
    left.set_ylim(float(cube["cylinder_depth"]) * 1.1, 0)  # room for the numbers at the feet
    headline(figure, _message(curves))
    unspoken = silences(cube, in_every_case=True, titles=True)
    foot(figure, cube.attrs["title"] + READ, *unspoken, handles=left.get_legend_handles_labels()[0])
    save(figure, curves.drop(columns="drawn"), stem)


def _message(curves: pd.DataFrame) -> str:
    """Message of the figure, in numbers: the span of the largest pressures in discharge, over Janssen's largest."""
    peaks = curves[curves.drawn != "misprint"].groupby(["phase", "pressure_method"]).wall_normal_pressure_t_m2.max()
    static = peaks.get(("filling", STATIC), np.nan)
    spans = peaks.groupby("phase").agg(["min", "max"]) / static
    words = {"discharge": "in discharge it is", "filling": "after filling"}
    told = [f"{words[phase]} {spans['min'][phase]:.1f} to {spans['max'][phase]:.1f}" for phase in words if phase in spans.index]
    return f"The largest wall pressure over Janssen's at rest: {', '.join(told)}"


def _curves(cube: xr.Dataset) -> pd.DataFrame:
    """Long table of every curve drawn: all the methods in the cube, Jenike's also with the source's slip."""
    static = cube["wall_normal_pressure"].sel(pressure_method=STATIC, phase="filling")
    parts = []
    for method in map(str, cube["pressure_method"].values):
        for phase in _phases_shown(cube, method):
            pressure = cube["wall_normal_pressure"].sel(pressure_method=method, phase=phase)
            table = pd.DataFrame(
                {
                    "curve": f"{title(cube, method)}, {phase}",
                    "pressure_method": method,
                    "phase": phase,
                    "drawn": drawn(cube, method),
                    "number": str(cube["pressure_method_number"].sel(pressure_method=method).values),
                    "depth_m": cube["depth"].values,
                    "wall_normal_pressure_t_m2": pressure.values / 1e3 / KPA_PER_T_M2,
                    "ratio_to_janssen": (pressure / static.where(static > 0)).values,
                }
            )
            parts.append(table.dropna(subset="wall_normal_pressure_t_m2"))
    return pd.concat(parts, ignore_index=True)


def _phases_shown(cube: xr.Dataset, method: str) -> list[str]:
    """Phases in which a method has a curve of its own (Jenike's filling is Janssen's, curve 6)."""
    return phases_of_its_own(cube, method, STATIC) if drawn(cube, method) != "none" else []


def _style(cube: xr.Dataset, first: pd.Series) -> dict:
    printed = drawn(cube, first.pressure_method) == "misprint"
    return {
        **look(cube, first.pressure_method),
        "linestyle": ":" if printed else PHASE_LINES[first.phase],
        "linewidth": 2.2 if first.pressure_method == STATIC else 1.3,
        "markersize": 4.5,
        "markerfacecolor": "none" if first.phase == "filling" or printed else None,
        "markevery": 24,
    }


def _number_ends(axes: Axes, curves: pd.DataFrame) -> None:
    """The handbook's number at the foot of each curve, so that the curves can be told apart without colour."""
    feet = curves[curves.number != ""].groupby("curve", sort=False).last().sort_values("wall_normal_pressure_t_m2")
    last = [-1.0, -1.0, -1.0]  # where the last number on each of three lines stands
    for end in feet.itertuples():
        line = next((n for n in range(3) if end.wall_normal_pressure_t_m2 - last[n] > 0.2), 2)
        last[line] = end.wall_normal_pressure_t_m2
        axes.annotate(
            end.number,
            (end.wall_normal_pressure_t_m2, end.depth_m),
            xytext=(0, -9 - 11 * line),
            textcoords="offset points",
            ha="center",
            va="center",
            fontsize="small",
        )
