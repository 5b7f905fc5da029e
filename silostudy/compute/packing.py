"""The packing stage: ensembles of discs at rest and in discharge, case by case, into one cube."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import chain

import numpy as np
import xarray as xr

from silostudy.choice.expand import Resolved
from silostudy.compute.axes import stacked, sweep_of
from silostudy.compute.packing_measure import LOOKS, MEASURES, at_rest, in_flow
from silostudy.compute.packing_run import SAMPLE, WINDOW, discharge, settle
from silostudy.cube.assemble import assemble
from silostudy.scene.packing import LAYERS

SOURCES = ("kiyama_fujimura_1983", "silo_handbook")


def packing_cube(expansion: Resolved, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of a packing study; `tell` hears how far it is.  Equal fillings are settled once, for all their slits."""
    study, groups = expansion.study, _groups(expansion)
    tasks = [(members, run) for members in groups for run in range(study.runs + 1)]
    filled_runs: list[dict[int, dict]] = [{} for _ in expansion.cases]

    def filled(task) -> list[tuple[int, int, dict]]:
        members, run = task
        return [(case, run, values) for case, values in _of_one_filling(expansion, members, run)]

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        first = filled(tasks[0])  # alone, so that the kernel is compiled once
        for done, results in enumerate(chain([first], pool.map(filled, tasks[1:])), 1):
            for case, run, values in results:
                filled_runs[case][run] = values
            if done * 20 // len(tasks) > (done - 1) * 20 // len(tasks):
                tell(f"{done} of {len(tasks)} fillings settled and let out")
    return _cube(expansion, [[runs[run] for run in range(study.runs + 1)] for runs in filled_runs])


def _groups(expansion: Resolved) -> list[list[int]]:
    """Numbers of the cases that share a filling."""
    groups: dict[str, list[int]] = {}
    for number, case in enumerate(expansion.cases):
        groups.setdefault(case.scene.filling, []).append(number)
    return list(groups.values())


def _of_one_filling(expansion: Resolved, members: list[int], run: int) -> list[tuple[int, dict]]:
    study = expansion.study
    rested = settle(study, expansion.cases[members[0]].scene.config, run)
    runs = []
    for number in members:
        config = expansion.cases[number].scene.config
        values = in_flow(study, config, rested, discharge(study, config, rested))
        runs.append((number, at_rest(config, rested) | values))
    return runs


def _cube(expansion: Resolved, cases: list[list[dict]]) -> xr.Dataset:
    study, silo = expansion.study, expansion.study.scene.silo
    runs_in_one = [{name: np.array([run[name] for run in runs]) for name in runs[0]} for runs in cases]
    samples = cases[0][0]["passed_discs"].size
    labels = {
        "run": np.arange(study.runs + 1),
        "layer": (np.arange(LAYERS) + 0.5) * (silo.height_m / LAYERS),
        "sample": np.arange(samples) * SAMPLE * WINDOW,
        "interval": (np.arange(samples - 1) + 0.5) * SAMPLE * WINDOW,
        "look": list(LOOKS),
        "measure": list(MEASURES),
    }
    sizes = {"width_m": silo.width_m, "radius_m": study.scene.discs.radius_m, "slit_width_m": silo.slit_width_m}
    data = {**stacked(runs_in_one, expansion.shape), **labels}
    return assemble(study, "packing", data, sources=SOURCES, notes=sizes | expansion.promise, sweep=sweep_of(expansion))
