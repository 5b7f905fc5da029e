"""The energy balance of spheres closes, and what the finite step creates shrinks with it."""

import numpy as np
import pytest

from silostudy.compute.dem_cube import cube_of
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import CARRIED_OUT, CREATED, DASHPOT, ELASTIC, SLIDING, TURNOVER, balance
from silostudy.dem.pieces import Laws
from tests.test_spheres.scenes import MASS, RADIUS, contact, heap, rows, spheres
from tests.test_spheres.small import carried, scene_of

pytestmark = pytest.mark.long
ROLLING = Laws.of(normal="hertz", tangential="mindlin-rescaled", rolling="spring-slider")


@pytest.mark.parametrize("integrator", ["17-18", "velocity-verlet"])
def test_the_ledger_closes(integrator):
    engine = Engine(heap(booked=True, layers=6, integrator=integrator))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    engine.step_to(6000)
    account = engine.ledger.account
    assert account[DASHPOT] > 0.01 * account[TURNOVER]
    assert account[SLIDING] > 0.01 * account[TURNOVER]
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]
    assert abs(account[CREATED]) < 0.01 * account[TURNOVER]


def test_rolling_springs_and_sizes_are_booked():
    many = contact(0.5, laws=Laws.of(normal="hertz", tangential="mindlin"))
    rolls = type(many)(ROLLING, many.coefficients | {"rolling_friction": 0.1, "rolling_stiffness": 1e-6})
    model = heap(booked=True, layers=6, pair_contact=rolls)
    uneven = heap(booked=True, layers=6, pair_contact=rolls, radius=np.where(np.arange(len(model.x)) % 3, 1.0, 0.8) * RADIUS)
    engine = Engine(uneven)
    engine.step_to(1)
    start = balance(engine.ledger.account)
    engine.step_to(4000)
    assert abs(balance(engine.ledger.account) - start) < 1e-9 * engine.ledger.account[TURNOVER]


def test_what_the_step_creates_among_spheres_that_lie_vanishes_with_it():
    """Contacts open and close there, each with a dashpot that loads and frees its spring at a stroke."""
    created, touch = [], contact(0.5, friction=0.5)
    for finer in (1, 4, 16):
        engine = Engine(heap(booked=True, layers=6, pair_contact=touch, wall_contact=touch, dt=1e-5 / finer))
        engine.step_to(4000 * finer)
        created.append(abs(engine.ledger.account[CREATED]) / engine.ledger.account[SLIDING])
    assert created[0] < 0.05
    assert created[2] < 0.4 * created[1] < 0.4**2 * created[0]


@pytest.mark.parametrize("tangential", ["mindlin", "mindlin-rescaled"])
def test_what_the_step_creates_in_an_oblique_impact_vanishes_with_it(tangential):
    touch = contact(0.6, friction=0.3, laws=Laws.of(normal="hertz", tangential=tangential))
    created = []
    for dt in (4e-6, 2e-6, 1e-6):
        place, velocity = [(0.0, 0.0, 0.5), (2.0 * RADIUS, 0.0, 0.501)], [(0.5, 0.1, 0.0), (-0.5, 0.0, 0.2)]
        engine = Engine(spheres(place, velocity, [(50.0, 0.0, 20.0), (0.0, 30.0, 0.0)], pair_contact=touch, booked=True, dt=dt))
        engine.step_to(round(2e-3 / dt))
        account = engine.ledger.account
        assert account[ELASTIC] == 0.0
        assert account[DASHPOT] > 0.0
        lost = 0.5 * MASS * (np.square(velocity).sum() - (rows(engine)[:, 3:6] ** 2).sum())
        lost += 0.2 * MASS * RADIUS**2 * (2900.0 + 900.0 - (rows(engine)[:, 6:] ** 2).sum())
        assert account[DASHPOT] + account[SLIDING] - account[CREATED] == pytest.approx(lost, rel=1e-9)
        created.append(abs(account[CREATED]) / account[TURNOVER])
    assert created[2] < 0.6 * created[0]
    assert created[2] < 5e-3


def test_a_scene_that_rains_opens_and_flows_out_keeps_its_balance():
    scene = scene_of(record__energy=True, record__snapshots_s=[])
    whole = carried(scene)
    account = whole.engine.ledger.account
    assert whole.recording.left["discharged"] > 20
    assert account[CARRIED_OUT] != 0.0
    assert abs(balance(account)) < 1e-9 * account[TURNOVER]  # nothing was there at the start
    entries = cube_of(whole, scene).energy.isel(window_time=-1)
    assert float(entries.sel(energy_entry="sliding")) == account[SLIDING]


def test_the_ledger_changes_no_bit():
    plain, kept = Engine(heap(layers=6)), Engine(heap(layers=6, booked=True))
    for engine in (plain, kept):
        engine.step_to(3000)
    assert np.array_equal(rows(plain), rows(kept))
