"""What each effect of the engine and each optional part of the other stages costs: share of time and of memory."""

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
COLUMNS = ("effect_room", "effect_time_share", "effect_time_share_low", "effect_time_share_high", "effect_memory_share")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the price list."""
    prices = pd.DataFrame({"effect": cube["effect"].to_numpy(), **{name: cube[name].to_numpy() for name in COLUMNS}})
    figure, (time, memory) = plt.subplots(1, 2, figsize=(12, 0.42 * len(prices) + 1.9), sharey=True)
    places = np.arange(len(prices))
    colours = [COLOURS[room] for room in prices["effect_room"]]
    share = 100 * prices["effect_time_share"]
    low, high = (100 * prices[f"effect_time_share_{end}"] for end in ("low", "high"))
    time.barh(places, share, xerr=[share - low, high - share], color=colours, error_kw={"elinewidth": 1, "capsize": 3})
    memory.barh(places, 100 * prices["effect_memory_share"], color=colours)
    for axis, values in ((time, high), (memory, 100 * prices["effect_memory_share"])):
        for place, value, number in zip(places, values, share if axis is time else values, strict=True):
            axis.text(max(value, 0) + 1, place, f"{round(number) + 0} %", va="center", fontsize=7.5)
        axis.axvline(0, color="black", linewidth=0.8)
        axis.set_xlim(min(0, float(values.min()) * 1.15 - 2), 112)
    time.set_yticks(places, prices["effect"], fontsize=8)
    time.set_ylim(len(prices) - 0.4, -0.6)
    time.set(xlabel="share of the CPU time with it (%)", title="time: median and quartiles of the turns")
    memory.set(xlabel="share of the memory with it (%)", title="memory")
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour) for colour in COLOURS.values()]
    figure.legend(handles, COLOURS, loc="outside lower center", ncols=len(COLOURS))
    figure.suptitle(f"What effects and optional parts cost; {cube.attrs['machine']}, {cube.attrs['measured_on']}", fontsize=10)
    save(figure, prices, stem)
