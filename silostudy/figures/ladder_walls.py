"""Wall pressures of a bin of spheres with each setting of a ladder: profile at rest, and largest mean in flow by area.

A ladder is the first setting with those that differ from it in one thing; its finest rung is what the others are held against.
"""

from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.cube.areas import AVERAGED, largest_mean
from silostudy.errors import BadInput
from silostudy.figures.intervals import changed, half_interval
from silostudy.figures.ladder_rungs import LADDERS, rung_label, rungs_of
from silostudy.figures.style import WIDTH, foot, headline, plt, save, series

DEPTHS = np.linspace(0.15, 0.95, 9)  # of the filled height
HEIGHT = 9.0  # inches
AREAS = {"1x1": "1 cell", "2x2": "2 by 2", "4x4": "4 by 4", "ring": "ring"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: a column for each ladder, above the profile and below the largest means."""
    table = wall_ladders(cube)
    names = list(dict.fromkeys(table["ladder"]))
    figure, panels = plt.subplots(2, len(names), sharey="row", squeeze=False, figsize=(WIDTH, HEIGHT))
    for (above, below), name in zip(panels.T, names, strict=True):
        part = table[table["ladder"] == name]
        _draw_profiles(above, part[part["area"] == ""])
        _draw_peaks(below, part[part["area"] != ""])
        above.set(title=name, xlabel="pressure at rest (kPa)")
        above.legend(handlelength=1.5)
    panels[0, 0].set_ylabel("depth over the filled height")
    panels[0, 0].invert_yaxis()
    panels[1, 0].set_ylabel("largest mean pressure in flow (kPa)")
    panels[1, 0].set_ylim(0.0, 1.05 * float(table["high_kPa"].max()))
    headline(figure, _message(table))
    told = (
        f"Mean around the wall in the last window at rest; largest mean of any window and place in flow. A cell is "
        f"{_cell(cube)}. Bars: 95 % intervals of means of {cube.sizes['filling']} fillings. "
        "Bold and large: the finest of each ladder (of restitution the first setting), to which changes are."
    )
    foot(figure, str(cube.attrs["title"]), told)
    save(figure, table, stem)


def wall_ladders(cube: xr.Dataset) -> pd.DataFrame:
    """Mean over fillings (kPa) of each setting's pressures at rest and largest means in flow, its interval, and its change (1)
    from the finest of its ladder with half the interval of that."""
    if "wall_pressure_in_flow" not in cube:
        raise BadInput("outputs", "ladder_walls", "needs record.wall_force_window_s, and a round silo")
    values = pressures(cube)
    rows = []
    for column in (column for column in LADDERS if column in cube):
        for place, against in rungs_of(cube, column):
            for (depth, area), of in values.items():
                change = changed(of[place], of[against]) if place != against else (0.0, 0.0)
                said = LADDERS[column].title, rung_label(cube, column, place), place == against, depth, area
                rows.append((*said, *_mean(of[place]), *change))
    columns = [
        "ladder",
        "setting",
        "base",
        "relative_depth",
        "area",
        "pressure_kPa",
        "low_kPa",
        "high_kPa",
        "change",
        "change_interval",
    ]
    return pd.DataFrame(rows, columns=columns)


def _mean(values: np.ndarray) -> tuple[float, float, float]:
    """Mean (kPa) of the fillings that show something, and the ends of its interval; NaN of fewer than two."""
    seen = 1e-3 * values[np.isfinite(values)]
    if len(seen) < 2:
        return np.nan, np.nan, np.nan
    half = float(abs(seen.mean()) * half_interval(seen))
    return float(seen.mean()), float(seen.mean() - half), float(seen.mean() + half)


def pressures(cube: xr.Dataset) -> dict[tuple[float, str], np.ndarray]:
    """Pressure (Pa; setting, filling) at rest by relative depth, and largest mean in flow by area, whose depth is NaN."""
    ring = cube["wall_pressure_at_rest"].mean("wall_turn").transpose("setting", "filling", "wall_level").values
    height, top = (
        cube[name].transpose("setting", "filling", ...).values for name in ("wall_level_height", "filled_height_at_rest")
    )
    profile = np.full((*ring.shape[:2], len(DEPTHS)), np.nan)
    for place in np.ndindex(ring.shape[:2]):
        profile[place] = np.interp((1.0 - DEPTHS) * top[place], height[place], ring[place])
    flow = cube["wall_pressure_in_flow"].transpose("setting", "filling", "flow_window", "wall_level", "wall_turn").values
    told = {(depth, ""): profile[:, :, k] for k, depth in enumerate(DEPTHS)}
    return told | {(np.nan, area): _largest(largest_mean(flow, area)) for area in AVERAGED}


def _largest(means: np.ndarray) -> np.ndarray:
    """Largest (Pa; setting, filling) of means (..., window, level); NaN where there are none."""
    largest = np.nan_to_num(means, nan=-np.inf).max(axis=(2, 3))
    return np.where(np.isfinite(largest), largest, np.nan)


def _draw_profiles(panel, part: pd.DataFrame) -> None:
    for number, (name, rows) in enumerate(part.groupby("setting", sort=False)):
        look = series(number) | {"markersize": 3, "linewidth": 2.4 if rows["base"].iloc[0] else 1.1}
        panel.plot(rows["pressure_kPa"], rows["relative_depth"], label=name, **look)
        panel.hlines(rows["relative_depth"], rows["low_kPa"], rows["high_kPa"], color=look["color"], linewidth=0.7)


def _draw_peaks(panel, part: pd.DataFrame) -> None:
    names = list(dict.fromkeys(part["setting"]))
    for number, name in enumerate(names):
        rows = part[part["setting"] == name]
        aside = np.arange(len(rows)) + 0.14 * (number - 0.5 * (len(names) - 1))
        look = series(number) | {"linestyle": "none", "markersize": 6 if rows["base"].iloc[0] else 4}
        panel.plot(aside, rows["pressure_kPa"], label=name, **look)
        panel.vlines(aside, rows["low_kPa"], rows["high_kPa"], color=look["color"], linewidth=0.9)
    panel.set_xticks(range(len(AREAS)), [AREAS[area] for area in dict.fromkeys(part["area"])])


def _cell(cube: xr.Dataset) -> str:
    """Size of a cell over the wall in words."""
    levels = cube["wall_level_height"].isel(setting=0, filling=0).values
    return f"{1e3 * (levels[1] - levels[0]):.3g} mm high and 1/{cube.sizes['wall_turn']} of the way around"


def _message(table: pd.DataFrame) -> str:
    """Sentence on the largest changes from the finest settings, and of which they are."""
    told = []
    for words, of in (("on one cell", "1x1"), ("on a ring", "ring")):
        rows = table[(table["area"] == of) & table["change"].notna()]
        worst = rows.loc[rows["change"].abs().idxmax()]
        off, half = 100.0 * worst["change"], 100.0 * worst["change_interval"]
        told.append(f"{words} by {off:+.0f} ± {half:.0f}\u00a0% ({worst['ladder']} {worst['setting']})")
    return f"The largest mean pressure in flow differs most from that of the finest {' and '.join(told)}"
