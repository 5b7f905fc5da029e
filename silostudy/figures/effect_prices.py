"""Price of each effect of discs and each optional part of a stage: share of time, instructions and memory."""

from pathlib import Path
from textwrap import fill

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import COLOURS as PALETTE
from silostudy.figures.style import HATCHES, TALLEST, WIDTH, foot, headline, save

ROOMS = ("discs", "scenes and studies of discs", "pressures", "shells", "earthquake")
LETTERS = 42  # in a line of a name
PANELS = {"time": "CPU time", "instruction": "instructions", "memory": "memory"}
ENDS = ("effect_time_share_low", "effect_time_share_high")
COLUMNS = ("effect_room", *(f"effect_{name}_share" for name in PANELS), *ENDS)


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the price list of all but spheres."""
    draw_rooms(cube, stem, ROOMS)


def draw_rooms(cube: xr.Dataset, stem: Path, rooms: tuple[str, ...]) -> None:
    """Writes the figure and the price list of some rooms; beside a missing count stands why it is missing."""
    names = ("effect", *COLUMNS, "effect_uncounted")
    prices = pd.DataFrame({name: cube[name].to_numpy() for name in names})
    prices = prices[prices["effect_room"].isin(rooms)].reset_index(drop=True)
    prices["effect"] = prices["effect"].str.removesuffix(", of spheres")  # which the rooms say
    figure, axes = plt.subplots(1, 3, figsize=(WIDTH, min(TALLEST, 0.36 * len(prices) + 2.4)), sharey=True)
    for axis, (name, what) in zip(axes, PANELS.items(), strict=True):
        panel(axis, prices, name, looks(rooms))
        axis.set(xlabel="share with it (%)", title=what)
    axes[0].set_yticks(range(len(prices)), [fill(str(effect), LETTERS) for effect in prices["effect"]])
    axes[0].set_ylim(len(prices) - 0.4, -0.6)
    shown = [room for room in rooms if room in set(prices["effect_room"])]
    handles = [plt.Rectangle((0, 0), 1, 1, label=room, **looks(rooms)[room]) for room in shown]
    headline(figure, _message(prices))
    about = "Time: median and quartiles of the turns. Instructions: by callgrind (no AVX-512)."
    foot(figure, f"{cube.attrs['title']}: {cube.attrs['machine']}, {cube.attrs['measured_on']}.", about, handles=handles)
    save(figure, prices, stem)


def _message(prices: pd.DataFrame) -> str:
    """The dearest effect, and how many cost less than a tenth of the time."""
    share = prices["effect_time_share"]
    dearest = f"The dearest part is {prices['effect'][share.idxmax()]}, {100 * share.max():.0f} % of the time with it"
    return f"{dearest}; {(share < 0.1).sum()} of {len(share)} cost under 10\u00a0%"


def looks(rooms: tuple[str, ...]) -> dict[str, dict]:
    """Colour and hatch of each room."""
    return {room: {"facecolor": PALETTE[k], "hatch": HATCHES[k], "edgecolor": "white"} for k, room in enumerate(rooms)}


def panel(axis, prices: pd.DataFrame, name: str, look: dict[str, dict]) -> None:
    """Bars of one share (%), with the quartiles where there are some, and its number at each."""
    share = 100 * prices[f"effect_{name}_share"]
    low, high = (100 * prices[end] for end in ENDS) if name == "time" else (share, share)
    bars = {"xerr": [share - low, high - share], "error_kw": {"elinewidth": 1, "capsize": 3}} if name == "time" else {}
    drawn = axis.barh(range(len(prices)), share, **bars)
    for bar, room in zip(drawn, prices["effect_room"], strict=True):
        bar.set(**look[room])
    for place, (number, end, why) in enumerate(zip(share, high, prices["effect_uncounted"], strict=True)):
        known = np.isfinite(number)
        ink = {} if known else {"color": "0.4"}
        text = f"{round(number) + 0} %" if known else why
        axis.text(max(np.nan_to_num(end), 0) + 1, place, text, va="center", fontsize="small", **ink)
    axis.axvline(0, color="black", linewidth=0.8)
    axis.set_xlim(min(0, float(np.nan_to_num(high).min()) * 1.15 - 2), 130)
