"""A real cube for every output: of the first shipped study that asks for it, with less of what takes long."""

import copy
from functools import cache

import numpy as np
import pytest
import xarray as xr

from silostudy.accuracy import cube as accuracy
from silostudy.choice.expand import expand
from silostudy.compute.axes import sweep_of
from silostudy.compute.dem_cube import cube_of as dem_cube
from silostudy.compute.grains import CARRIERS
from silostudy.compute.observers import grid_of
from silostudy.compute.published import coordinates as published_coordinates
from silostudy.compute.published import sources
from silostudy.compute.scenes import SWEPT, coordinates
from silostudy.compute.scenes_means import mean_numbers
from silostudy.config.load import read_yaml
from silostudy.cube.assemble import assemble
from silostudy.scene.expand import Expansion
from silostudy.stages import STAGES, called_for
from silostudy.tables.outputs import OUTPUTS
from tests.conftest import ROOT
from tests.test_compute.made_walls import made_walls
from tests.test_dem.small import carried
from tests.test_dem.small import scene_of as discs_of
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
# in place of the laboratory's row, which is made by a run of the whole pipeline
ROUND = {"plan": "circular", "diameter_m": 0.1, "cylinder_depth_m": 0.1}
MADE_UP = {
    "solid": "wheat_e1",
    "properties": {"unit_weight_kN_m3": 7.85, "wall_friction": 0.4, "lateral_pressure_ratio": 0.5},
}
STUDIES = ROOT / "config/studies"
# what is changed of a shipped study so that its cube takes no time; a study not named here is computed as it ships
SMALLER: dict[str, dict] = {
    "accuracy": {
        "scene": {
            "problems": ["dem_impact", "depth_levels", "shell_thickness", "history", "beam_frequency"],
            "repeats": 1,
            "members": 3,
            "rungs": 3,
            "prices": True,
        }
    },
    "grains-amplitude": {
        "scene": {
            "box": {"slenderness": 0.5},
            "packing": "rows_17_18",
            "wall_friction": 0.176,
            "shaking": {"amplitude_gal": 100.0, "frequency_Hz": 4.0},
        },
        "sweep": [
            {"axis": "packing", "values": {"packing": ["rows_17_18"]}},
            {"axis": "amplitude", "values": {"shaking.amplitude_gal": [100.0, 300.0]}},
        ],
        "fillings": 2,
        "cycles": 1,
        "waited_cycles": 0,
    },
    "kiyama-1983": {
        "sweep": [
            {"axis": "packing", "values": {"across": [12, 18]}},
            {"axis": "removal", "values": {"remedy": [False, True]}},
        ],
        "scene": {"across": 18, "disc_count": 200},
        "runs": 2,
        "discharge_s": 0.6,
        "stopped_s": 0.1,
        "rest_limit_s": 1.5,
        "detailed": [{"across": 18, "run": 0}],
    },
    "kiyama-1983-slit": {
        "sweep": [
            {"axis": "packing", "values": {"across": [12]}},
            {"axis": "slit", "values": {"silo.slit_width_m": [0.06, 0.1, 0.14]}},
        ],
        "scene": {"across": 18, "disc_count": 200},
        "runs": 1,
        "discharge_s": 0.6,
        "stopped_s": 0.1,
        "rest_limit_s": 1.5,
    },
    "sasaki-1991": {
        "identification": {
            "coefficients": {"start": 0.5, "stop": 1.0, "count": 11},
            "refinement": 2,
            "recovery_trials": 3,
            "shown_coefficients": [1.0, 0.75, 0.7, 0.6],
            "band_Hz": [5.0, 60.0],
            "damping_mismatch": 0.25,
            "empty_frequency_rounding_Hz": 0.05,
            "recovery_noise_ratio": 0.2,
        },
    },
    "stability-map": {
        "sweep": [
            {"axis": "network", "values": {"network": ["column"]}},
            {"axis": "damping", "values": {"discs.damping_ratio": [0.1, 1.0]}},
            {
                "axis": "march",
                "points": [
                    {"integrator": "17-18", "discs.normal": "spring-dashpot", "discs.tangential": "spring-slider"},
                    {"integrator": "17-19", "discs.normal": "spring-dashpot", "discs.tangential": "spring-slider"},
                ],
            },
        ],
        "silo": {"steps_ms": [0.04, 0.05], "reference_step_ms": 0.025, "fillings": 2, "rest_s": 0.4, "parts": 4},
        "trial_steps": 1000,
        "peer": False,
    },
    "silo-of-spheres": {},  # shown for all sweeps of silos beside codes
    "silo-of-spheres-codes": {
        "materials": None,
        "scene": MADE_UP | {"silo": ROUND | {"hopper": {"half_angle_deg": 20, "outlet_width_m": 0.05}}},
    },
    "silo-of-spheres-eccentric-codes": {
        "materials": None,
        "scene": MADE_UP | {"silo": ROUND | {"cylinder_depth_m": 0.2, "action_assessment_class": 3}},
    },
    "wheat-silo-today": {"uncertainty": {"log2_samples": 6, "seed": 1}},
}


@cache
def flow_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of spheres that flow by Beverloo's law, each filling a little off: no kernel is compiled."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)
    scenes = [case.scene.config for case in expansion.cases]
    width = np.array([scene.outlets[0].width_m for scene in scenes])
    diameter = np.array([1e-3 * scene.sizes.diameter_mm for scene in scenes])
    flow = (1.0 + 0.02 * np.sin(np.arange(len(width)))) * 2700.0 * (width - 1.5 * diameter) ** 2.5
    numbers = {"mean_mass_flow": flow.reshape(shape), "mean_grain_diameter": diameter.reshape(shape)}
    return assemble(expansion.study, "scenes", numbers, sources=[], sweep=sweep_of(expansion))


@cache
def jam_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of discs over slots of which the narrow ones jam in every other filling."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)
    scenes = [case.scene.config for case in expansion.cases]
    width = np.array([scene.silo.slit_width_m for scene in scenes])
    jams = (width < 5.0 * 2.0 * scenes[0].radius_m) & (np.arange(len(width)) % 2 == 0)
    flow = np.where(jams, 0.1, 1.0) * 500.0 * width**1.5
    numbers = {"mean_discharge_rate": flow, "mean_grain_diameter": np.full(len(width), 2.0 * scenes[0].radius_m)}
    shaped = {name: values.reshape(shape) for name, values in (numbers | {"limit_reached": jams.astype(float)}).items()}
    return assemble(expansion.study, "scenes", shaped, sources=[], sweep=sweep_of(expansion))


@cache
def emptying_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of silos of spheres that empty evenly in two seconds, each filling a little slower."""
    expansion = expansion_of(study)
    share = coordinates(expansion.study)["flow_share"]
    slower = 1.0 + 0.1 * np.arange(expansion.shape[-1])
    left = np.broadcast_to(1.0 - share / slower[:, None], (*expansion.shape, len(share)))
    numbers = {"share_left": left, "flow_share": share, "first_event_time": np.full(expansion.shape, 0.5)}
    numbers |= {"end_time": np.full(expansion.shape, 2.5)}
    return assemble(expansion.study, "scenes", numbers, sources=[], sweep=sweep_of(expansion))


@cache
def published_cube(study: str, off: tuple[float, ...] = (0.5, -0.8, 0.1)) -> xr.Dataset:
    """The cube of a study of published cases whose fillings are all so many tolerances off."""
    expansion = expansion_of(study)
    own = published_coordinates(expansion.study)
    values = np.broadcast_to(np.array(off)[:, None], (*expansion.shape, len(own["expectation"])))
    named = sources(expansion.study)
    return assemble(expansion.study, "published", {"off_published": values} | own, sources=named, sweep=sweep_of(expansion))


@cache
def certified_cube(study: str) -> xr.Dataset:
    """The cube of a sweep whose means are certified, of runs that are made up: no kernel is compiled."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)

    def run(scene) -> dict:
        flow, push = 1.0 + 0.1 * np.random.default_rng([scene.seed, round(1e3 * scene.march.step_factor)]).normal(size=2)
        found = {
            "mean_mass_flow": flow,
            "body_normal_force_at_rest": [push, 0.0, 0.0],
            "grains_at_start": 400.0,
            "time_step": 1e-5,
        }
        return {name: np.array(value) for name, value in found.items()}

    cases = [mean_numbers(case.scene.config, run, SWEPT["spheres"]) for case in expansion.cases]
    numbers = {name: np.array([case[name] for case in cases]) for name in cases[0]}
    numbers = {name: values.reshape(*shape, *values.shape[1:]) for name, values in numbers.items()}
    return assemble(expansion.study, "scenes", numbers | coordinates(expansion.study), sources=[], sweep=sweep_of(expansion))


@cache
def ladder_cube(study: str) -> xr.Dataset:
    """The cube of a sweep over settings and fillings, each setting a little off the first: no kernel is compiled."""
    expansion = expansion_of(study)
    shape = tuple(len(axis.settings()) for axis in expansion.study.sweep)
    off = 0.01 * np.arange(shape[0])[:, None] + 0.05 * np.random.default_rng(0).normal(size=shape)
    numbers = {"mean_mass_flow": 0.2 * (1.0 + off), "unit_weight_at_rest": 8e3 * (1.0 + 0.1 * off),
               "body_normal_force_at_rest": 3.0 * (1.0 - off)[..., None] * np.ones(3),
               "grains_at_start": np.full(shape, 2000.0), "end_time": np.full(shape, 0.5),
               "time_step": 1e-5 * np.sqrt(np.arange(1.0, shape[0] + 1.0))[:, None] * np.ones(shape)}  # fmt: skip
    numbers |= _ladder_walls(off, coordinates(expansion.study))
    return assemble(expansion.study, "scenes", numbers | coordinates(expansion.study), sources=[], sweep=sweep_of(expansion))


def shaken_ladder_cube(study: str) -> xr.Dataset:
    """The cube of shaken spheres whose wall carries 0.8, and 1 % less with each further setting, 0.1 % more each filling."""
    expansion = expansion_of(study)
    fillings = np.array(expansion.study.seeds)
    off = 1.0 - 0.01 * np.arange(expansion.shape[0])[:, None] + 0.001 * fillings
    numbers = {"carried_in_phase": off[..., None] * [0.8, 0.2, 1.0], "contents_damping": 0.1 * off, "ring_share": 0.3 * off}
    own = {"filling": fillings, "carrier": list(CARRIERS)}
    return assemble(expansion.study, "grains", numbers | own, sources=[], sweep=sweep_of(expansion))


def _ladder_walls(off: np.ndarray, own: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Pressures that fall with the height to none at 0.25 m; in flow one lowest cell bears five times that."""
    levels, turns, windows = (len(own[name]) for name in ("wall_level", "wall_turn", "flow_window"))
    height = 0.3 * (np.arange(levels) + 0.5) / levels
    rest = 4e3 * np.maximum(0.25 - height, 0.0)[:, None] * np.ones((*off.shape, levels, turns)) * (1.0 - off)[..., None, None]
    flow = np.repeat(rest[:, :, None], windows, axis=2)
    flow[:, :, -1, 0, 0] *= 5.0
    top = {
        "filled_height_at_rest": np.full(off.shape, 0.25),
        "wall_level_height": np.broadcast_to(height, (*off.shape, levels)),
    }
    return {"wall_pressure_at_rest": rest, "wall_pressure_in_flow": flow, **top}


def _nothing(*_: object) -> None:
    """Tells no progress."""


@cache
def study_of(output: str) -> str:
    """Name of the first shipped study that asks for an output, of those made small where there are some."""
    studies = sorted((path.stem for path in STUDIES.glob("*.yaml")), key=lambda name: (name not in SMALLER, name))
    return next(name for name in studies if output in (read_yaml(STUDIES / f"{name}.yaml").get("outputs") or ()))


@cache
def expansion_of(study: str) -> Expansion:
    """The cases of a shipped study, made small."""
    content = copy.deepcopy(read_yaml(STUDIES / f"{study}.yaml")) | copy.deepcopy(SMALLER.get(study, {}))
    return expand(content, study, f"{study}.yaml", STUDIES)


@cache
def walls_cube(study: str) -> xr.Dataset:
    """The cube of a sweep of silos of spheres that feel Janssen's pressures times known factors."""
    expansion = expansion_of(study)
    return made_walls(expansion, [case.scene.silo.wall_depth for case in expansion_of(expansion.study.codes.study).cases])


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
    record.happened = [(0.04, "rest", "open"), (0.08, "after", "stop")]
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
