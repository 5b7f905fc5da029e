"""A real cube for every output: of the first shipped study that asks for it, with less of what takes long."""

from functools import cache

import numpy as np
import pytest
import xarray as xr

from silostudy.accuracy import cube as accuracy
from silostudy.compute.dem_cube import cube_of as dem_cube
from silostudy.compute.observers import grid_of
from silostudy.stages import STAGES, called_for
from silostudy.tables.outputs import OUTPUTS
from tests.test_dem.small import carried
from tests.test_dem.small import scene_of as discs_of
from tests.test_figures.made_scenes import (
    certified_cube,
    emptying_cube,
    flow_cube,
    jam_cube,
    ladder_cube,
    published_cube,
    shaken_ladder_cube,
    walls_cube,
)
from tests.test_figures.small_studies import expansion_of, study_of
from tests.test_laboratory.made_up import cube_of as made_up
from tests.test_spheres.small import run, scene_of

# of two parts and two of spheres, in place of those that take minutes to measure
PRICES = {
    "effect": ["a part", "another", "a law, of spheres", "a record, of spheres"],
    "effect_room": ["pressures", "earthquake", "spheres", "scenes of spheres"],
    "effect_time_share": [0.5, 0.1, 0.2, 0.3],
    "effect_time_share_low": [0.45, 0.05, 0.18, 0.28],
    "effect_time_share_high": [0.6, 0.12, 0.22, 0.33],
    "effect_instruction_share": [0.4, np.nan, 0.15, 0.25],
    "effect_memory_share": [0.3, 0.0, 0.1, 0.2],
    "effect_uncounted": ["", "no valgrind", "", ""],
}


def _nothing(*_: object) -> None:
    """Tells no progress."""


@cache
def cube_of(study: str, stage: str) -> xr.Dataset:
    """The cube of a stage of a shipped study, made small, and of the stages and studies that it reads."""
    if stage == "scenes":
        return walls_cube(study)
    expansion, row = expansion_of(study), STAGES[stage]
    read = [cube_of(study, other) for other in row.reads]
    asked = [getattr(expansion.study, section) for section in row.borrows]
    borrowed = [one and cube_of(one.study, other) for one, other in zip(asked, row.borrows.values(), strict=True)]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(accuracy, "price_variables", lambda repeats, tell: {name: np.array(v) for name, v in PRICES.items()})
        return row.cube(expansion, _nothing, (*read, *borrowed))


@cache
def bin_cube() -> xr.Dataset:
    """The cube of a bin of spheres whose run is made up, so that no kernel is compiled: it rests, opens, and flows."""
    asked = {"cells": [4, 6], "every_s": 0.02}
    scene = scene_of(filling={"kind": "loose", "count": 120}, record__fields=asked)
    task, random = run(scene), np.random.default_rng(1)
    record, model = task.recording, task.engine.model
    cells = len(task.engine.record.window)
    for number in range(4):
        record.window.append(random.uniform(0.01, 0.1, (cells, 3, 1)) * [1.0, 0.5, 2.0])
        record.whole.append(random.uniform(0.01, 0.1, (len(model.walls), 3, 2)))
        record.window_time.append(0.02 * (number + 1))
    record.happened = [(0.04, "rest", "open_outlet"), (0.08, "after", "stop")]
    for time in (0.0, 0.04, 0.08):
        motion = np.column_stack([model.place + np.array([0.0, 0.0, 0.04 - time / 2]), random.uniform(-1, 1, (120, 6))])
        chain = np.column_stack([np.arange(20), np.arange(1, 21), motion[:20, :3], random.uniform(-1.0, 1.0, (20, 3))])
        record.snapshots.append(
            {"time": np.array(time), "label": np.arange(120), "motion": motion, "pairs": chain, "walls": np.empty((0, 8))}
        )
    record.passed = [(0.05 + 0.002 * k, 1e-4, 0) for k in range(10)]
    (fields, *_), cells = task.observers, grid_of(scene, scene.record.fields, model).cells
    for number in range(4):
        shapes = (cells,), (cells,), (cells, 3), (cells, 3, 3), (cells, 3, 3), (cells, 3)
        record.readings.setdefault(fields.name, []).append(
            (0.02 * (number + 1), tuple(random.uniform(0.5, 1.0, shape) for shape in shapes))
        )
    return dem_cube(task, scene)


def cubes_of(output: str) -> list[xr.Dataset]:
    """The cubes that an output is drawn from."""
    if output == "jams_over_outlet":
        return [jam_cube(study_of(output))]
    if output == "left_over_time":
        return [emptying_cube(study_of(output))]
    if OUTPUTS[output].stage == "published":
        return [published_cube(study_of(output))]
    if "only_discs" in OUTPUTS[output].demands:
        return [dem_cube(carried(discs_of()), discs_of())]
    if OUTPUTS[output].stage == "dem":
        return [bin_cube()]
    if output == "switch_in_time":
        return [walls_cube("silo-of-spheres")]
    if OUTPUTS[output].stage == "scenes":
        ladders = dict.fromkeys(("ladders", "ladder_walls", "price_of_means"), ladder_cube)
        made = (ladders | {"certificates": certified_cube}).get(output, flow_cube)
        return [made(study_of(output))]
    if output == "shaken_ladders":
        return [shaken_ladder_cube(study_of(output))]
    if OUTPUTS[output].stage == "laboratory":
        return [made_up(expansion_of(study_of(output)))]
    row, study = OUTPUTS[output], study_of(output)
    also = [stage for stage in row.also if stage in called_for(expansion_of(study).study)]
    return [cube_of(study, stage) for stage in (row.stage, *also)]
