"""Price of each effect of the engine and each optional part of a stage: share of time, instructions and memory."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import COLOURS as PALETTE
from silostudy.figures.style import HATCHES, TALLEST, WIDTH, foot, headline, save

ROOMS = ("discrete elements", "scenes and studies of discs", "pressures", "shells", "earthquake")
LOOKS: dict[str, dict] = {
    room: {"facecolor": PALETTE[k], "hatch": HATCHES[k], "edgecolor": "white"} for k, room in enumerate(ROOMS)
}
PANELS = {"time": "CPU time", "instruction": "instructions", "memory": "memory"}
ENDS = ("effect_time_share_low", "effect_time_share_high")
COLUMNS = ("effect_room", *(f"effect_{name}_share" for name in PANELS), *ENDS)


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the price list; beside a missing count stands why it is missing."""
    names = ("effect", *COLUMNS, "effect_uncounted")
    prices = pd.DataFrame({name: cube[name].to_numpy() for name in names})
    figure, axes = plt.subplots(1, 3, figsize=(WIDTH, min(TALLEST, 0.36 * len(prices) + 2.4)), sharey=True)
    for axis, (name, what) in zip(axes, PANELS.items(), strict=True):
        panel(axis, prices, name)
        axis.set(xlabel="share with it (%)", title=what)
    axes[0].set_yticks(range(len(prices)), [fill(str(effect), 34) for effect in prices["effect"]])
    axes[0].set_ylim(len(prices) - 0.4, -0.6)
    rooms = [room for room in ROOMS if room in set(prices["effect_room"])]
    handles = [plt.Rectangle((0, 0), 1, 1, label=room, **LOOKS[room]) for room in rooms]
    headline(figure, _message(prices))
    about = "Time: median and quartiles of the turns. Instructions: by callgrind (no AVX-512)."
    foot(figure, f"{cube.attrs['title']}: {cube.attrs['machine']}, {cube.attrs['measured_on']}.", about, handles=handles)
    save(figure, prices, stem)


def _message(prices: pd.DataFrame) -> str:
    """The dearest effect, and how many cost less than a tenth of the time."""
    share = prices["effect_time_share"]
    dearest = f"The dearest part is {prices['effect'][share.idxmax()]}, {100 * share.max():.0f} % of the time with it"
    return f"{dearest}; {(share < 0.1).sum()} of {len(share)} cost under 10 %"


def panel(axis, prices: pd.DataFrame, name: str) -> None:
    """Bars of one share (%), with the quartiles where there are some, and its number at each."""
    share = 100 * prices[f"effect_{name}_share"]
    low, high = (100 * prices[end] for end in ENDS) if name == "time" else (share, share)
    bars = {"xerr": [share - low, high - share], "error_kw": {"elinewidth": 1, "capsize": 3}} if name == "time" else {}
    drawn = axis.barh(range(len(prices)), share, **bars)
    for bar, room in zip(drawn, prices["effect_room"], strict=True):
        bar.set(**LOOKS[room])
    for place, (number, end, why) in enumerate(zip(share, high, prices["effect_uncounted"], strict=True)):
        known = np.isfinite(number)
        look = {} if known else {"color": "0.4"}
        text = f"{round(number) + 0} %" if known else why
        axis.text(max(np.nan_to_num(end), 0) + 1, place, text, va="center", fontsize="small", **look)
    axis.axvline(0, color="black", linewidth=0.8)
    axis.set_xlim(min(0, float(np.nan_to_num(high).min()) * 1.15 - 2), 130)
