"""A silo filled and come to rest: the forces on its walls by integrator, dashpot, stiffness, precision and neighbour skin."""

from dataclasses import replace
from functools import partial

import numpy as np

from silostudy.accuracy import single_precision
from silostudy.accuracy.silo import STEP, silo_of_rows, softened, wall_force, with_dashpot
from silostudy.contact.normal import spring_dashpot_implicit
from silostudy.dem.engine import Engine
from silostudy.dem.explosion import Explosion
from silostudy.dem.integrate import PLAIN, SMOOTHED, VERLET
from silostudy.tables.kiyama_1983 import RADIUS

ACROSS = 8  # discs in a row
LEVELS = 12  # rows
PARTS = 6  # of a wall
REST = 0.6  # s to rest
STEPS = (1.28e-4, 6.4e-5, 3.2e-5, 1.6e-5, 8e-6, 4e-6, 2e-6)
SINGLE = f"17-18, {single_precision.SINGLE}"
LADDERS = {
    PLAIN.key: STEPS,
    SMOOTHED.key: STEPS,
    VERLET.key: STEPS,
    "17-18, dashpot implicit": STEPS,
    "17-19, dashpot implicit": STEPS,
    "17-18, stiffness / 4": STEPS,
    "17-18, stiffness / 16": STEPS,
    SINGLE: STEPS[1:-1],
    "skin over radius at 2.5e-5 s": (0.05, 0.1, 0.2, 0.4, 0.8),
}


def prepare(ladder: str, setting: float):
    """The run to rest; the last ladder moves no force, only the cost."""
    model, _ = silo_of_rows(ACROSS, LEVELS)
    if ladder.startswith("skin"):
        return _run(replace(model, dt=STEP), setting * RADIUS)
    if ladder == SINGLE:
        return single_precision.timed_in_double(partial(_rested, replace(model, dt=setting), 0.0))
    integrator, *change = ladder.split(", ")
    if change == ["dashpot implicit"]:
        model = with_dashpot(model, spring_dashpot_implicit.ROW)
    elif change:
        model = softened(model, 1.0 / float(change[0].removeprefix("stiffness / ")))
    return _run(replace(model, integrator=integrator, dt=setting))


def _run(model, skin: float = 0.0):
    return partial(_rested, model, skin, Engine.step_to)


def _rested(model, skin: float, march):
    engine = Engine(model, skin=skin)
    try:
        march(engine, round(REST / model.dt))
    except Explosion:
        return {"wall_force": np.array(np.nan), "wall_push": np.nan}
    force = wall_force(engine, PARTS)
    return {"wall_force": force, "wall_push": force.sum()}


def reference():
    """Velocity Verlet at a quarter of the finest step."""
    return prepare(VERLET.key, STEPS[-1] / 4.0)()
