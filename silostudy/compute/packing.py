"""The packing stage: ensembles of discs at rest and in discharge, case by case, into one cube."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import chain

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved
from silostudy.choice.means import MOST, NORMAL, enough, mean_bound
from silostudy.compute.axes import stacked, sweep_of
from silostudy.compute.packing_measure import LOOKS, MEASURES, at_rest, in_flow
from silostudy.compute.packing_run import SAMPLE, WINDOW, discharge, settle
from silostudy.cube.assemble import assemble
from silostudy.scene.packing import LAYERS

SHARE = "rest_side_share"  # the quantity that an accuracy may be asked of
FIRST = 2  # runs beside the ideal start after which their scatter is looked at
PRIOR = 15  # runs that the front's scatter counts for: that of the silos it was measured on differed by 18 % from it
SOURCES = ("kiyama_fujimura_1983", "silo_handbook")


def packing_cube(expansion: Resolved, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of a packing study; `tell` hears how far it is.  Equal fillings are settled once, for all their slits."""
    asked = expansion.study.accuracy
    runs: list[list[dict]] = [[] for _ in expansion.cases]
    count = FIRST if asked else expansion.study.runs
    while len(runs[0]) <= count:
        _add_runs(expansion, runs, count, tell)
        count = max(enough(*of_case) for of_case in _asked(expansion, runs)) if asked else count
    return _cube(expansion, runs)


def _add_runs(expansion: Resolved, runs: list[list[dict]], count: int, tell: Callable[[str], None]) -> None:
    """Computes the runs of every case up to a number; run 0 is the ideal start."""
    tasks = [(members, run) for members in _groups(expansion) for run in range(len(runs[0]), count + 1)]
    fresh: dict[tuple[int, int], dict] = {}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        first = _of_one_filling(expansion, tasks[0])  # alone, so that the kernel is compiled once
        others = pool.map(partial(_of_one_filling, expansion), tasks[1:])
        for done, results in enumerate(chain([first], others), 1):
            fresh |= results
            if done * 20 // len(tasks) > (done - 1) * 20 // len(tasks):
                tell(f"{done} of {len(tasks)} fillings settled and let out")
    for case, of_case in enumerate(runs):
        of_case += [fresh[case, run] for run in range(len(of_case), count + 1)]


def _asked(expansion: Resolved, runs: list[list[dict]]) -> list[tuple[np.ndarray, float, float, int]]:
    """Values of the asked share of every case's runs, the error asked for, the scatter that the front expects, its weight."""
    (choice,) = expansion.choices
    scatter = scatter_of(choice.expected[SHARE], expansion.study.runs)
    return [(np.array([run[SHARE] for run in of_case[1:]]), choice.asked[SHARE], scatter, PRIOR) for of_case in runs]


def scatter_of(error: float, runs: int) -> float:
    """Relative standard deviation (1) of a run where 95 % of the means of so many keep an error (1)."""
    return error * runs**0.5 / NORMAL


def _certificate(expansion: Resolved, runs: list[list[dict]]) -> dict[str, str]:
    """Attribute of the cube: what was asked of the mean share, and what the runs of the worst case keep; none unasked."""
    if not expansion.choices:
        return {}
    cases = _asked(expansion, runs)
    bound, asked = max(mean_bound(values, scatter, prior) for values, _, scatter, prior in cases), cases[0][1]
    told = f"{SHARE}: asked {asked:.3g}, {len(runs[0]) - 1} runs keep {bound:.3g} in 95 % of such means"
    return {"certificate": told if bound <= asked else f"{told}: NOT MET, {MOST} runs at most"}


def _groups(expansion: Resolved) -> list[list[int]]:
    """Numbers of the cases that share a filling."""
    groups: dict[str, list[int]] = {}
    for number, case in enumerate(expansion.cases):
        groups.setdefault(case.scene.filling, []).append(number)
    return list(groups.values())


def _of_one_filling(expansion: Resolved, task: tuple[list[int], int]) -> dict[tuple[int, int], dict]:
    """Numbers of a run of the cases that share a filling, by numbers of case and run."""
    study, (members, run) = expansion.study, task
    rested = settle(study, expansion.cases[members[0]].scene.config, run)
    configs = {number: expansion.cases[number].scene.config for number in members}
    return {
        (number, run): at_rest(config, rested) | in_flow(study, config, rested, discharge(study, config, rested))
        for number, config in configs.items()
    }


def _cube(expansion: Resolved, runs: list[list[dict]]) -> xr.Dataset:
    study, silo = expansion.study, expansion.study.scene.silo
    runs_in_one = [{name: np.array([run[name] for run in of_case]) for name in of_case[0]} for of_case in runs]
    samples = runs[0][0]["passed_discs"].size
    labels = {
        "run": np.arange(len(runs[0])),
        "layer": (np.arange(LAYERS) + 0.5) * (silo.height_m / LAYERS),
        "sample": np.arange(samples) * SAMPLE * WINDOW,
        "interval": (np.arange(samples - 1) + 0.5) * SAMPLE * WINDOW,
        "look": list(LOOKS),
        "measure": list(MEASURES),
    }
    sizes = {"width_m": silo.width_m, "radius_m": study.scene.discs.radius_m, "slit_width_m": silo.slit_width_m}
    notes = sizes | expansion.promise | _certificate(expansion, runs)
    data = {**stacked(runs_in_one, expansion.shape), **labels}
    return assemble(study, "packing", data, sources=SOURCES, notes=notes, sweep=sweep_of(expansion))
