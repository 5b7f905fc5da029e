"""Surfaces of a scene of spheres that are not like the other walls."""

from dataclasses import replace
from math import cos, radians, sin, tan
from pathlib import Path

import numpy as np
import pytest

from silostudy.compute.dem import scene_model
from silostudy.dem.change import set_friction
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import DASHPOT, SLIDING, TURNOVER, balance
from silostudy.dem.varied import Varied
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from tests.test_spheres.scenes import RADIUS, contact, heap, rows, same, stepped
from tests.test_spheres.small import scene_of

pytestmark = pytest.mark.long  # a kernel of its own
# at the cylinder and at the floor
ROUGH, SMOOTH, STEPS = contact(0.5, 0.6), contact(0.2, 0.05, 5e6), 4000
DIFFERENT = Varied((SMOOTH, ROUGH))


def narrow(**changes):
    """Spheres that fall in a cylinder hardly wider than they lie, so that they touch it soon."""
    return heap(wide=4.1 * RADIUS, **changes)


@pytest.fixture(scope="module")
def reference():
    return stepped(Engine(narrow(wall_contact=DIFFERENT)), STEPS)


def test_equal_surfaces_are_one_to_the_bit():
    one = contact(0.5, 0.3)
    assert same(
        stepped(Engine(narrow(wall_contact=Varied((one, one)))), STEPS), stepped(Engine(narrow(wall_contact=one)), STEPS)
    )


def test_each_surface_pushes_as_its_own(reference):
    for other in (Varied((ROUGH, ROUGH)), Varied((SMOOTH, SMOOTH)), Varied((ROUGH, SMOOTH))):
        assert not np.array_equal(stepped(Engine(narrow(wall_contact=other)), STEPS)[0], reference[0])


@pytest.mark.parametrize("how", [{"skin": 0.5 * RADIUS}, {"threads": 2}], ids=str)
def test_however_it_is_carried_out(reference, how):
    assert same(stepped(Engine(narrow(wall_contact=DIFFERENT), **how), STEPS), reference)


def test_restart_after_a_change_of_friction_at_one_surface():
    """The friction of the cylinder alone has changed, and goes on so from a checkpoint."""
    whole, after = Engine(narrow(wall_contact=DIFFERENT)), Engine(narrow(wall_contact=DIFFERENT))
    whole.step_to(1500)
    set_friction(whole, wall=0.9, walls=("cylinder",))
    assert [one.coefficients["sliding_friction"] for one in whole.contacts[1].sets] == [0.05, 0.9]
    whole.step_to(2000)
    restore(after, checkpoint(whole))
    assert after.contacts == whole.contacts
    assert same(stepped(after, STEPS), stepped(whole, STEPS))


def test_python_twin():
    compiled, plain = (Engine(narrow(layers=1, u=0.3, w=-0.2, wall_contact=DIFFERENT)) for _ in range(2))
    plain._kernel = plain._kernel.py_func
    for engine in (compiled, plain):
        engine.step_to(400)
    assert np.abs(rows(compiled)[:, 6:]).max() > 0.1  # they touch, and roll
    assert np.allclose(rows(plain), rows(compiled), rtol=1e-9, atol=1e-12)


def test_the_ledger_closes():
    engine = Engine(narrow(booked=True, layers=6, wall_contact=DIFFERENT))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    engine.step_to(6000)
    account = engine.ledger.account
    assert min(account[DASHPOT], account[SLIDING]) > 0.01 * account[TURNOVER]
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]


SLOPE = radians(60.0)  # of the hopper of the small bin, from the level


@pytest.mark.parametrize(("friction", "others"), [(1.2 * tan(SLOPE) / 3.5, 0.01), (0.5 * tan(SLOPE) / 3.5, 0.9)])
def test_down_a_hopper_by_its_own_friction(friction, others):
    """It rolls down the cone at 5/7 g sin while the slope's tangent is 7/2 of the cone's friction at most, else it slides."""
    scene = scene_of(
        surfaces={"hopper": {"sliding_friction": friction}}, walls__sliding_friction=others,
        sizes={"kind": "equal", "diameter_mm": 1}, filling={"kind": "loose", "count": 1},
        record__snapshots_s=[], grain__softened_modulus_MPa=None,
    )  # fmt: skip
    model = scene_model(scene, Path())
    radius, cone = float(model.radius[0]), model.wall_named("hopper")
    r, z = 0.1 * np.array(cone.start) + 0.9 * np.array(cone.end)
    place = {"x": np.array([r - radius * sin(SLOPE)]), "y": np.zeros(1), "z": np.array([z + radius * cos(SLOPE)])}
    engine = Engine(replace(model, **place, dt=2e-6))
    engine.step_to(2000)  # it has come to touch
    before, begun = rows(engine)[0, 3:6], engine.time
    engine.step_to(14000)
    gained = np.linalg.norm(rows(engine)[0, 3:6] - before) / (engine.time - begun)
    rolling, sliding = 5.0 / 7.0 * sin(SLOPE), sin(SLOPE) - friction * cos(SLOPE)
    assert gained == pytest.approx(GRAVITY * (rolling if friction > tan(SLOPE) / 3.5 else sliding), rel=5e-3)
