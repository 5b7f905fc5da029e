"""Discrete-element scenes: from a scene to a run, with its checkpoints."""

import pickle
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import xarray as xr

from silostudy.config.dem import DemScene
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.run import Run
from silostudy.dem.stability import chosen_step, longest_step
from silostudy.errors import BadInput
from silostudy.files import replacing
from silostudy.packing import PACKINGS
from silostudy.scene.dem import bottom_of, check_start, contact_of, events_of, walls_of
from silostudy.stamp import stamp


def model_of(scene: DemScene, folder: Path, where: str = "") -> Model:
    """The engine's model of a scene; BadInput for a start or a step that cannot be."""
    walls = walls_of(scene.silo)
    x, y, radius = _discs(scene, folder)
    if scene.packing.kind != "given":
        y = y + bottom_of(scene.silo)
    check_start(walls, x, y, radius, where)
    contacts = [contact_of(config, scene.radius_m, scene.density_kg_m3) for config in (scene.discs, scene.walls or scene.discs)]
    model = Model(
        x=x, y=y, radius=radius, density=scene.density_kg_m3, walls=walls, pair=contacts[0], wall=contacts[1],
        dt=scene.march.step_s or 1.0, gravity=scene.gravity_m_s2, integrator=scene.march.integrator,
        watched=scene.record.wall_force_window_s is not None, booked=scene.record.energy,
    )  # fmt: skip
    model = replace(model, dt=_step(scene, model, where))
    return model if scene.quake is None else replace(model, quake=_quake(scene, folder, model.dt))


def _discs(scene: DemScene, folder: Path):
    packing = scene.packing
    if packing.kind == "rows":
        return PACKINGS["rows"].place(
            width=scene.silo.width_m, height=packing.fill_height_m, radius=scene.radius_m, across=packing.across,
            gap=packing.gap_m, offset=packing.offset_m, seed=scene.seed,
        )  # fmt: skip
    if packing.kind == "loose":
        return PACKINGS["loose"].place(
            width=scene.silo.width_m, count=packing.count, radius=scene.radius_m, spread=packing.radius_spread, seed=scene.seed
        )
    try:
        with xr.open_dataset(folder / packing.file) as given:
            last = {"snapshot": -1} if "snapshot" in given.dims else {}
            x, y = (given[name].isel(last).to_numpy() for name in ("disc_x", "disc_y"))
            left = np.isfinite(x)
            return PACKINGS["given"].place(x=x[left], y=y[left], radius=given["disc_radius"].to_numpy()[left])
    except (OSError, KeyError) as error:
        raise BadInput("packing.file", packing.file, f"must be netCDF with disc_x, disc_y, disc_radius ({error})") from None


def _step(scene: DemScene, model: Model, where: str) -> float:
    if scene.march.step_s is None:
        return scene.march.step_factor * chosen_step(model)
    bound = longest_step(model)
    if scene.march.step_s > bound and not scene.march.beyond_stability:
        allowed = f"beyond the stability bound {bound:.4g} s; shorten it, or set march.beyond_stability"
        raise BadInput("march.step_s", scene.march.step_s, allowed, where)
    return scene.march.step_s


def _quake(scene: DemScene, folder: Path, dt: float) -> np.ndarray:
    """Acceleration of the box at every step, between the points of its record; none after its end."""
    assert scene.quake is not None
    try:
        time, *ways = np.loadtxt(folder / scene.quake.file, delimiter=",", skiprows=1, unpack=True, ndmin=2)
    except (OSError, ValueError) as error:
        raise BadInput("quake.file", scene.quake.file, f"must be CSV with time_s, x_m_s2, y_m_s2 ({error})") from None
    steps = np.arange(int(time[-1] / dt) + 2) * dt
    return np.column_stack([np.interp(steps, time, way, right=0.0) for way in ways])


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
        snapshots=tuple(round(time / dt) for time in record.snapshots_s),
        stress_edges=edges,
    )


def carry_through(run: Run, scene: DemScene, checkpoint: Path | None, tell: Callable[[int], None]) -> None:
    """Run to the end, saving checkpoints as the scene asks; goes on from the checkpoint where there is one."""
    key = (scene.model_dump_json(), stamp("contact", "dem", "packing"))
    if checkpoint is not None and checkpoint.exists():
        saved_key, saved = pickle.loads(checkpoint.read_bytes())
        if saved_key == key:
            run.restore(saved)
    every = scene.record.checkpoint_every_s
    if checkpoint is None or every is None:
        run.go(tell=tell)
        return
    steps = max(1, round(every / run.engine.model.dt))
    while not run.done:
        run.go(until=(run.engine.step // steps + 1) * steps, tell=tell)
        if not run.done:
            with replacing(checkpoint) as temporary:
                temporary.write_bytes(pickle.dumps((key, run.checkpoint())))
    checkpoint.unlink(missing_ok=True)
