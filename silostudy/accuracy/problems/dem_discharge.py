"""A slit opens below disordered discs: how fast they leave and how hard they push, over members of an ensemble."""

from dataclasses import replace

import numpy as np

from silostudy.accuracy.silo import OPEN, STEP, silo_of_rows, softened
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.integrate import PLAIN, SMOOTHED, VERLET
from silostudy.dem.run import Run
from silostudy.dem.walls import sums_by_wall
from silostudy.scene.plane_silo import SIDES

ACROSS = 8  # discs in a row
LEVELS = 10  # rows
SLIT = 0.55  # width of the slit over that of the silo
GAP = 6e-5  # m, between discs at the start
OFFSET = 2e-5  # m, by which places are moved at random at the start
REST = 0.3  # s to rest
FLOW = 0.5  # s of discharge
WINDOW = 5e-3  # s over which forces are averaged
STEPS = (1e-4, 5e-5, 2.5e-5, 1.25e-5, 6.25e-6)
LADDERS = {
    PLAIN.key: STEPS[1:],
    SMOOTHED.key: STEPS,
    "17-18, stiffness / 16": STEPS,
    "members at 2.5e-5 s": (4, 8, 16, 32, 64),
}


def prepare(ladder: str, setting: float, members: int):
    """An ensemble of discharges; the seeds of equal members are equal on every rung."""
    if ladder.startswith("members"):
        return _run(PLAIN.key, STEP, 1.0, int(setting))
    integrator, *soft = ladder.split(", ")
    return _run(integrator, setting, 1.0 / 16.0 if soft else 1.0, members)


def reference(members: int):
    """Reference by four times the members at half the finest step, with seeds of their own."""
    return _run(VERLET.key, STEPS[-1] / 2.0, 1.0, 4 * members, first=10_000)()


def _run(integrator: str, dt: float, stiffness: float, members: int, first: int = 0):
    models = []
    for seed in range(first, first + members):
        model, _ = silo_of_rows(ACROSS, LEVELS, SLIT, gap=GAP, offset=OFFSET, seed=seed)
        models.append(replace(softened(model, stiffness), integrator=integrator, dt=dt, watched=True))

    def run():
        runs = [_discharge(model) for model in models]
        return {name: np.array([numbers[name] for numbers in runs]) for name in runs[0]}

    return run


def _discharge(model) -> dict[str, float]:
    """Mean rate (kg/s per metre) until half is out, or over the whole flow; largest force on both walls over that at rest."""
    events = (Event("time", REST, "open", (OPEN[0], *OPEN[1])), Event("discharged", 0.5, "stop"))
    run = Run(Engine(model), events, limit=REST + FLOW, window=round(WINDOW / model.dt))
    done = run.go()
    if done.explosion is not None:
        return {"discharge_rate": np.nan, "wall_peak": np.nan}
    pushes = sums_by_wall(model, np.array(done.window)[:, :, 0, 0], axis=1)
    left, right = (pushes[name] for name in SIDES)
    force = left + right
    before = np.array(done.window_time) <= REST
    return {
        "discharge_rate": (done.discharged[-1] if done.discharged else 0.0) / (run.engine.time - REST),
        "wall_peak": force[~before].max() / force[before][-1],
    }
