"""Variables of the cube on outlets and on the mass that leaves through them, of any grains."""

from collections.abc import Mapping

import numpy as np

from silostudy.dem.branch import acted
from silostudy.dem.run import Run

Spans = Mapping[str, tuple[float, float]]  # left and right edge (m) of each outlet, by its name


def passages(run: Run) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times (s) at which bodies left by the outlets, in order, their mass (kg, of discs kg/m), and the number of the outlet.

    Spheres leave as they pass the level of the outlet, also those not yet away; discs are counted once they are away.
    """
    passed = sorted([*run.recording.passed, *run.passing(np.ones(run.engine.n, bool))])
    time, mass, outlet = np.array(passed, float).reshape(-1, 3).T
    return time, mass, outlet.astype(int)


def mean_outflow(run: Run) -> float:
    """Mass over time (kg/s, of discs kg/(m s)) between the first body that left and the last; nan of fewer than two times."""
    time, mass, _ = passages(run)
    return mean_rate(time, mass)


def mean_rate(time: np.ndarray, mass: np.ndarray) -> float:
    """Mass over time between the first passage and the last; nan of fewer than two times."""
    if not len(time) or not np.ptp(time) > 0.0:
        return np.nan
    return float(mass[time > time[0]].sum() / np.ptp(time))


def outlet_arrays(run: Run, widths: Mapping[str, float], spans: Spans) -> dict[str, np.ndarray]:
    """The mass that left, from none at the run's start on; and of outlets with names, where each is, when it opened, its mass.

    widths: width (m) of every outlet, those without names too; spans: edges of those with names.
    """
    time, mass, outlet = passages(run)
    if not widths and not len(time):
        return {}
    last = np.flatnonzero(np.diff(time, append=np.inf))  # those that pass in one step count together
    began = run.began * run.engine.model.dt
    data = {"outflow_time": np.r_[began, time[last]], "outflow_mass": np.r_[0.0, np.cumsum(mass)[last]]}
    if not spans:
        return data
    through = outlet[:, None] == np.arange(len(spans))
    left, right = np.array(list(spans.values())).T
    by_outlet = np.cumsum(mass[:, None] * through, axis=0)[last]
    opened, whole = opened_at(run, widths)
    return data | {
        "outlet": np.array(list(spans)), "outlet_left": left, "outlet_right": right,
        "outlet_opened": opened, "outlet_whole": whole,
        "outlet_outflow_mass": np.vstack([np.zeros(len(spans)), by_outlet]),
        "outlet_mean_outflow": np.array([mean_rate(time[own], mass[own]) for own in through.T]),
    }  # fmt: skip


def opened_at(run: Run, widths: Mapping[str, float]) -> np.ndarray:
    """Times (s; 2, outlets) at which each outlet, by its name and width (m), opened, and was open altogether, in the run or in
    those that it goes on from; nan: it did not."""
    times = dict.fromkeys(widths, (np.nan, np.nan))
    for when, event in acted(run):
        if event.action in ("open", "open holes"):
            names, speed = event.what[1:] if event.action == "open holes" else (tuple(widths), 0.0)
            lasts = {name: widths[name] / speed if speed else 0.0 for name in names if name in widths}
            times |= {name: (when, when + long) for name, long in lasts.items() if np.isnan(times[name][0])}
    return np.array(list(times.values()), float).reshape(-1, 2).T


def outlet_notes(run: Run, widths: Mapping[str, float]) -> dict[str, float]:
    """Attributes on the one outlet of a scene that has no name: when it opened and was open altogether (s)."""
    opened, whole = opened_at(run, widths)
    return {"outlet_opened_s": float(opened[0]), "outlet_whole_s": float(whole[0])} if np.isfinite(opened).any() else {}
