"""What the finite step makes of a restitution: told before a run, and what the engine then does."""

import re
from math import pi, sqrt

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.impact import PHASES, restitutions
from silostudy.dem.integrate import INTEGRATORS
from silostudy.scene.coefficients import impact_lines

from .scenes import DENSITY, RADIUS, STIFFNESS, contact, free, rows
from .test_impacts import damping_ratio

SPEED, WAVE = 0.3, sqrt(2.0 * STIFFNESS / (DENSITY * pi * RADIUS**2))  # m/s; 1/s, of two discs
DAMPING = damping_ratio(0.5) * DENSITY * pi * RADIUS**2 * WAVE


def two(step, apart=0.0, integrator="17-18"):
    """Two discs that close at a speed, in steps of so many of the wave's; e is 0.5."""
    places = np.array([0.4, 0.4 + 2.0 * RADIUS + apart])
    return free(places, np.full(2, 0.5), u=np.array([0.5, -0.5]) * SPEED, dt=step / WAVE, integrator=integrator,
                pair_contact=contact(damping=DAMPING))  # fmt: skip


def of_engine(step, phase, integrator):
    engine = Engine(two(step, phase * SPEED * step / WAVE, integrator))
    engine.step_to(round(20.0 / step))
    one, other = rows(engine)
    return (other[2] - one[2]) / SPEED


@pytest.mark.parametrize(
    "integrator", ["17-18", *(pytest.param(key, marks=pytest.mark.long) for key in INTEGRATORS if key != "17-18")]
)
@pytest.mark.parametrize("step", [0.8, 0.2])
def test_it_is_what_the_engine_does(integrator, step):
    told = restitutions(two(step, integrator=integrator), SPEED)
    done = [of_engine(step, (k + 0.5) / PHASES, integrator) for k in (0, 7, 15)]
    assert done == pytest.approx(told[[0, 7, 15]], rel=2e-3)


def test_it_vanishes_with_the_step():
    off = [np.abs(restitutions(two(step), SPEED) - 0.5).max() for step in (0.8, 0.08, 0.008)]
    assert off[0] > 0.03
    assert off[1] < 0.2 * off[0]
    assert off[2] < 0.2 * off[1]


def test_it_is_told():
    (line,) = impact_lines(two(0.8))
    told = r"restitution of two discs that meet at 0.63 m/s, .*: (\S+) to (\S+) at this step, (\S+) at a fine one"
    least, most, fine = map(float, re.fullmatch(told, line).groups())
    assert least < 0.46 < 0.54 < most
    assert fine == pytest.approx(0.5, abs=3e-3)
