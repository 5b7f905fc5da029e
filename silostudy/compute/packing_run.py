"""One run of a packing study: discs brought to rest, then let out through the slit, with what is noted on the way."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import ceil

import numpy as np

from silostudy.compute.arch import Arch, find_arch
from silostudy.config.packing import PackingScene, PackingStudy
from silostudy.dem.change import swap_walls
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.lanes import U, V, Y
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.dem.stability import SAFETY, longest_step
from silostudy.scene.packing import contacts_of, discs_of, packing_walls
from silostudy.scene.plane_silo import FLOOR, HALVES
from silostudy.tables.constants import STANDARD_GRAVITY

WINDOW = 1e-3  # s: wall forces of every step are gathered over windows of this length
SAMPLE = 10  # windows between looks at the discs
STILL = 1e-3  # m/s: fastest disc of contents at rest; from then on a stopped run is not followed any further
NEVER = 1e6  # s


@dataclass(frozen=True)
class Rested:
    """A packing at rest: its model, the checkpoint with its clock set back, its wall forces, and how it came there.

    walls: (cells, 2) normal and shear force (N/m); places: (discs, 2) (m); speed: mean of the discs (m/s).
    """

    model: Model
    saved: dict
    walls: np.ndarray
    places: np.ndarray
    rested: bool
    time: float
    speed: float


@dataclass
class Discharge:
    """Record of a discharge.

    windows: (windows, cells, 2, 3) mean, least and largest normal and shear force (N/m) of every step of each window;
    passed: (samples,) discs below the floor's level, removed ones not counted; places: (samples, discs, 2) (m), NaN for
    discs that are gone; stops: time (s) of the last disc before each stop, and the arch that was found.
    """

    windows: np.ndarray
    passed: np.ndarray
    places: np.ndarray
    stops: list[tuple[float, Arch]] = field(default_factory=list)
    stopped: bool = False
    removed: list[tuple[float, int]] = field(default_factory=list)


def packing_model(study: PackingStudy, config: PackingScene, run: int) -> Model:
    """The model of a run at its start; a window is a whole number of its steps."""
    x, y, radius = discs_of(study, config, run)
    pair, wall = contacts_of(config)
    model = Model(
        x=x, y=y, radius=radius, density=config.discs.density_kg_m3, walls=packing_walls(config.silo),
        pair_contact=pair, wall_contact=wall, dt=1.0, gravity=(0.0, -STANDARD_GRAVITY),
        integrator=config.march.integrator, watched=True,
    )  # fmt: skip
    asked = config.march.step_s or SAFETY * longest_step(model)
    return replace(model, dt=WINDOW / ceil(round(WINDOW / asked, 2)))  # rounded: the last bits of the bound vary


def settle(study: PackingStudy, config: PackingScene, run: int) -> Rested:
    """A run's packing at rest by the paper's criterion, or at the study's limit; an explosion is raised."""
    model = packing_model(study, config, run)
    task = Run(Engine(model), (Event("rest", 0.0, "stop"),), limit=study.rest_limit_s)
    done = task.go()
    if done.explosion is not None:
        raise done.explosion
    engine = task.engine
    speed = float(np.hypot(engine.column(U), engine.column(V)).mean())
    saved = {**checkpoint(engine), "step": np.array(0)}
    return Rested(model, saved, engine.record.now.copy(), engine.places, done.happened[-1][1] == "rest", engine.time, speed)


def discharge(
    study: PackingStudy, config: PackingScene, rested: Rested, watch: Callable[[Run], None] = lambda run: None
) -> Discharge:
    """The discharge of a packing at rest through the case's slit; `watch` is shown the run at every sample.

    Where no disc passes for the study's time and an arch spans the slit, the flow has stopped; a case with the remedy
    then loses the highest disc of the arch.  Once all is still the run ends, and its last sample stands for the rest.
    """
    engine = Engine(replace(rested.model, walls=packing_walls(config.silo)))
    restore(engine, {**rested.saved, "shape": engine.walls.shape.copy()})  # the slit is the case's own
    engine.clear_window()
    window = round(WINDOW / engine.model.dt)
    run = Run(engine, (Event("time", NEVER, "stop"),), limit=NEVER, window=window)
    engine.list_contacts()
    watch(run)
    swap_walls(engine, FLOOR, HALVES)
    samples = round(study.discharge_s / WINDOW / SAMPLE)
    quiet = round(study.stopped_s / WINDOW / SAMPLE)
    flowed = Discharge(np.empty(0), np.zeros(samples + 1), np.full((samples + 1, len(rested.places), 2), np.nan))
    flowed.places[0] = engine.places
    for k in range(1, samples + 1):
        run.go(until=k * SAMPLE * window)
        if run.recording.explosion is not None:
            raise run.recording.explosion
        engine.list_contacts()
        flowed.passed[k], flowed.places[k] = _passed(run, flowed), engine.places
        watch(run)
        _look_for_stop(study, config, run, flowed, k, quiet)
        if flowed.stopped and _still(engine):
            flowed.passed[k:], flowed.places[k:] = flowed.passed[k], flowed.places[k]
            break
    recorded = np.array(run.recording.window)
    missing = samples * SAMPLE - len(recorded)
    flowed.windows = np.concatenate([recorded, np.repeat(recorded[-1:], missing, axis=0)])
    return flowed


def _look_for_stop(study, config, run: Run, flowed: Discharge, k: int, quiet: int) -> None:
    """Note whether the flow has stopped at sample k, and take a disc out where the case asks for it."""
    last = int(np.flatnonzero(np.diff(flowed.passed[: k + 1], prepend=-1.0))[-1])
    since = max([last, *(round(time / WINDOW / SAMPLE) for time, _ in flowed.removed)])
    arch = find_arch(run.engine) if k - since >= quiet else None
    flowed.stopped = arch is not None
    if arch is None:
        return
    time = last * SAMPLE * WINDOW
    if not flowed.stops or flowed.stops[-1][0] < time or config.remedy:
        flowed.stops.append((time, arch))
    if config.remedy:
        flowed.removed.append((k * SAMPLE * WINDOW, arch.roof))
        flowed.stopped = False
        run.insert(Event("after", 0.0, "remove", (arch.roof,)))


def _passed(run: Run, flowed: Discharge) -> int:
    """Discs that have passed the level of the floor."""
    engine = run.engine
    return engine.most - int((engine.column(Y) > 0.0).sum()) - len(flowed.removed)


def _still(engine: Engine) -> bool:
    above = engine.column(Y) > 0.0
    return bool(np.hypot(engine.column(U)[above], engine.column(V)[above]).max() < STILL)
