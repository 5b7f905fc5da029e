"""Style of every figure, and how it is saved: PNG, SVG that is the same each time, and the numbers shown as CSV.

The page of the report shows a picture at least 1000 px wide in a window of 1400 px, and never larger than it is.  A figure is
WIDTH wide, so that "small", the smallest words of it, have 12 px there: sizes are said by name ("small", "medium", "large"),
never in points.  The report centres a picture and cuts its head off where the window is too low: one that is drawn with DPI
and at most TALLEST shows its headline in a window of 1080 px.
"""

from collections.abc import Iterable
from pathlib import Path
from textwrap import fill
from typing import Any

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from cycler import cycler
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke

from silostudy.files import replacing

# of a figure, inches
WIDTH = 10.0
TALLEST = 9.6
DPI = 110
# Okabe and Ito's colours, which the colour-blind tell apart; their yellow is left out, too pale for a line on white
COLOURS = (
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9", "#CC79A7", "#000000",
)  # fmt: skip
BLUE, VERMILION, GREEN, ORANGE, SKY, PURPLE, BLACK = COLOURS
MARKERS = "os^Dv<>Ph*X"
LINES: tuple = ("-", (0, (4, 2)), (0, (1, 1)), (0, (6, 2, 1, 2)), (0, (3, 1, 1, 1, 1, 1)))
HATCHES = ("", "////", "....", "\\\\\\\\", "xxxx", "||||", "----")
INK = "0.25"  # of remarks
REST: dict[str, Any] = {
    "color": "0.78",
    "linewidth": 1.0,
    "linestyle": "-",
    "marker": "none",
    "zorder": 1,
}  # what is not the point
NAMED = "named"  # gid of a curve whose name stands at it
AID = "aid"  # gid of what helps the eye and shows no number of the table: the outline of a silo, a bar of scale
PHASE_LINES = {"switch": (0, (1, 1)), "filling": (0, (4, 2)), "discharge": "-"}
plt.rcParams.update(
    {
        "svg.hashsalt": "silostudy",
        "font.size": 10.5,
        "figure.titlesize": "large",
        "figure.titleweight": "bold",
        "axes.titlesize": "medium",
        "axes.labelsize": "medium",
        "xtick.labelsize": "small",
        "ytick.labelsize": "small",
        "legend.fontsize": "small",
        "legend.title_fontsize": "small",
        "axes.prop_cycle": cycler(color=COLOURS),
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.alpha": 0.25,
        "hatch.linewidth": 0.6,
        "legend.frameon": False,
        "legend.handlelength": 2.8,  # dashes of any line show beside its marker
        "figure.constrained_layout.use": True,
    }
)


def series(number: int) -> dict[str, Any]:
    """Look of the curve of that number among others: colour, marker and line differ, so that black and white are enough."""
    return {
        "color": COLOURS[number % len(COLOURS)],
        "marker": MARKERS[number % len(MARKERS)],
        "linestyle": LINES[number % len(LINES)],
    }


def headline(figure: Figure, message: str) -> None:
    """Puts over a figure what it says, in numbers of its data."""
    figure.suptitle(fill(message, int(9.6 * figure.get_figwidth())), x=0.01, ha="left")


def foot(figure: Figure, *remarks: str, handles: Iterable[Artist] = ()) -> None:
    """Puts under a figure which silo it is and how to read it, and below that the legend of handles."""
    told = "\n".join(fill(remark, int(15.5 * figure.get_figwidth())) for remark in remarks if remark)
    shown = list(handles)
    columns = _columns([str(handle.get_label()) for handle in shown], int(15.0 * figure.get_figwidth()))
    figure.legend(handles=shown, title=told, loc="outside lower left", ncols=columns, alignment="left")


def _columns(labels: list[str], room: int) -> int:
    """The most columns of a legend that have room, in letters, beside each other."""
    lengths = [max(map(len, label.split("\n"))) + 9 for label in labels]  # with the mark and a gap
    fits = (count for count in range(len(lengths), 1, -1) if sum(map(max, np.array_split(lengths, count))) <= room)
    return next(fits, 1)


def point_out(panel: Axes, words: str, point: tuple[float, float], offset: tuple[float, float], **options: Any) -> None:
    """Writes words at an offset (points) from a point of a panel's data, with a thin line to it."""
    placed: dict[str, Any] = {"textcoords": "offset points", "fontsize": "small", "va": "center"}
    placed |= {"ha": "left" if offset[0] >= 0 else "right"}
    placed |= {"arrowprops": {"arrowstyle": "-", "color": INK, "linewidth": 0.8, "shrinkB": 3}}
    text = panel.annotate(words, point, offset, **placed | options)
    text.set_path_effects([withStroke(linewidth=2.5, foreground="white")])


def save(figure: Figure, numbers: pd.DataFrame, stem: Path) -> None:
    """Writes stem.png, stem.svg and stem.csv, each under a temporary name first."""
    for suffix, options in ((".png", {"dpi": DPI}), (".svg", {"metadata": {"Date": None}})):
        with replacing(stem.with_suffix(suffix)) as temporary:
            figure.savefig(temporary, **options)
    plt.close(figure)
    save_table(numbers, stem.with_suffix(".csv"))


def save_table(numbers: pd.DataFrame, path: Path) -> None:
    """Writes a table as CSV, seven significant digits."""
    with replacing(path) as temporary:
        numbers.to_csv(temporary, index=False, float_format="%.7g")


def look(cube: xr.Dataset, method: str) -> dict:
    """Colour and marker of a method, as line properties."""
    row = cube.sel(pressure_method=method)
    return {"color": str(row.pressure_method_colour.values), "marker": str(row.pressure_method_marker.values)}


def title(cube: xr.Dataset, method: str) -> str:
    """Number and name of a method for a legend."""
    number = str(cube["pressure_method_number"].sel(pressure_method=method).values)
    return f"{number}  {name(cube, method)}" if number else name(cube, method)


def name(cube: xr.Dataset, method: str) -> str:
    """Name of a method for a headline."""
    return str(cube["pressure_method_title"].sel(pressure_method=method).values)


def drawn(cube: xr.Dataset, method: str) -> str:
    """Look of a method in a figure that compares many, as its row says."""
    return str(cube["pressure_method_drawn"].sel(pressure_method=method).values)


def phases_of_its_own(cube: xr.Dataset, method: str, static: str) -> list[str]:
    """Phases with a curve of their own: Jenike's filling, and all of 1969, are the static method's."""
    pressure = cube["wall_normal_pressure"]
    filling = pressure.sel(pressure_method=static, phase="filling")
    shown = []
    for phase in map(str, cube["phase"].values):
        curve = pressure.sel(pressure_method=method, phase=phase)
        same = method != static and np.allclose(curve, filling, rtol=1e-12, atol=0)
        if curve.notnull().any() and not same:
            shown.append(phase)
    return shown
