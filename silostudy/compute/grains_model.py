"""The engine's model of a grains scene: walls, contacts, a stable step, and the motion of the box."""

from dataclasses import dataclass, replace
from functools import singledispatch
from math import pi

import numpy as np

from silostudy.compute.grains_spheres import filling_run, silo_model, silo_pushes
from silostudy.config.grains import Grains, GrainsScene
from silostudy.config.grains_spheres import ShakenSpheres
from silostudy.config.shaking import Shaking
from silostudy.contact.tangential import spring_slider
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.model import Contact, Model
from silostudy.dem.pieces import Laws
from silostudy.dem.run import Run
from silostudy.dem.stability import chosen_step
from silostudy.dem.walls import sums_by_wall
from silostudy.scene.expand import Expansion
from silostudy.scene.grains import discs_of
from silostudy.scene.plane_silo import FLOOR, SIDES, PlaneSilo
from silostudy.seismic.readers import read_known
from silostudy.seismic.records import compressed, scaled, without_baseline
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.kiyama_1983 import WALL_STIFFNESS_RATIO


@dataclass(frozen=True)
class RunLength:
    """Length of one run of the engine: a filling that settles (at most so many steps), or one that is shaken."""

    grains: int
    steps: int
    shaken: bool


def run_lengths(expansion: Expansion) -> list[RunLength]:
    """Every run of a study, equal fillings settled once."""
    study, models, runs = expansion.study, {}, []
    for case in expansion.cases:
        for seed in study.seeds:
            key = case.scene.filling, seed
            if key not in models:
                models[key] = shaken_box_model(case.scene.config, seed)
                run = settling_run(case.scene.config, seed, models[key], study.rest_limit_s)
                runs.append(RunLength(len(models[key].x), run.last, shaken=False))
            steps = len(base_motion(case.scene.shaking, models[key].dt, study.cycles + study.waited_cycles))
            runs.append(RunLength(len(models[key].x), steps, shaken=True))
    return runs


@singledispatch
def shaken_box_model(config: GrainsScene | ShakenSpheres, seed: int) -> Model:
    """The model at its start, at a stable step; its box may be shaken."""
    raise TypeError(type(config))


@singledispatch
def settling_run(config: GrainsScene | ShakenSpheres, seed: int, model: Model, limit: float) -> Run:
    """The run that fills the box and waits, at most so long (s), for the grains to come to rest."""
    raise TypeError(type(config))


@singledispatch
def pushes(config: GrainsScene | ShakenSpheres, model: Model, window: np.ndarray) -> tuple[float, float, float]:
    """Horizontal force on the grains from walls and from floor, and sum of the walls' normal forces (N; in the plane N/m).

    window: what the walls' cells feel, (cell, component).
    """
    raise TypeError(type(config))


shaken_box_model.register(ShakenSpheres, silo_model)
settling_run.register(ShakenSpheres, filling_run)
pushes.register(ShakenSpheres, lambda config, model, window: silo_pushes(model, window))


@settling_run.register
def _(config: GrainsScene, seed: int, model: Model, limit: float) -> Run:
    return Run(Engine(model), (Event("rest", 0.0, "stop"),), limit=limit)


@pushes.register
def _(config: GrainsScene, model: Model, window: np.ndarray) -> tuple[float, float, float]:
    sums = sums_by_wall(model, window)
    floor, left, right = (sums[name] for name in (FLOOR, *SIDES))
    return left[0] - right[0], floor[1], left[0] + right[0]


@shaken_box_model.register
def _(config: GrainsScene, seed: int) -> Model:
    x, y, radius = discs_of(config, seed)
    width, top = config.box.width_m, 2.0 * max(float(y.max()), config.box.slenderness * config.box.width_m)
    grains = config.grains
    model = Model(
        x=x, y=y, radius=radius, density=grains.density_kg_m3, walls=PlaneSilo(width, top).walls(), dt=1.0,
        gravity=(0.0, -STANDARD_GRAVITY), watched=True, quake=np.zeros((1, 2)),
        pair_contact=_contact(grains, 1.0, grains.sliding_friction),
        wall_contact=_contact(grains, WALL_STIFFNESS_RATIO, config.wall_friction),
    )  # fmt: skip
    return replace(model, dt=chosen_step(model))


def _contact(grains: Grains, factor: float, friction: float) -> Contact:
    stiffness, damping = factor * grains.normal_stiffness_N_m2, factor * grains.normal_damping_N_s_m2
    coefficients = {
        "normal_stiffness": stiffness,
        "normal_damping": damping,
        "normal_damping_root": 0.0,
        "tangential_stiffness": grains.stiffness_ratio * stiffness,
        "tangential_damping": grains.stiffness_ratio**0.5 * damping,
        "tangential_damping_root": 0.0,
        "sliding_friction": friction,
    }
    return Contact(Laws(tangential=spring_slider.ROW), coefficients)


def base_motion(shaking: Shaking, dt: float, cycles: int) -> np.ndarray:
    """Horizontal acceleration of the box (m s-2) at the middle of every step, to the end of `cycles` or of the record."""
    peak = shaking.amplitude_gal / 100
    if shaking.frequency_Hz is not None:
        return peak * np.sin(2 * pi * shaking.frequency_Hz * (np.arange(round(cycles / shaking.frequency_Hz / dt)) + 0.5) * dt)
    assert shaking.record is not None  # the configuration asks for one of the two
    known = without_baseline(read_known(shaking.record), "mean")
    record = scaled(compressed(known, shaking.time_compression), peak)
    times = (np.arange(round(record.duration / dt)) + 0.5) * dt
    return np.interp(times, record.dt * np.arange(len(record.acceleration)), record.acceleration)
