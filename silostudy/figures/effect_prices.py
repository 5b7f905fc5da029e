"""What each effect of the engine and each optional part of a stage costs: share of time, instructions and memory."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import save

COLOURS = {
    "discrete elements": "#0072b2",
    "scenes and studies of discs": "#56b4e9",
    "pressures": "#d55e00",
    "shells": "#882255",
    "earthquake": "#009e73",
}
PANELS = {"time": "CPU time with it", "instruction": "instructions with it", "memory": "memory with it"}
ENDS = ("effect_time_share_low", "effect_time_share_high")
COLUMNS = ("effect_room", *(f"effect_{name}_share" for name in PANELS), *ENDS)


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the price list; beside a missing count stands why it is missing."""
    names = ("effect", *COLUMNS, "effect_uncounted")
    prices = pd.DataFrame({name: cube[name].to_numpy() for name in names})
    figure, axes = plt.subplots(1, 3, figsize=(15, 0.42 * len(prices) + 1.9), sharey=True)
    for axis, (name, what) in zip(axes, PANELS.items(), strict=True):
        panel(axis, prices, name)
        axis.set(
            xlabel=f"share of the {what} (%)",
            title=name if name != "instruction" else "instructions, by callgrind (no AVX-512)",
        )
    axes[0].set_title("time: median and quartiles of the turns")
    axes[0].set_yticks(range(len(prices)), prices["effect"], fontsize=8)
    axes[0].set_ylim(len(prices) - 0.4, -0.6)
    rooms = [room for room in COLOURS if room in set(prices["effect_room"])]
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLOURS[room]) for room in rooms]
    figure.legend(handles, rooms, loc="outside lower center", ncols=len(rooms))
    figure.suptitle(f"What effects and optional parts cost; {cube.attrs['machine']}, {cube.attrs['measured_on']}", fontsize=10)
    save(figure, prices, stem)


def panel(axis, prices: pd.DataFrame, name: str) -> None:
    """Bars of one share (%), with the quartiles where there are some, and its number at each."""
    share = 100 * prices[f"effect_{name}_share"]
    low, high = (100 * prices[end] for end in ENDS) if name == "time" else (share, share)
    bars = {"xerr": [share - low, high - share], "error_kw": {"elinewidth": 1, "capsize": 3}} if name == "time" else {}
    axis.barh(range(len(prices)), share, color=[COLOURS[room] for room in prices["effect_room"]], **bars)
    for place, (number, end, why) in enumerate(zip(share, high, prices["effect_uncounted"], strict=True)):
        known = np.isfinite(number)
        look = {"fontsize": 7.5} if known else {"fontsize": 6, "color": "grey"}
        text = f"{round(number) + 0} %" if known else why
        axis.text(max(np.nan_to_num(end), 0) + 1, place, text, va="center", **look)
    axis.axvline(0, color="black", linewidth=0.8)
    axis.set_xlim(min(0, float(np.nan_to_num(high).min()) * 1.15 - 2), 112)
