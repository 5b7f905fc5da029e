"""The grains stage: every case filled and shaken, and what walls and floor carried of it."""

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise

import numpy as np
import xarray as xr

from silostudy.compute.axes import stacked, sweep_of
from silostudy.compute.grains_model import base_motion, pushes, settling_run, shaken_box_model
from silostudy.config.grains import GrainsScene
from silostudy.config.grains_spheres import ShakenSpheres
from silostudy.cube.assemble import assemble
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.stability import check_step
from silostudy.errors import BadInput
from silostudy.scene.expand import Expansion
from silostudy.scene.grains import ShakenBox
from silostudy.seismic.en1998_4 import contents_share
from silostudy.seismic.grains import carried_share, equivalent_damping, wall_carried_ring
from silostudy.tables.constants import STANDARD_GRAVITY

CARRIERS = ("walls", "floor", "all")
SOURCES = ("kiyama_fujimura_1983", "sasaki_yoshimura_effective_mass", "en1998_4_2006", "silvestri_ring")


def grains_cube(expansion: Expansion, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """The cube of a grains study; `tell` hears of each case as it is done.  Equal fillings are settled once."""
    study, settled, cases = expansion.study, {}, []
    for number, case in enumerate(expansion.cases):
        fillings = []
        for seed in study.seeds:
            key = case.scene.filling, seed
            if key not in settled:
                settled[key] = settle(case.scene, seed, study.rest_limit_s)
            fillings.append(_shaken(study, case.scene, *settled[key]))
        cases.append({name: np.array([filling[name] for filling in fillings]) for name in fillings[0]})
        tell(f"case {number + 1} of {len(expansion.cases)}: walls carry {cases[-1]['carried_in_phase'][:, 0].mean():.3f}")
    data = {**stacked(cases, expansion.shape), "filling": np.array(study.seeds), "carrier": list(CARRIERS)}
    sources = [*SOURCES, *({"obspy_sample_knet"} if any(case.scene.shaking.record for case in expansion.cases) else ())]
    notes = {"shaken_body": shaken_box_model(expansion.cases[0].scene.config, 1).space.body}
    return assemble(study, "grains", data, sources=sources, notes=notes, sweep=sweep_of(expansion))


def settle(scene: ShakenBox, seed: int, limit: float) -> tuple[Model, dict, bool]:
    """Settles a filling: the model, a checkpoint with its clock set back, and whether it came to rest within the limit (s).

    Of discs rest is the engine's, a mean motion of rounding size; random fillings ring on far below what the shaking moves.
    """
    model = shaken_box_model(scene.config, seed)
    run = settling_run(scene.config, seed, model, limit)
    done = run.go()
    if done.explosion is not None:
        raise done.explosion
    if done.buried:
        raise BadInput("scene.box", seed, f"the filling of this seed does not go in: {done.buried}")
    check_step(_moved(model, run.engine))  # the settled contacts are stiffer than the start: beyond its bound nothing rests
    return model, {**checkpoint(run.engine), "step": np.array(0)}, done.happened[-1][1] == "rest"


def settled_model(scene: ShakenBox, seed: int, limit: float) -> Model:
    """A filling's model with its grains where they came to rest."""
    model, saved, _ = settle(scene, seed, limit)
    engine = Engine(model)
    restore(engine, saved)
    return _moved(model, engine)


def _moved(model: Model, engine: Engine) -> Model:
    """The model with all of its grains where they are in the engine."""
    return replace(model, waiting=0, **dict(zip(model.columns, engine.places.T, strict=False)))


def _shaken(study, scene: ShakenBox, model: Model, saved: dict, rested: bool) -> dict[str, np.ndarray | float]:
    """Everything of one filling under one motion, by the names of the contract."""
    motion = base_motion(scene.shaking, model.dt, study.cycles + study.waited_cycles)
    quake = np.zeros((len(motion), model.space.ways))
    quake[:, 0] = motion
    engine = Engine(replace(model, quake=quake))
    restore(engine, saved)
    mass, depth = float(engine.mass.sum()), float((engine.places[engine.labels, -1] + engine.radius).max())
    frequency = scene.shaking.frequency_Hz
    sample = 1 / frequency / study.samples_per_cycle if frequency else study.record_sample_s
    edges = np.unique(np.round(np.arange(0, len(motion) * model.dt / sample + 1e-9) * sample / model.dt).astype(int))
    speed = float(np.sqrt(np.mean((engine.bodies.rows[: engine.n, engine.space.velocity] ** 2).sum(axis=1))))
    forces, momentum, normal = record(scene.config, engine, edges)
    acceleration = np.add.reduceat(motion, edges[:-1])[: len(edges) - 1] / np.diff(edges)
    acceleration[-1] = motion[edges[-2] : edges[-1]].mean()
    counted = slice(study.waited_cycles * study.samples_per_cycle if frequency else 0, None)
    share = carried_share(forces[:, counted], acceleration[counted], mass=mass)
    inertia = mass * acceleration + np.diff(momentum) / (np.diff(edges) * model.dt)
    return {
        "carried_in_phase": share.real,
        "carried_out_of_phase": -share.imag,
        "contents_damping": float(equivalent_damping(share[2])),
        "ring_share": wall_carried_ring(normal, weight=mass * STANDARD_GRAVITY, wall_friction=scene.wall_friction),
        "grains_code_share": contents_share(depth / scene.width),
        "settled_slenderness": depth / scene.width,
        "momentum_error": float(np.abs(forces[2] - inertia).max() / np.abs(mass * acceleration).max()),
        "came_to_rest": float(rested),
        "start_speed": speed,
        "disc_count": float(engine.n),
    }


def record(config: GrainsScene | ShakenSpheres, engine: Engine, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """Horizontal force on the contents (N, N/m) from walls, floor, all, (3, window); momentum at the edges; static wall force.

    Each force is the mean of every step of its window; the static normal force of all walls is that of the first window.
    """
    forces, momentum = [], [_momentum(engine)]
    for low, high in pairwise(edges):
        engine.clear_window()
        engine.step_to(int(high))
        walls, floor, normal = pushes(config, engine.model, engine.record.window[:, :, 0] / (high - low))
        forces.append((walls, floor, walls + floor, normal))
        momentum.append(_momentum(engine))
    columns = np.array(forces).T
    return columns[:3], np.array(momentum), float(columns[3, 0])


def _momentum(engine: Engine) -> float:
    """Horizontal momentum of the contents against their box (kg m/s; in the plane over a metre)."""
    return float((engine.mass * engine.column(engine.space.velocity[0])).sum())
