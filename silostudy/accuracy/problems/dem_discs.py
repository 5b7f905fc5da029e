"""How many discs stand for the solid: how hard a loose filling of one shape presses on the walls."""

from math import pi, sqrt

import numpy as np

from silostudy.accuracy.silo import DENSITY, GRAVITY, contact, wall_force, walls_of
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.packing import PACKINGS

WIDTH, SLENDERNESS, SOLID, SPREAD = 0.2, 2.0, 0.82, 0.2
REST, STEP_AT = 1.5, (2.0e-5, 0.01)  # s; step (s) for discs of a radius (m): it shrinks with the radius
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
        x, y, radii = PACKINGS["loose"].place(width=WIDTH, count=count, radius=radius, spread=SPREAD, seed=seed)
        walls = walls_of(WIDTH, 2.0 * float(y.max()), 0.1 * WIDTH)
        dt = STEP_AT[0] * radius / STEP_AT[1]
        models.append(Model(x, y, radii, DENSITY, walls, _damped(radius), _damped(radius, 2.0, 0.176), dt))

    def run():
        return {"wall_push": np.array([_push(model) for model in models])}

    return run


def _damped(radius: float, factor: float = 1.0, friction: float = 0.577):
    """The same damping ratio for discs of every size: the dashpot goes with the root of the mass."""
    one = contact(factor, friction)
    values = dict(one.coefficients)
    for name in ("normal_damping", "tangential_damping"):
        values[name] *= radius / STEP_AT[1]
    return type(one)(one.laws, values)


def _push(model: Model) -> float:
    """Normal force of both walls over the weight (1)."""
    engine = Engine(model)
    engine.step_to(round(REST / model.dt))
    return float(wall_force(engine, 1).sum() / (engine.mass.sum() * GRAVITY))
