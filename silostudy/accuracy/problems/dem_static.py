"""A silo filled and come to rest: the forces on its walls by integrator, dashpot, stiffness and neighbour skin."""

from dataclasses import replace

import numpy as np

from silostudy.accuracy.silo import RADIUS, STEP, scene, softened, wall_force, with_dashpot
from silostudy.dem.engine import Engine, Explosion

ACROSS, LEVELS, PARTS, REST = 8, 12, 6, 0.6  # discs, rows, parts of a wall, time to rest (s)
STEPS = (1.28e-4, 6.4e-5, 3.2e-5, 1.6e-5, 8e-6, 4e-6, 2e-6)
LADDERS = {
    "17-18": STEPS,
    "17-19": STEPS,
    "velocity-verlet": STEPS,
    "17-18, dashpot implicit": STEPS,
    "17-19, dashpot implicit": STEPS,
    "17-18, stiffness / 4": STEPS,
    "17-18, stiffness / 16": STEPS,
    "skin over radius at 2.5e-5 s": (0.05, 0.1, 0.2, 0.4, 0.8),
}


def prepare(ladder: str, setting: float):
    """The run to rest; the last ladder moves no force, only the cost."""
    model, _ = scene(ACROSS, LEVELS)
    if ladder.startswith("skin"):
        return _run(replace(model, dt=STEP), setting * RADIUS)
    integrator, *change = ladder.split(", ")
    if change == ["dashpot implicit"]:
        model = with_dashpot(model, "spring-dashpot-implicit")
    elif change:
        model = softened(model, 1.0 / float(change[0].removeprefix("stiffness / ")))
    return _run(replace(model, integrator=integrator, dt=setting))


def _run(model, skin: float = 0.0):
    def run():
        engine = Engine(model, skin=skin)
        try:
            engine.step_to(round(REST / model.dt))
        except Explosion:
            return {"wall_force": np.array(np.nan), "wall_push": np.nan}
        force = wall_force(engine, PARTS)
        return {"wall_force": force, "wall_push": force.sum()}

    return run


def reference():
    """Velocity Verlet at a quarter of the finest step."""
    return prepare("velocity-verlet", STEPS[-1] / 4.0)()
