"""Number of discs that stand for the solid: how hard a loose filling of one shape presses on the walls."""

from math import pi, sqrt

import numpy as np

from silostudy.accuracy.silo import DOWN, contact_of_discs, contact_with_walls, wall_force
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model
from silostudy.packing import loose
from silostudy.scene.plane_silo import PlaneSilo
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.kiyama_1983 import DENSITY, RADIUS

WIDTH = 0.2  # m, of the silo
SLENDERNESS = 2.0  # height of the filling over the width
SOLID = 0.82  # share of the filling's area that the discs take
SPREAD = 0.2  # of radii: they lie evenly so far below and above their mean, relative to it
REST = 1.5  # s to rest
STEP_AT = (2.0e-5, RADIUS)  # s, for discs of a radius (m): the step shrinks with the radius
DISCS = (16, 32, 64, 128, 256)
LADDERS = {"discs": DISCS}


def prepare(ladder: str, setting: float, members: int):
    """Fillings that differ by their seed."""
    return _run(int(setting), range(members))


def reference(members: int):
    """Twice the finest number of discs, with seeds of their own."""
    return _run(2 * DISCS[-1], range(10_000, 10_000 + members))()


def _run(count: int, seeds):
    radius = sqrt(SOLID * SLENDERNESS * WIDTH**2 / (pi * count))
    models = []
    for seed in seeds:
        x, y, radii = loose.place(width=WIDTH, count=count, radius=radius, spread=SPREAD, seed=seed)
        walls = PlaneSilo(WIDTH, 2.0 * float(y.max()), 0.1 * WIDTH).walls()
        dt = STEP_AT[0] * radius / STEP_AT[1]
        models.append(
            Model(
                x,
                y,
                radii,
                DENSITY,
                walls,
                _damped(contact_of_discs(), radius),
                _damped(contact_with_walls(), radius),
                dt,
                DOWN,
            )
        )

    def run():
        return {"wall_push": np.array([_push(model) for model in models])}

    return run


def _damped(contact: Contact, radius: float) -> Contact:
    """The same damping ratio for discs of every size: the dashpot goes with the root of the mass."""
    values = dict(contact.coefficients)
    for name in ("normal_damping", "tangential_damping"):
        values[name] *= radius / STEP_AT[1]
    return Contact(contact.laws, values)


def _push(model: Model) -> float:
    """Normal force of both walls over the weight (1)."""
    engine = Engine(model)
    engine.step_to(round(REST / model.dt))
    return float(wall_force(engine, 1).sum() / (engine.mass.sum() * ROUNDED_GRAVITY))
