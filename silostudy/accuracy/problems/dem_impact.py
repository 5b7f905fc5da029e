"""Head-on impact of two discs: restitution by each integrator and dashpot over the steps in a contact."""

from dataclasses import replace
from math import atan2, exp, pi, sqrt

import numpy as np

from silostudy.accuracy.silo import contact_of_discs
from silostudy.contact.normal import spring_dashpot, spring_dashpot_implicit
from silostudy.dem.engine import Engine
from silostudy.dem.integrate import PLAIN, SMOOTHED, VERLET
from silostudy.dem.lanes import U
from silostudy.dem.model import Model, Wall
from silostudy.tables.kiyama_1983 import DENSITY, RADIUS

DAMPING_RATIO = 0.2  # of critical damping
SPEED = 0.1  # m/s, of each disc
STEPS = (8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096)
LADDERS = {
    PLAIN.key: STEPS,
    SMOOTHED.key: STEPS,
    VERLET.key: STEPS,
    "17-18, dashpot implicit": STEPS,
}


def prepare(ladder: str, setting: float):
    """Places two discs so that they touch at once and part after a contact time."""
    integrator, *implicit = ladder.split(", ")
    pair = contact_of_discs(normal=(spring_dashpot_implicit if implicit else spring_dashpot).ROW)
    reduced, stiffness = 0.5 * DENSITY * pi * RADIUS**2, pair.coefficients["normal_stiffness"]
    damping = {"normal_damping": 2.0 * DAMPING_RATIO * sqrt(reduced * stiffness)}
    duration = pi / sqrt(stiffness / reduced * (1.0 - DAMPING_RATIO**2))
    model = Model(
        x=np.array([0.0, 2.0 * RADIUS]), y=np.zeros(2), radius=np.full(2, RADIUS), density=DENSITY,
        walls=(Wall("far", (-1e3, -1e3), (1e3, -1e3)),), pair_contact=replace(pair, coefficients=pair.coefficients | damping),
        wall_contact=pair, dt=duration / setting, gravity=(0.0, 0.0), integrator=integrator, u=np.array([SPEED, -SPEED]),
    )  # fmt: skip

    def run():
        engine = Engine(model)
        engine.step_to(round(1.5 * setting))
        speed = engine.column(U)
        return {"restitution": np.array(abs(speed[1] - speed[0]) / (2.0 * SPEED))}

    return run


def reference():
    """The force ends where spring and dashpot cancel: exp(-zeta / root atan2(2 zeta root, 2 zeta^2 - 1)), root^2 = 1 - zeta^2.

    Schwager & Poeschel (2007); not at hand, checked in the tests against an independent integration.
    """
    root = sqrt(1.0 - DAMPING_RATIO**2)
    angle = atan2(2.0 * DAMPING_RATIO * root, 2.0 * DAMPING_RATIO**2 - 1.0)
    return {"restitution": np.array(exp(-DAMPING_RATIO / root * angle))}
