"""Fig. 4.2.11 again: the wall pressure of one silo over depth by every theory and code, and its ratio to Janssen's."""

from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from silostudy.figures.steps import over_depth
from silostudy.figures.style import PHASE_LINES, drawn, look, phases_of_its_own, save, silent, title
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.outputs import output_of

KPA_PER_T_M2 = STANDARD_GRAVITY
(STATIC,) = output_of(__name__).methods  # what the others are set against


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the curves it shows."""
    curves = _curves(cube)
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 8), sharey=True, width_ratios=(1.35, 1))
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
    left.set_ylim(float(cube["cylinder_depth"]) * 1.09, 0)  # room for the numbers at the feet
    handles = [*left.get_legend_handles_labels()[0], *silent(cube)]
    figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=8)
    figure.suptitle(cube.attrs["title"])
    save(figure, curves, stem)


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
    for foot in feet.itertuples():
        line = next((n for n in range(3) if foot.wall_normal_pressure_t_m2 - last[n] > 0.16), 2)
        last[line] = foot.wall_normal_pressure_t_m2
        axes.annotate(
            foot.number,
            (foot.wall_normal_pressure_t_m2, foot.depth_m),
            xytext=(0, -9 - 10 * line),
            textcoords="offset points",
            ha="center",
            va="center",
            fontsize=8,
        )
