"""Moments of a scene of grains: what happened when, which snapshots show it, and how events are marked over time."""

from collections.abc import Sequence
from itertools import product

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke

from silostudy.figures.bin import began, open_before, opened_at, opening
from silostudy.figures.flow_in_time import Flow
from silostudy.figures.style import INK

APART = 13.0  # points between two lines of words that stand beside each other, upright
OFF = 2.0  # points between the words of an event and its line
MOST = 3  # words of events that come too close after each other to be written apart


def words(cube: xr.Dataset) -> list[str]:
    """Words of each event: what was done, and on what, without what it waited for and its values."""
    done = [str(action).split(": ")[1].split(" ", 1) for action in cube["event_action"].values]
    return [" ".join([what[0].replace("_", " "), *what[1:]]) for what in done]


def first(cube: xr.Dataset) -> tuple[float, str]:
    """Time (s) and words of the first event that does something with the grains; endless and none where they are left alone."""
    for time, what in zip(cube["event_time"].values, words(cube), strict=True):
        if what != "stop":
            return float(time), what
    return np.inf, ""


def snapshots(cube: xr.Dataset, force: np.ndarray, flow: Flow) -> list[int]:
    """The snapshots that show a scene, before and after: see `told`; force: of each contact.

    One alone where both are the same, and none without a grain.
    """
    time, load, held = cube["snapshot_time"].values, _load(cube, force), _held(cube)
    until, _ = _before(cube, flow)
    before, later = held[time[held] <= until][-1:], held[time[held] > until]
    if not len(flow.table):
        after = later[np.argsort(load[later])[-1:]]
    else:
        after = later[np.argsort(np.abs(time[later] - flow.halfway), kind="stable")[:1]]
    return [int(shot) for shot in (*before, *after)]


def told(shots: Sequence[int], cube: xr.Dataset, flow: Flow) -> str:
    """Words on which snapshots are shown; none of a single one."""
    if len(shots) < 2:
        return ""
    after = "that nearest to when half of what leaves is out" if len(flow.table) else "that with the largest forces since"
    return f"Snapshots: the {_before(cube, flow)[1]}, and {after}. "


def _before(cube: xr.Dataset, flow: Flow) -> tuple[float, str]:
    """Time (s) until which a snapshot shows the scene before, and words on that one: the last, or the first of a flow."""
    if open_before(cube).any():
        return float(cube["snapshot_time"][_held(cube)[0]]), "first"
    if np.isfinite(opened := opened_at(cube)):
        return opened, f"last before {opening(cube)}"
    if len(flow.table):  # a feeder takes from what is shut
        return np.nextafter(flow.begins, -np.inf), "last before any grain has left"
    return first(cube)[0], "last before the first event"


def _held(cube: xr.Dataset) -> np.ndarray:
    """Numbers of the snapshots that hold grains; all where none does."""
    there = np.isfinite(cube["disc_y" if "disc" in cube.dims else "grain_z"].values).any(axis=1)
    return np.flatnonzero(there | ~there.any())


def _load(cube: xr.Dataset, force: np.ndarray) -> np.ndarray:
    """Sum of the forces of all contacts of each snapshot."""
    shot = cube["contact_snapshot"].values if "contact_snapshot" in cube else np.zeros(0, int)
    return np.bincount(shot, weights=force, minlength=cube.sizes["snapshot"])


def mark_events(panels: Sequence[Axes], cube: xr.Dataset, inches: float) -> None:
    """A line at each event, with its words in the first panel, so many inches wide; of those that are close, words together."""
    if not panels:
        return
    (low, high), times, done = panels[0].get_xlim(), cube["event_time"].values, words(cube)
    for panel, time in product(panels, times):
        panel.axvline(time, color="0.6", linewidth=0.8)
    apart = APART / 72 / inches * (high - low)
    for group in _groups(times, apart):
        when, said = float(times[group[0]]), _joined([done[number] for number in group])
        aside, place = (1.0 if when - low < apart else -1.0), panels[0].get_xaxis_transform()
        look: dict = {"va": "top", "ha": "left" if aside > 0.0 else "right", "fontsize": "small", "color": INK, "rotation": 90}
        text = panels[0].annotate(said, (when, 0.98), (OFF * aside, 0.0), place, "offset points", **look)
        text.set_path_effects([withStroke(linewidth=2.5, foreground="white")])


def _groups(times: np.ndarray, apart: float) -> list[list[int]]:
    """Numbers of events that come less than `apart` after the first of their group."""
    groups: list[list[int]] = []
    for number, time in enumerate(times):
        if groups and time - times[groups[-1][0]] < apart:
            groups[-1].append(number)
        else:
            groups.append([number])
    return groups


def _joined(said: list[str]) -> str:
    """Words of events one after the other, those beyond MOST by their count."""
    return ", ".join(said[:MOST] + ([f"{len(said) - MOST} more"] if len(said) > MOST else []))


def begins(cube: xr.Dataset) -> tuple[float, str]:
    """Time (s) at which the outlet opens, or else the first event comes, and how a sentence on what follows begins.

    Where an outlet was open before, the start of the run.
    """
    if open_before(cube).any():
        return began(cube), f"From {began(cube):.3g} s on"
    opened, (time, what) = opened_at(cube), first(cube)
    if np.isfinite(opened):
        return opened, f"Once {opening(cube)}"
    return time, f"From \N{LEFT DOUBLE QUOTATION MARK}{what}\N{RIGHT DOUBLE QUOTATION MARK} on"
