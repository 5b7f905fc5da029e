"""Parts that the seismic figures share: one panel a case, looks of coefficients, the source's rows, the note on assumptions."""

from collections.abc import Iterable

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.figure import Figure

from silostudy.figures.style import foot, headline
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.sasaki_1991 import PrintedTest, printed_at

MOST = 3  # cases side by side; more do not fit a page
LINES = ("-", (0, (6, 2)), (0, (3, 1.5, 1, 1.5)), (0, (1, 1.2)), (0, (8, 2, 1, 2, 1, 2)))
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9")
MEASURED = "#9a9a9a"


def cases(cube: xr.Dataset) -> list[xr.Dataset]:
    """The first cases of a cube, each without sweep axes."""
    axes = cube.attrs["sweep_axes"].split()
    if not axes:
        return [cube]
    shape = tuple(cube.sizes[axis] for axis in axes)
    places = [np.unravel_index(n, shape) for n in range(min(MOST, int(np.prod(shape))))]
    return [cube.isel(dict(zip(axes, map(int, place), strict=True))) for place in places]


def name(case: xr.Dataset) -> str:
    """A case by its shaking: the peak acceleration of the base."""
    peak = float(np.abs(case["base_acceleration"]).max())
    return f"base peak {peak * 100:.3g} gal ({peak / STANDARD_GRAVITY:.2f} g)"


def kind(case: xr.Dataset) -> str:
    """Whether the response of a case was measured, or stands for a measurement."""
    return "synthetic measurement" if str(case["measured_origin"].values).startswith("synthetic") else "measured"


def printed(cube: xr.Dataset, case: xr.Dataset) -> PrintedTest | None:
    """The source's row for a case, where the study asks for it."""
    if cube.attrs["published"] != "sasaki_1991":
        return None
    return printed_at(float(np.abs(case["base_acceleration"]).max()))


def answer(case: xr.Dataset, key: str, half_width: str = "", places: int = 3) -> str:
    """The coefficient of an index, with its uncertainty where that is stated; an end of the candidates is said to be so."""
    here = case.sel(identification=key)
    text, end = f"{float(here['effective_mass_coefficient']):.{places}f}", int(here["candidate_end"])
    if end:
        return f"{text}, {'lowest' if end < 0 else 'highest'} candidate: may lie beyond"
    if half_width and np.isinf(case[half_width]):
        return f"{text}, to beyond the candidates"
    return f"{text} ± {float(case[half_width]):.{places}f}" if half_width else text


def nearest(case: xr.Dataset) -> float:
    """The coefficient among those that are shown which is next to the one that the amplitudes answer with."""
    shown = case["shown_coefficient"].values
    answered = float(case["effective_mass_coefficient"].sel(identification="amplitude_error"))
    return float(shown[np.argmin(np.abs(shown - answered))])


def distance(computed: np.ndarray, measured: np.ndarray) -> float:
    """Root mean square of the difference of two series over that of the measured one (1)."""
    return float(np.sqrt(np.nanmean((computed - measured) ** 2) / np.nanmean(measured**2)))


def style(number: int) -> dict:
    """Line of the n-th curve: colour and dashes."""
    return {"linestyle": LINES[number % len(LINES)], "color": COLOURS[number % len(COLOURS)]}


def head(figure: Figure, cube: xr.Dataset, message: str, *remarks: str, base: str = "", handles: Iterable[Artist] = ()) -> None:
    """Message above the panels; below them model, remarks, what shook it (or `base`), what is assumed, the legend."""
    headline(figure, message)
    shaken = [f"Base: {_common(cube, 'base_motion')}."]
    if "measured_origin" in cube:
        shaken.append(f"Measured: {_common(cube, 'measured_origin')}.")
    notes = [base] if base else shaken
    if cube.attrs["assumed"]:
        told = "Assumed, not printed by the source" if cube.attrs["published"] else "Assumed"
        notes.append(f"{told}: {cube.attrs['assumed']}.")
    foot(figure, f"{cube.attrs['title']}.", *remarks, *notes, handles=handles)


def _common(cube: xr.Dataset, variable: str) -> str:
    texts = list(dict.fromkeys(map(str, np.atleast_1d(cube[variable].values).ravel())))
    return " / ".join(texts[:MOST])
