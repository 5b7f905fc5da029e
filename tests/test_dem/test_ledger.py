"""The energy balance closes, and what the finite step creates shrinks with it."""

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.ledger import CARRIED_OUT, CREATED, DASHPOT, KINETIC, SLIDING, TURNOVER, balance
from silostudy.dem.pieces import Laws
from silostudy.dem.run import Run

from .scenes import box, contact, free, rows, silo

OPEN = ("floor", "floor_left", "floor_right")


def booked(integrator="17-18", dt=2.5e-5, flow=True):
    engine = Engine(silo(booked=True, integrator=integrator, dt=dt))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    events = (Event("time", 0.02, "open", OPEN), Event("time", 0.3, "stop")) if flow else (Event("time", 0.05, "stop"),)
    run = Run(engine, events, limit=1.0)
    run.go()
    return engine, start, run


@pytest.mark.long
@pytest.mark.parametrize("integrator", ["17-18", "17-19", "velocity-verlet"])
def test_the_ledger_closes(integrator):
    engine, start, run = booked(integrator, dt=1e-5)
    account = engine.ledger.account
    assert run.dropped > 0.0
    assert account[CARRIED_OUT] != 0.0
    assert account[DASHPOT] > 0.0
    assert account[SLIDING] > 0.0
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]


def test_what_the_step_creates_shrinks_with_it():
    created = []
    for dt in (2e-5, 1e-5, 5e-6):
        engine, _, _ = booked(dt=dt, flow=False)
        created.append(abs(engine.ledger.account[CREATED]) / engine.ledger.account[TURNOVER])
    assert created[0] > 1.5 * created[1] > 1.5**2 * created[2]
    assert created[2] < 1e-2


def test_the_ledger_changes_no_bit():
    plain, kept = Engine(silo()), Engine(silo(booked=True))
    for engine in (plain, kept):
        engine.step_to(4000)
    assert np.array_equal(rows(plain), rows(kept))


@pytest.mark.long
@pytest.mark.parametrize("slider", ["spring-slider", "spring-slider-total", "spring-slider-implicit"])
def test_what_the_step_creates_in_a_sliding_impact_vanishes_with_it(slider):
    """A cap on the sum makes the spring's force jump at first touch: what the spring then takes is no error of the step."""
    touch = contact(friction=0.2, laws=Laws.of(tangential=slider))
    created = []
    for dt in (4e-6, 2e-6, 1e-6):
        engine = Engine(
            free([0.0, 0.02], [0.0, 0.004], [0.3, -0.3], [0.0, 0.5], [10.0, 30.0], pair_contact=touch, booked=True, dt=dt)
        )
        engine.step_to(round(4e-3 / dt))
        created.append(abs(engine.ledger.account[CREATED]) / engine.ledger.account[TURNOVER])
    assert created[0] > 1.6 * created[1] > 1.6**2 * created[2]
    assert created[2] < 0.02


@pytest.mark.long
def test_a_disc_that_spins_on_a_frictionless_floor_loses_nothing():
    touch = contact(friction=0.0)
    disc = free(
        [0.1],
        [0.0099],
        w=[-75.0],
        walls=box(0.2, 0.2),
        gravity=(0.0, -9.81),
        pair_contact=touch,
        wall_contact=touch,
        booked=True,
        dt=5e-5,
    )
    engine = Engine(disc)
    engine.step_to(20_000)
    account = engine.ledger.account
    spinning = 0.25 * disc.mass[0] * disc.radius[0] ** 2 * 75.0**2
    assert account[KINETIC] == pytest.approx(spinning, rel=1e-9)
    assert abs(account[SLIDING]) < 1e-12 * spinning
