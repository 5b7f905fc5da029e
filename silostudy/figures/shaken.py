"""What the seismic figures share: one panel a case, line styles of coefficients, the source's rows, the note on assumptions."""

import textwrap

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.sasaki_1991 import PrintedTest, printed_at

MOST = 3  # cases side by side; more do not fit a page
LINES = ("-", (0, (6, 2)), (0, (3, 1.5, 1, 1.5)), (0, (1, 1.2)), (0, (8, 2, 1, 2, 1, 2)))
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9")
MEASURED = "#9a9a9a"


def cases(cube: xr.Dataset) -> list[xr.Dataset]:
    """The first cases of a cube, each without sweep axes."""
    axes = cube.attrs["sweep_axes"].split()
    if not axes:
        return [cube]
    shape = tuple(cube.sizes[axis] for axis in axes)
    places = [np.unravel_index(n, shape) for n in range(min(MOST, int(np.prod(shape))))]
    return [cube.isel(dict(zip(axes, map(int, place), strict=True))) for place in places]


def name(one: xr.Dataset) -> str:
    """A case by its shaking: the peak acceleration of the base."""
    peak = float(np.abs(one["base_acceleration"]).max())
    return f"base peak {peak * 100:.3g} gal ({peak / STANDARD_GRAVITY:.2f} g)"


def kind(one: xr.Dataset) -> str:
    """Whether the response of a case was measured, or stands for a measurement."""
    return "synthetic measurement" if str(one["measured_origin"].values).startswith("synthetic") else "measured"


def printed(cube: xr.Dataset, one: xr.Dataset) -> PrintedTest | None:
    """The source's row for a case, where the study asks for it."""
    if cube.attrs["published"] != "sasaki_1991":
        return None
    return printed_at(float(np.abs(one["base_acceleration"]).max()))


def answer(one: xr.Dataset, key: str, half_width: str = "", places: int = 3) -> str:
    """A coefficient found, with its uncertainty where one is stated; one at the end of the candidates is said to be so."""
    here = one.sel(identification=key)
    text, end = f"{float(here['effective_mass_coefficient']):.{places}f}", int(here["candidate_end"])
    if end:
        return f"{text}, {'lowest' if end < 0 else 'highest'} candidate: may lie beyond"
    if half_width and np.isinf(one[half_width]):
        return f"{text}, to beyond the candidates"
    return f"{text} ± {float(one[half_width]):.{places}f}" if half_width else text


def style(number: int) -> dict:
    """Line of the n-th curve: colour and dashes."""
    return {"linestyle": LINES[number % len(LINES)], "color": COLOURS[number % len(COLOURS)]}


def head(figure: Figure, cube: xr.Dataset, text: str, base: str = "") -> None:
    """Title, and below the panels what is synthetic, which record shook (or `base`), and what is assumed."""
    figure.suptitle(f"{cube.attrs['title']}\n{text}", fontsize=10)
    shaken = [f"Base: {_common(cube, 'base_motion')}."]
    if "measured_origin" in cube:
        shaken.append(f"Measured: {_common(cube, 'measured_origin')}.")
    notes = [base] if base else shaken
    if cube.attrs["assumed"]:
        told = "Assumed, not printed by the source" if cube.attrs["published"] else "Assumed"
        notes.append(f"{told}: {cube.attrs['assumed']}.")
    note = "\n".join(line for text in notes for line in textwrap.wrap(text, int(figure.get_figwidth() * 19)))
    figure.supxlabel(note, fontsize=6.5, x=0.01, ha="left", color="#444444")


def _common(cube: xr.Dataset, variable: str) -> str:
    texts = list(dict.fromkeys(map(str, np.atleast_1d(cube[variable].values).ravel())))
    return " / ".join(texts[:MOST])
