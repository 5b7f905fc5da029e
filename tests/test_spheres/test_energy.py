"""The energy balance of spheres under every effect of a contact: each loss stands under its own name, of the right size."""

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.ledger import CREATED, DASHPOT, ELASTIC, KINETIC, POTENTIAL, SLIDING, TURNOVER, balance
from silostudy.dem.snapshot import held_energy
from tests.test_spheres.scenes import GRAVITY, MASS, RADIUS, contact, heap, rows, spheres
from tests.test_spheres.test_clinging import ADHESION, ceiling, clinging, pile, sticky

pytestmark = pytest.mark.long


@pytest.mark.parametrize("scene", [heap, pile], ids=["hertz and mindlin", "every effect"])
def test_it_closes(scene):
    engine = Engine(scene(booked=True, dt=5e-6))
    engine.step_to(1)
    account = engine.ledger.account
    start = balance(account)
    for _ in range(10):
        engine.step_to(engine.step + 2000)
        assert abs(balance(account) - start) < 1e-10 * account[TURNOVER]
    assert abs(account[CREATED]) < 0.05 * account[TURNOVER]
    assert account[DASHPOT] > 1e-3 * account[TURNOVER]
    assert account[SLIDING] > 1e-3 * account[TURNOVER]
    found = rows(engine)
    assert account[POTENTIAL] == pytest.approx(MASS * GRAVITY * found[:, 2].sum(), rel=1e-3)


def test_a_snapshot_finds_the_same_elastic_energy():
    """Contact by contact in Python what the ledger adds up in the kernel."""
    engine = Engine(pile(booked=True, dt=5e-6, layers=4))
    engine.step_to(8000)
    before = held_energy(engine)
    engine.step_to(8001)
    assert engine.ledger.account[ELASTIC] != 0.0
    assert engine.ledger.account[ELASTIC] == pytest.approx(before, rel=1e-2)


def test_a_bounce_gives_its_energy_to_the_dashpot_alone():
    """A head-on impact of restitution e: (1 - e^2) of the energy, none of it by sliding."""
    restitution, speed = 0.6, 0.4
    touch = contact(restitution, 0.4)
    engine = Engine(spheres([(0.0, 0.0, 1.001 * RADIUS)], [(0.0, 0.0, -speed)], wall_contact=touch, dt=1e-6, booked=True))
    engine.step_to(4000)
    account = engine.ledger.account
    assert account[DASHPOT] == pytest.approx(0.5 * MASS * speed**2 * (1.0 - restitution**2), rel=2e-3)
    assert account[KINETIC] == pytest.approx(0.5 * MASS * speed**2 * restitution**2, rel=2e-3)
    assert np.abs(account[[SLIDING, ELASTIC]]).max() < 1e-12 * MASS * speed**2


def test_a_sliding_sphere_loses_two_sevenths():
    """From sliding to rolling: what friction takes is 2/7 of the energy at the start.

    A cap on the sum of spring and dashpot loads the spring in the first step, against the dashpot: that is taken off here.
    """
    speed, friction, dt = 0.2, 0.3, 2e-7
    touch = contact(0.5, friction)
    sunk = (MASS * GRAVITY / (touch.coefficients["hertz_stiffness"] * sqrt(RADIUS))) ** (2.0 / 3.0)
    model = spheres([(0.0, 0.0, RADIUS - sunk)], [(speed, 0.0, 0.0)], wall_contact=touch, gravity=(0.0, 0.0, -GRAVITY),
                    dt=dt, booked=True)  # fmt: skip
    engine = Engine(model)
    engine.step_to(1)
    account = engine.ledger.account
    loaded = account[ELASTIC]
    engine.step_to(round(1.5 * 2.0 * speed / (7.0 * friction * GRAVITY) / dt))
    lost = 0.5 * MASS * speed**2 * 2.0 / 7.0
    assert account[KINETIC] == pytest.approx(2.5 * lost, rel=1e-3)
    assert account[SLIDING] + account[DASHPOT] - loaded == pytest.approx(lost, rel=0.04)
    assert account[DASHPOT] < 1e-3 * lost


def test_surface_energy_is_lost_between_touch_and_tear():
    """Of an elastic impact with surface energy: the work of JKR's force from the tear to the first touch and no more."""
    speed = 0.1
    touch = clinging(None, 0.0)
    model = sticky([(0.0, 0.0, 0.5 - RADIUS - 1e-7)], [(0.0, 0.0, speed)], walls=(ceiling(),), dt=1e-7, booked=True)
    engine = Engine(replace(model, wall_contact=touch))
    engine.step_to(40000)
    after = rows(engine)[0]
    assert after[5] < 0.0
    assert 0.5 - after[2] > RADIUS + touch.gap(RADIUS)
    cohesion, c = touch.laws.cohesion, touch.ordered[3]
    overlaps = np.linspace(-touch.gap(RADIUS), 0.0, 4001)
    forces = []
    for overlap in overlaps:
        radius = np.sqrt(RADIUS * cohesion.pressed(overlap, RADIUS, c))
        forces.append(c[0] * radius**3 / RADIUS - np.sqrt(6.0 * pi * ADHESION * c[0] * radius**3))
    work = -np.trapezoid(forces, overlaps)
    lost = 0.5 * MASS * (speed**2 - after[5] ** 2)
    assert lost == pytest.approx(work, rel=2e-2)
    assert engine.ledger.account[SLIDING] == pytest.approx(work, rel=2e-2)
