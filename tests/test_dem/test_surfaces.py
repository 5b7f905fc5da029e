"""Walls of a scene of discs that are not alike."""

from math import cos, radians, sin, tan

import numpy as np
import pytest

from silostudy.dem.change import set_friction
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import SLIDING, TURNOVER, balance
from silostudy.dem.model import Wall
from silostudy.dem.varied import Varied
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from silostudy.tables.kiyama_1983 import RADIUS
from tests.test_dem.scenes import against_walls, contact, free, silo

pytestmark = pytest.mark.long  # a kernel of its own
STEPS = 4000
DIFFERENT = Varied((contact(2.0, 0.05), contact(1.5, 0.6), contact(1.0, 0.2)))


def stepped(model, **how):
    engine = Engine(model, **how)
    engine.step_to(STEPS)
    order = np.argsort(engine.labels)
    return engine.bodies.rows[: engine.n][order][:, :5], engine.record.window.copy()


def same(a, b):
    return all(np.array_equal(one, other) for one, other in zip(a, b, strict=True))


def test_equal_walls_are_one_to_the_bit():
    one = against_walls()
    assert same(stepped(silo(slit=0.0, wall_contact=Varied((one,) * 3))), stepped(silo(slit=0.0, wall_contact=one)))


def test_however_it_is_carried_out():
    model = silo(slit=0.0, wall_contact=DIFFERENT)
    reference = stepped(model)
    assert not same(reference, stepped(silo(slit=0.0)))
    assert same(stepped(model, skin=0.3 * RADIUS), reference)
    assert same(stepped(model, threads=2), reference)


@pytest.mark.parametrize("change", [False, True])
def test_one_slope_of_two_frictions(change):
    """A disc rolls down at 2/3 g sin while the slope's tangent is three times the friction at most, else it slides.

    change: whether an event sets the friction of one wall.
    """
    slope, rough, slippery = radians(30.0), 1.2 * tan(radians(30.0)) / 3.0, 0.4 * tan(radians(30.0)) / 3.0
    walls = (
        Wall("left", (-10.0, 0.0), (0.0, 0.0), joined=(False, True)),
        Wall("right", (0.0, 0.0), (10.0, 0.0), joined=(True, False)),
    )
    touch = Varied((contact(2.0, rough), contact(2.0, rough if change else slippery)))
    pull = GRAVITY * sin(slope), -GRAVITY * cos(slope)
    engine = Engine(free([-5.0, 5.0], [RADIUS, RADIUS], walls=walls, wall_contact=touch, gravity=pull, dt=1e-5, watched=True))
    if change:
        set_friction(engine, wall=slippery, walls=("right",))
    engine.step_to(20000)
    u = engine.bodies.rows[: engine.n, 2][np.argsort(engine.labels)]
    expected = GRAVITY * np.array([2.0 / 3.0 * sin(slope), sin(slope) - slippery * cos(slope)])
    assert u / engine.time == pytest.approx(expected, rel=5e-3)


def test_the_ledger_closes():
    engine = Engine(silo(slit=0.0, booked=True, wall_contact=DIFFERENT))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    engine.step_to(STEPS)
    account = engine.ledger.account
    assert account[SLIDING] > 0.001 * account[TURNOVER]
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]
