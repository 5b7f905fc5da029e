"""Discrete-element scenes: from a scene to a run, with its checkpoints."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from silostudy.compute.checkpoints import resume, save
from silostudy.compute.dem_files import given_discs, quake_steps
from silostudy.config.dem import DemScene
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.errors import BadInput
from silostudy.packing import PACKINGS
from silostudy.scene.dem import events_of, rest_of
from silostudy.scene.dem_model import placed, unshaken_scene_model


def scene_model(scene: DemScene, folder: Path, where: str = "") -> Model:
    """The engine's model of a scene; BadInput for a start or a step that cannot be."""
    discs = given_discs(scene.packing.file, folder) if PACKINGS[scene.packing.kind].from_file else placed(scene)
    model = unshaken_scene_model(scene, discs, where)
    if scene.quake is None:
        return model
    return replace(model, quake=quake_steps(scene.quake.file, folder, dt=model.dt, limit=scene.march.limit_s))


def run_of(scene: DemScene, model: Model, *, threads: int = 1) -> Run:
    """The run that a scene asks for."""
    record, dt = scene.record, model.dt
    window = record.wall_force_window_s or (scene.march.limit_s / 100.0 if record.energy else None)
    edges = None
    if record.stress_cells is not None:
        top = float(max(max(wall.start[1], wall.end[1]) for wall in model.walls))
        edges = (
            np.linspace(0.0, scene.silo.width_m, record.stress_cells[0] + 1),
            np.linspace(0.0, top, record.stress_cells[1] + 1),
        )
    return Run(
        Engine(model, threads=threads),
        events_of(scene),
        limit=scene.march.limit_s,
        window=max(1, round(window / dt)) if window else 0,
        snapshots=_steps_of(record.snapshots_s, dt),
        stress_edges=edges,
        rest=rest_of(scene),
    )


def _steps_of(times: tuple[float, ...], dt: float) -> tuple[int, ...]:
    """Steps at which snapshots are taken; BadInput for two in one step."""
    steps = [round(time / dt) for time in times]
    for number, step in enumerate(steps):
        if step in steps[:number]:
            raise BadInput("record.snapshots_s", times[number], f"falls into the same step of {dt:.3g} s as another")
    return tuple(steps)


def carry_through(run: Run, scene: DemScene, checkpoint: Path | None, tell: Callable[[int], None]) -> None:
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
