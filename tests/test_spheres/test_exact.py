"""Motions of spheres whose answers are known exactly."""

from math import atan, cos, sin, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from silostudy.contact import elastic
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput
from tests.test_spheres.scenes import DENSITY, GRAVITY, INERTIA, MASS, MODULUS, POISSON, RADIUS, contact, heap, rows, spheres

pytestmark = pytest.mark.long  # one kernel, but a large one


def of_discs():
    laws = Laws.of(normal="line-contact")
    return Contact(laws, {one.name: 1.0 for one in laws.normal.coefficients})


E_STAR = elastic.contact_modulus(MODULUS, POISSON, MODULUS, POISSON)


def meet(speed, restitution=None, steps=4000):
    """Two equal spheres meet head on at 2 speed; the engine after some contact times, and one contact time (s)."""
    reduced, radius = MASS / 2.0, RADIUS / 2.0
    time = 2.868 * (reduced**2 / (radius * E_STAR**2 * 2.0 * speed)) ** 0.2
    touch = contact(restitution, 0.0)
    gap = 2.0 * RADIUS + 0.01 * speed * time
    model = spheres(
        [(0.0, 0.0, 0.5), (gap, 0.0, 0.5)], [(speed, 0.0, 0.0), (-speed, 0.0, 0.0)], pair_contact=touch, dt=3.0 * time / steps
    )
    return Engine(model), time


@pytest.mark.parametrize("speed", [1e-3, 0.1, 1.0])
def test_hertz_rebound(speed):
    """Contact time 2.868 (m*^2/(R* E*^2 v))^0.2 and largest overlap (15 m* v^2/(16 E* sqrt(R*)))^0.4, v the closing speed."""
    engine, time = meet(speed)
    overlaps = []
    for step in range(4000):
        engine.step_to(step + 1)
        left, right = rows(engine)
        overlaps.append(2.0 * RADIUS - (right[0] - left[0]))
    overlaps = np.array(overlaps)
    closing = 2.0 * speed
    largest = (15.0 * MASS / 2.0 * closing**2 / (16.0 * E_STAR * sqrt(RADIUS / 2.0))) ** 0.4
    assert overlaps.max() == pytest.approx(largest, rel=1e-3)
    assert (overlaps > 0.0).sum() * engine.model.dt == pytest.approx(time, rel=2e-3)
    assert right[3] == pytest.approx(speed, rel=1e-3)
    assert left[3] + right[3] == 0.0


@pytest.mark.parametrize("speed", [1e-3, 0.1, 10.0, 100.0])
@pytest.mark.parametrize("restitution", [0.9, 0.5, 0.2])
def test_one_restitution_at_every_speed(speed, restitution):
    """At 100 m/s spheres this soft would be pressed flat: there the modulus is that of glass."""
    modulus = 70e9 if speed > 1.0 else MODULUS
    touch = contact(restitution, 0.0, modulus)
    e_star = elastic.contact_modulus(modulus, POISSON, modulus, POISSON)
    time = 2.868 * ((MASS / 2.0) ** 2 / (RADIUS / 2.0 * e_star**2 * 2.0 * speed)) ** 0.2
    place = [(0.0, 0.0, 0.5), (2.0 * RADIUS + 0.01 * speed * time, 0.0, 0.5)]
    model = spheres(place, [(speed, 0.0, 0.0), (-speed, 0.0, 0.0)], pair_contact=touch, dt=time / 4000.0)
    engine = Engine(model)
    engine.step_to(40000)
    left, right = rows(engine)
    assert (right[3] - left[3]) / (2.0 * speed) == pytest.approx(restitution, rel=3e-3)


def test_damping_number_against_an_integration():
    """The number for a contact that may pull, whose formula is not ours, gives the restitution asked for."""
    for restitution in (0.95, 0.6, 0.3):
        number = elastic.damping_where_pulled(restitution)

        def rates(_, state, number=number):
            x, v = max(state[0], 0.0), state[1]
            return v, -(x**1.5) - number * x**0.25 * v

        def apart(t, state):
            return 1.0 if t < 1e-3 else state[0]

        apart.terminal = True  # type: ignore[attr-defined]
        found = solve_ivp(rates, (0.0, 200.0), (0.0, 1.0), events=apart, rtol=1e-10, atol=1e-13)
        assert -found.y[1, -1] == pytest.approx(restitution, rel=2e-3)


def test_a_sliding_sphere_comes_to_roll():
    """It rolls at 5/7 of its speed after 2 u/(7 mu g)."""
    mu, speed = 0.3, 0.2
    sunk = (MASS * GRAVITY / (4.0 / 3.0 * E_STAR * sqrt(RADIUS))) ** (2.0 / 3.0)
    touch = contact(0.5, mu)
    model = spheres([(0.0, 0.0, RADIUS - sunk)], [(speed, 0.0, 0.0)], wall_contact=touch, gravity=(0.0, 0.0, -GRAVITY), dt=2e-6)
    engine = Engine(model)
    rolling = 2.0 * speed / (7.0 * mu * GRAVITY)
    engine.step_to(round(0.5 * rolling / 2e-6))
    assert rows(engine)[0, 3] == pytest.approx(speed - 0.5 * mu * GRAVITY * rolling, rel=2e-3)
    engine.step_to(round(3.0 * rolling / 2e-6))
    (row,) = rows(engine)
    assert row[3] == pytest.approx(5.0 / 7.0 * speed, rel=2e-3)
    assert row[7] * RADIUS == pytest.approx(row[3], rel=2e-3)  # about the y axis
    assert row[[4, 6, 8]] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("share", [0.6, 1.4])
def test_down_an_incline(share):
    """It rolls at 5/7 g sin while the tangent of the slope is 7/2 of the friction at most, else it slides."""
    mu = 0.2
    slope = atan(share * 3.5 * mu)
    normal = MASS * GRAVITY * cos(slope)
    sunk = (normal / (4.0 / 3.0 * E_STAR * sqrt(RADIUS))) ** (2.0 / 3.0)
    pull = GRAVITY * sin(slope), 0.0, -GRAVITY * cos(slope)
    engine = Engine(spheres([(0.0, 0.0, RADIUS - sunk)], wall_contact=contact(0.5, mu), gravity=pull, dt=2e-6))
    engine.step_to(50000)
    rolls = 5.0 / 7.0 * GRAVITY * sin(slope)
    slides = GRAVITY * (sin(slope) - mu * cos(slope))
    assert rows(engine)[0, 3] / engine.time == pytest.approx(rolls if share < 1.0 else slides, rel=3e-3)


@pytest.mark.parametrize("angle", [75.0, 80.0])
def test_gross_slip_of_an_oblique_impact(angle):
    """While v_t > 7/2 mu (1 + e) v_n: v_t' = v_t - mu (1 + e) v_n, spin 5/2 mu (1 + e) v_n/r."""
    mu, restitution, speed = 0.1, 0.8, 1.0
    across, down = speed * sin(np.radians(angle)), speed * cos(np.radians(angle))
    assert across > 3.5 * mu * (1.0 + restitution) * down
    touch = contact(restitution, mu)
    engine = Engine(spheres([(0.0, 0.0, 1.0001 * RADIUS)], [(across, 0.0, -down)], wall_contact=touch, dt=2e-7))
    engine.step_to(20000)
    (row,) = rows(engine)
    assert row[5] == pytest.approx(restitution * down, rel=3e-3)
    assert row[3] == pytest.approx(across - mu * (1.0 + restitution) * down, rel=1e-3)
    assert row[7] == pytest.approx(2.5 * mu * (1.0 + restitution) * down / RADIUS, rel=5e-3)


def test_momentum_and_angular_momentum_of_a_cloud():
    """A cloud of spheres that collide with friction keeps both, up to the way of a step."""
    random = np.random.default_rng(1)
    place = np.array([(i, j, k) for i in range(4) for j in range(4) for k in range(4)], float) * 2.05 * RADIUS
    centre = place.mean(axis=0)
    velocity = -20.0 * (place - centre) + random.normal(size=place.shape) * 0.02
    spin = random.normal(size=place.shape) * 50.0
    engine = Engine(spheres(place + 0.5, velocity, spin, pair_contact=contact(0.8, 0.4), dt=5e-7))

    def sums():
        found = rows(engine)
        linear = MASS * found[:, 3:6].sum(axis=0)
        angular = (MASS * np.cross(found[:, :3] - centre - 0.5, found[:, 3:6]) + INERTIA * found[:, 6:9]).sum(axis=0)
        return linear, angular

    (before, turning), scale = sums(), MASS * np.abs(velocity).sum()
    engine.step_to(20000)
    after, turned = sums()
    assert np.abs(rows(engine)[:, 3:6] - velocity[np.argsort(np.arange(64))]).max() > 0.01
    assert after == pytest.approx(before, abs=1e-12 * scale)
    assert turned == pytest.approx(turning, abs=2e-6 * scale * 4.0 * RADIUS)


@pytest.fixture(scope="module")
def settled():
    engine = Engine(heap())
    engine.step_to(60000)
    return engine


def test_floor_and_wall_carry_the_weight(settled):
    settled.clear_window()
    settled.step_to(settled.step + 4000)
    mean = settled.record.window[:, :, 0] / 4000
    cells = settled.walls.cells
    floor, cylinder = (mean[first : first + along * around] for first, along, around, *_ in cells)
    carried = floor[:, 0].sum() + cylinder[:, 1].sum()
    assert carried == pytest.approx(settled.n * MASS * GRAVITY, rel=1e-3)
    assert cylinder[:, 1].sum() > 0.01 * carried  # friction of the wall takes a part
    assert cylinder[:, 0].min() >= 0.0


def test_all_spheres_stay_inside(settled):
    place = rows(settled)[:, :3]
    wide = settled.model.wall_named("cylinder").start[0]
    assert (np.hypot(place[:, 0], place[:, 1]) < wide - 0.9 * RADIUS).all()
    assert (place[:, 2] > 0.9 * RADIUS).all()
    density = settled.n * MASS / DENSITY / (np.pi * wide**2 * (place[:, 2].max() + RADIUS))
    assert 0.4 < density < 0.65  # solid fraction


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"gravity": (0.0, -9.81)}, "gravity = .* must have three components"),
        ({"pair_contact": of_discs()}, "pair_contact.normal = 'line-contact': is a law of discs, not of spheres"),
        ({"radius": np.array([0.0])}, "radius = 0.0: must be positive"),
    ],
)
def test_models_that_are_none(changes, message):
    with pytest.raises(BadInput, match=message):
        spheres([(0.0, 0.0, 0.0)], **changes)
