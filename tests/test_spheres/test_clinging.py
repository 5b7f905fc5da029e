"""Spheres whose contacts hold on, roll and twist with resistance: one kernel with every effect that a contact may have."""

from math import pi, sqrt

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.space.walls import TurnedLine
from tests.test_spheres.scenes import INERTIA, MASS, RADIUS, contact, heap, rows, spheres

pytestmark = pytest.mark.long
LAWS = Laws.of(
    normal="hertz", tangential="mindlin-rescaled", rolling="spring-dashpot-slider", cohesion="jkr", twisting="marshall"
)
ADHESION = 0.5  # J/m2


def clinging(restitution=0.3, friction=0.5) -> Contact:
    hertz = contact(restitution, friction).coefficients
    more = {"rolling_stiffness": 1e-4, "rolling_damping": 1e-9, "rolling_friction": 0.05, "work_of_adhesion": ADHESION}
    return Contact(LAWS, hertz | more)


def sticky(place, velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), **changes):
    return spheres(place, velocity, spin, pair_contact=clinging(), wall_contact=clinging(), **changes)


def ceiling():
    return TurnedLine(name="ceiling", start=(0.0, 0.5), end=(1.0, 0.5), joined=(True, True))


def test_a_ceiling_holds_a_sphere_up_to_the_pull_off_force():
    """1.5 pi times work of adhesion times reduced radius, which at a plane is the sphere's own."""
    largest = 1.5 * pi * ADHESION * RADIUS / MASS
    engine = Engine(sticky([(0.0, 0.0, 0.5 - 0.999 * RADIUS)], walls=(ceiling(),)))
    for share in np.linspace(0.0, 0.98, 50):
        engine.gravity = (0.0, 0.0, -share * largest)
        engine.step_to(engine.step + 4000)
    hanging = rows(engine)[0]
    assert 0.5 - hanging[2] > RADIUS  # apart, and still held
    assert abs(hanging[5]) < 1e-5
    engine.gravity = (0.0, 0.0, -1.02 * largest)
    engine.step_to(engine.step + 20000)
    assert rows(engine)[0, 5] < -0.02


def test_what_has_not_touched_is_not_held():
    gap = clinging().gap(RADIUS)
    for height, moves in ((0.5 * gap, False), (-0.01 * gap, True)):
        engine = Engine(sticky([(0.0, 0.0, 0.5 - RADIUS - height)], walls=(ceiling(),)))
        engine.step_to(200)
        assert (abs(rows(engine)[0, 5]) > 0.0) == moves


def test_a_tumbling_cluster_keeps_its_angular_momentum_and_turns_as_one():
    """Spin about three axes: what is held in the contacts turns with them, and no moment acts from within."""
    turns = np.arange(3) * 2.0 * pi / 3.0
    flat = 2.0 * RADIUS / sqrt(3.0) * np.c_[np.cos(turns), np.sin(turns), np.zeros(3)]
    place = np.vstack([flat, (0.0, 0.0, 2.0 * RADIUS * sqrt(2.0 / 3.0))]) * 0.9999
    place -= place.mean(axis=0)
    turning = np.array([9.0, -6.0, 14.0])
    spin = turning + np.array([[5.0, 0.0, 0.0], [0.0, -5.0, 0.0], [0.0, 0.0, 5.0], [-5.0, 5.0, -5.0]])
    engine = Engine(sticky(place + 0.5, np.cross(turning, place) + np.array([0.01, 0.02, -0.01]), spin, dt=1e-6))

    def sums():
        found = rows(engine)
        away = found[:, :3] - found[:, :3].mean(axis=0)
        return MASS * found[:, 3:6].sum(axis=0), (MASS * np.cross(away, found[:, 3:6]) + INERTIA * found[:, 6:9]).sum(axis=0)

    linear, angular = sums()
    engine.step_to(400000)  # a turn
    after, turned = sums()
    assert after == pytest.approx(linear, rel=1e-9)
    assert turned == pytest.approx(angular, abs=1e-4 * np.linalg.norm(angular))
    found = rows(engine)
    away, moving = found[:, :3] - found[:, :3].mean(axis=0), found[:, 3:6] - found[:, 3:6].mean(axis=0)
    together = found[:, 6:9].mean(axis=0)
    assert np.linalg.norm(together) > 10.0
    assert np.abs(found[:, 6:9] - together).max() < 0.01 * np.linalg.norm(together)
    assert np.abs(moving - np.cross(together, away)).max() < 0.01 * np.abs(moving).max()
    assert np.abs(found[:, :3] - place - 0.5).max() > 0.5 * RADIUS


def test_twisting_brings_spins_together():
    """Two spheres that spin about their common normal: each gives the other half; nothing else moves."""
    place = [(0.0, 0.0, 0.5), (0.0, 0.0, 0.5 + 1.999 * RADIUS)]
    engine = Engine(sticky(place, spin=[(0.0, 0.0, 30.0), (0.0, 0.0, -10.0)]))
    engine.step_to(200000)
    found = rows(engine)
    assert found[:, 8].sum() == pytest.approx(20.0, rel=1e-12)
    assert found[0, 8] - found[1, 8] == pytest.approx(0.0, abs=2.0)  # of 40: the spring about the normal swings on for a while
    assert np.abs(found[:, 6:8]).max() == 0.0


def five():
    """Five spheres that press each other and the floor, moving and spinning every way."""
    random = np.random.default_rng(7)
    place = np.array([(0, 0, 0.99), (1.98, 0, 0.99), (0, 1.98, 0.99), (1.0, 1.0, 2.4), (-1.98, 0.1, 1.05)]) * RADIUS
    return sticky(place, random.normal(size=(5, 3)) * 0.05, random.normal(size=(5, 3)) * 20.0, gravity=(0.0, 0.0, -9.81))


def test_the_compiled_step_is_the_one_in_python():
    compiled, plain = Engine(five()), Engine(five())
    plain._kernel = plain._kernel.py_func
    for engine in (compiled, plain):
        engine.step_to(100)
    assert np.abs(rows(compiled) - rows(Engine(five()))).max() > 1e-2
    assert np.allclose(rows(compiled), rows(plain), rtol=1e-10, atol=1e-13)
    assert np.allclose(compiled.record.window, plain.record.window, rtol=1e-10, atol=1e-13)


def pile(**changes):
    return heap(pair_contact=clinging(0.5, 0.5), wall_contact=clinging(0.5, 0.3), **changes)


def stepped(engine, steps=4000):
    engine.step_to(steps)
    return rows(engine)


@pytest.fixture(scope="module")
def reference():
    return stepped(Engine(pile()))


def gaps(engine):
    """Gaps (m) of the pairs that are in touch."""
    pairs, _ = engine.take_memories()
    first, second = pairs.key >> 32, pairs.key & (2**32 - 1)
    place = engine.bodies.rows[:, :3]
    assert (pairs.touched == 1.0).all()
    return np.linalg.norm(place[first] - place[second], axis=1) - 2.0 * RADIUS


def test_contacts_of_a_pile_hold_on_across_gaps(reference):
    engine, widest = Engine(pile()), -1.0
    for step in range(0, 4000, 5):
        engine.step_to(step)
        widest = max(widest, gaps(engine).max(initial=-1.0))
    assert 0.3 * engine.model.gap < widest
    moved = 2.0 * engine.model.dt * np.abs(reference[:, 3:6]).max()  # since the contact was looked at
    assert widest < engine.model.pair_contact.gap(0.5 * RADIUS) + moved
    assert np.array_equal(stepped(engine), reference)  # looking disturbs nothing


@pytest.mark.parametrize("changes", [{"skin": 0.05 * RADIUS}, {"skin": 1.2 * RADIUS}, {"threads": 2}])
def test_same_bits_for_skins_and_threads(reference, changes):
    assert np.array_equal(stepped(Engine(pile(), **changes)), reference)


def test_same_bits_after_a_restart(reference):
    before, after = Engine(pile()), Engine(pile(), threads=2)
    before.step_to(1777)
    restore(after, checkpoint(before))
    assert np.array_equal(stepped(after), reference)
    assert np.array_equal(stepped(before), reference)
