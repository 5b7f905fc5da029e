"""Forces of whole windows before a run's first event and after it, and what sweeps tell of one sort of grains."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.dem.run import Run
from silostudy.dem.walls import sums_by_wall

Numbers = dict[str, np.ndarray]


@dataclass(frozen=True)
class OfFillings:
    """A quantity whose mean over fillings an accuracy may be asked of: it in a case's numbers, and its expected scatter.

    scatter: relative standard deviation (1) of a filling times the root of its grains, of small scenes of ours.
    """

    read: Callable[[Numbers], float]
    scatter: float


@dataclass(frozen=True)
class Swept:
    """Numbers that sweeps take of scenes of one sort of grains.

    bodies: what bears on the grains -> the names that its walls have, or begin with; numbers(run, time of its first event) ->
    those of a case; grains: name of the number of grains; asked: what an accuracy may be asked of, by the names in
    tables/asked.csv.
    """

    bodies: Mapping[str, tuple[str, ...]]
    numbers: Callable[[Run, float], Numbers]
    grains: str
    asked: Mapping[str, OfFillings]


@dataclass(frozen=True)
class Felt:
    """Loads on a surface: pressure and shear (Pa) of its cells (windows, levels, turns, two, mean and least and largest), and
    the height (m) of the middle of each level."""

    cells: np.ndarray
    height: np.ndarray


@dataclass(frozen=True)
class Walled:
    """Readings of the walls of silos of one sort of grains, level by level.

    keeps(scene): whether they are; cells(scene): how many levels, and the angles (rad) of a level's cells about the axis;
    contents(run, scene): height (m) of the level surface above the transition and unit weight (N/m3); felt(run, scene): what
    `wall` and `hopper` felt.
    """

    keeps: Callable[[Any], bool]
    cells: Callable[[Any], tuple[int, np.ndarray]]
    contents: Callable[[Run, Any], tuple[float, float]]
    felt: Callable[[Run, Any], dict[str, Felt]]


def at_rest_and_largest(run: Run, opening: float, sums: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Value of the last window before `opening` (s), and largest value of a window after, of each column of sums (window, ...).

    Of whole windows: a mean over less is no match for them.  NaN where none is recorded before or after, or no event came.
    """
    time, whole = np.array(run.recording.window_time), whole_windows(run)
    missing = np.full(sums.shape[1:], np.nan)
    if not whole.any() or np.isnan(opening):
        return missing, missing
    time, sums = time[whole], sums[whole]
    before = np.searchsorted(time, opening + 1e-9)
    return (sums[before - 1] if before else missing), (sums[before:].max(axis=0) if before < len(sums) else missing)


def whole_windows(run: Run) -> np.ndarray:
    """Mask of the windows of full length; they end with a step, which may be a part of it later."""
    model = run.engine.model
    short = run.window - (np.array(run.recording.window_time) - begins(run)) / model.dt
    return np.abs(short) < model.pace.longest - 0.5


def begins(run: Run) -> np.ndarray:
    """Times (s) at which the windows begin."""
    return np.array([run.began * run.engine.model.dt, *run.recording.window_time[:-1]])[: len(run.recording.window_time)]


def by_body(run: Run, cells: np.ndarray, bodies: Mapping[str, tuple[str, ...]]) -> np.ndarray:
    """Sums (window, body) of what cells (window, cell) hold over the walls of each body; a silo need not have all of them.

    What is missing in a cell, as the load on a line is, adds nothing.
    """
    held_by_wall = sums_by_wall(run.engine.model, np.nan_to_num(cells), axis=1)
    held_by_body = {body: np.zeros(len(cells)) for body in bodies}
    for body, stems in bodies.items():
        for name, held in held_by_wall.items():
            if any(f"{name}_".startswith(f"{stem}_") for stem in stems):
                held_by_body[body] += held
    return np.column_stack(list(held_by_body.values()))
