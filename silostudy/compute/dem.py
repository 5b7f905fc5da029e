"""Discrete-element scenes: from a scene to a run, with its checkpoints."""

from collections.abc import Callable
from dataclasses import replace
from functools import singledispatch
from pathlib import Path
from typing import Any

from silostudy.compute.branch_events import yet_to_come
from silostudy.compute.branches import branched
from silostudy.compute.checkpoints import resume, save
from silostudy.compute.dem_files import given_discs, given_spheres, quake_steps
from silostudy.compute.observers import observers_of
from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.spheres import SphereScene
from silostudy.dem.engine import Engine
from silostudy.dem.feeder import Feeder
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.errors import BadInput, within
from silostudy.packing import PACKINGS
from silostudy.packing.filling import FILLINGS
from silostudy.scene.dem import events_of, plane_silo_of, rest_of
from silostudy.scene.dem_model import placed, unshaken_scene_model
from silostudy.scene.lid import feeds
from silostudy.scene.sphere_events import sphere_events
from silostudy.scene.spheres import rain_of, space_silo_of
from silostudy.scene.spheres_model import sphere_model

STEPPED = {"gravity": "gravity_m_s2", "dt": "march.step_s", "wall_contact": "walls"}  # words of a model -> keys of a scene
DISC_KEYS = STEPPED | {
    "x": "packing", "y": "packing", "radius": "radius_m", "density": "density_kg_m3", "pair_contact": "discs",
}  # fmt: skip
SPHERE_KEYS = STEPPED | {
    "x": "filling",
    "y": "filling",
    "z": "filling",
    "radius": "sizes",
    "density": "grain",
    "pair_contact": "spheres",
}


def scene_model(scene: AnyScene, folder: Path, where: str = "") -> Model:
    """The engine's model of a scene; BadInput for a start or a step that cannot be."""
    with within(where, SPHERE_KEYS if isinstance(scene, SphereScene) else DISC_KEYS):
        model = _started(scene, folder, where)
        if scene.quake:
            shaken = quake_steps(scene.quake.file, folder, dt=model.dt, limit=scene.march.limit_s, ways=model.space.ways)
            model = replace(model, quake=shaken)
    return branched(scene, model, folder, where) if scene.start_from else model


@singledispatch
def _started(scene: AnyScene, folder: Path, where: str) -> Model:
    """The model at its start, or at that of the run that it goes on from."""
    raise TypeError(type(scene))


@_started.register
def _(scene: SphereScene, folder: Path, where: str) -> Model:
    filling, kinds = scene.filling, len(scene.grain_kinds)
    given = given_spheres(filling.file, folder, kinds) if FILLINGS[filling.kind].from_file else None
    return sphere_model(scene, given, where)


@_started.register
def _(scene: DemScene, folder: Path, where: str) -> Model:
    from_file = PACKINGS[scene.packing.kind].from_file
    discs = (*given_discs(scene.packing.file, folder), None) if from_file else placed(scene)
    return unshaken_scene_model(scene, discs, where)


def run_of(scene: AnyScene, model: Model, where: str = "", *, threads: int = 1) -> Run:
    """The run that a scene asks for; BadInput for records that cannot be."""
    with within(where, {"threads": "--threads"}):
        happens = _of_spheres(scene, model) if isinstance(scene, SphereScene) else _of_discs(scene, model)
        run = Run(
            Engine(model, threads=threads),
            limit=scene.march.limit_s,
            window=_window(scene, model),
            snapshots=_steps_of(scene, model.dt),
            observers=observers_of(scene, model),
            rest=rest_of(scene),
            **happens,
        )
        if model.end is not None:
            run.events, run.since = yet_to_come(run, scene)
        return run


def _of_discs(scene: DemScene, model: Model) -> dict[str, Any]:
    """Events and feeder of a scene of discs."""
    silo = plane_silo_of(scene)
    return {
        "events": events_of(scene, float(model.mass.sum())),
        "feeder": Feeder(silo.over_slit) if feeds(scene.events) or fed_before(model) else None,
        "outlet_at": silo.slit_at if scene.outlets else None,
    }


def _of_spheres(scene: SphereScene, model: Model) -> dict[str, Any]:
    """Events, rain and feeder of a scene of spheres."""
    space = space_silo_of(scene)
    rain = rain_of(scene, space, model.radius) if FILLINGS[scene.filling.kind].rains else None
    return {
        "events": sphere_events(scene, space, float(model.mass.sum())),
        "rain": rain,
        "feeder": Feeder(space.over_outlets) if feeds(scene.events) or fed_before(model) else None,
        "outlet_at": space.outlet_at if len(space.openings) > 1 else None,
    }


def fed_before(model: Model) -> bool:
    """Whether a feeder was at work where the model goes on from."""
    return model.end is not None and model.end["fed"] is not None


def _window(scene: AnyScene, model: Model) -> int:
    """Steps of a window of wall forces, or of the energy balance where that alone is kept; 0: none are kept."""
    record = scene.record
    length = record.wall_force_window_s or (scene.march.limit_s / 100.0 if record.energy else None)
    return max(1, round(length / model.dt)) if length else 0


def _steps_of(scene: AnyScene, dt: float) -> tuple[int, ...]:
    """Steps at which snapshots are taken; BadInput for two in one step."""
    times, every = scene.record.snapshots_s, scene.record.snapshots_every_s
    steps = [round(time / dt) for time in times]
    for number, step in enumerate(steps):
        if step in steps[:number]:
            raise BadInput("record.snapshots_s", times[number], f"falls into the same step of {dt:.3g} s as another")
    further = [round(number * every / dt) for number in range(round(scene.march.limit_s / every) + 1)] if every else ()
    return tuple(dict.fromkeys([*steps, *further]))


def carry_through(run: Run, scene: AnyScene, checkpoint: Path | None, tell: Callable[[int], None]) -> None:
    """Run to the end, saving checkpoints as the scene asks; goes on from the checkpoint where there is one.

    The last one stays: whoever has written the result takes it away.
    """
    if checkpoint is not None:
        resume(run, scene, checkpoint)
    every = scene.record.checkpoint_every_s
    if checkpoint is None or every is None:
        run.go(tell=tell)
        return
    steps = max(1, round(every / run.engine.model.dt))
    while not run.done:
        run.go(until=(run.engine.step // steps + 1) * steps, tell=tell)
        if not run.done:
            save(run, scene, checkpoint)
