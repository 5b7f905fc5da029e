"""Hard impacts of spheres with exact answers; one kernel, that of the other tests of Hertz and Mindlin."""

from math import cos, pi, sin, sqrt

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from silostudy.contact import elastic
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from tests.test_spheres.scenes import INERTIA, MASS, MODULUS, POISSON, RADIUS, contact, rows, spheres

pytestmark = pytest.mark.long
SURFACE = 1.0 * RADIUS  # height of a sphere that just touches the floor


def hertz_stiffness(modulus, other=None) -> float:
    """4/3 E* (Pa) of two like bodies, or of two."""
    (one, nu), (another, ratio) = (modulus, POISSON), (other or (modulus, POISSON))
    return 4.0 / 3.0 * elastic.contact_modulus(one, nu, another, ratio)


def of_an_impact(stiffness, speed, mass=MASS / 2.0, radius=RADIUS / 2.0):
    """Largest overlap (m) and duration (s) of an elastic Hertz impact by energy and Euler's beta function, 30 digits."""
    with mpmath.workdps(30):
        k, m, v = mpmath.mpf(stiffness) * mpmath.sqrt(radius), mpmath.mpf(mass), mpmath.mpf(speed)
        deepest = (5 * m * v**2 / (4 * k)) ** mpmath.mpf("0.4")
        share = mpmath.beta(mpmath.mpf(2) / 5, mpmath.mpf(1) / 2) * 2 / 5  # of 1/sqrt(1 - x^(5/2)) from 0 to 1
        return float(deepest), float(2 * deepest / v * share)


def head_on(speed, modulus, restitution=None, steps=4000):
    """Two equal spheres, about to meet at a closing speed: the engine; one impact is a third of the steps."""
    deepest, time = of_an_impact(hertz_stiffness(modulus), speed)
    place = [(0.0, 0.0, 0.5), (2.0 * RADIUS + 1e-3 * deepest, 0.0, 0.5)]
    velocity = [(0.5 * speed, 0.0, 0.0), (-0.5 * speed, 0.0, 0.0)]
    return Engine(spheres(place, velocity, pair_contact=contact(restitution, 0.0, modulus), dt=3.0 * time / steps))


def check_an_impact(speed, modulus):
    """Overlap, duration and rebound of an elastic impact as energy and the beta function give them."""
    engine, overlaps = head_on(speed, modulus), []
    for step in range(4000):
        engine.step_to(step + 1)
        left, right = rows(engine)
        overlaps.append(2.0 * RADIUS - (right[0] - left[0]))
    deepest, time = of_an_impact(hertz_stiffness(modulus), speed)
    ulp = np.spacing(2.0 * RADIUS)
    assert max(overlaps) == pytest.approx(deepest, rel=1e-5, abs=4.0 * ulp)
    assert (np.array(overlaps) > 0.0).sum() * engine.model.dt == pytest.approx(time, rel=1e-3)
    assert right[3] == pytest.approx(0.5 * speed, rel=1e-4)
    assert left[3] == -right[3]


def test_spheres_at_a_hundred_metres_a_second():
    check_an_impact(100.0, 210e9)


def test_spheres_at_a_micrometre_a_second():
    check_an_impact(1e-6, MODULUS)


@pytest.mark.parametrize("power", range(4, 13))
@pytest.mark.parametrize("restitution", [0.05, 0.5])
def test_modulus_of_spheres_over_eight_decades(power, restitution):
    """The same impact on another clock: one restitution, and that asked for."""
    modulus = 10.0**power
    speed = 1e-3 * sqrt(modulus / 2500.0)  # the same overlap over the radius
    engine = head_on(speed, modulus, restitution)
    engine.step_to(12000)
    left, right = rows(engine)[:, 3]
    assert left == -right
    assert (right - left) / speed == pytest.approx(restitution, rel=5e-3)


@pytest.mark.parametrize("restitution", [1e-3, 0.01, 1.0 - 1e-9])
def test_restitution_of_spheres_next_to_nothing_and_to_one(restitution):
    engine = head_on(0.1, MODULUS, restitution, steps=40000)
    engine.step_to(400000)
    left, right = rows(engine)[:, 3]
    assert (right - left) / 0.1 == pytest.approx(restitution, rel=0.02 if restitution < 0.1 else 1e-5)


@pytest.mark.parametrize("overlap", [1e-7, 1e-5])
def test_grazing_hertz_impact(overlap):
    """Spheres that pass: the push across is 3 pi/8 of the largest force over the time of the chord."""
    speed, modulus = 1.0, 1e4
    offset, deep = 2.0 * RADIUS * (1.0 - overlap), 2.0 * RADIUS * overlap
    half = sqrt(4.0 * RADIUS * deep)  # chord, m
    place = [(-half, 0.0, 0.5), (half, offset, 0.5)]
    dt = half / speed / 2000.0
    smooth = contact(None, 0.0, modulus)
    engine = Engine(spheres(place, [(speed, 0.0, 0.0), (-speed, 0.0, 0.0)], pair_contact=smooth, dt=dt))
    engine.step_to(8000)
    found = rows(engine)
    force = hertz_stiffness(modulus) * sqrt(RADIUS / 2.0) * deep**1.5
    impulse = 3.0 * pi / 8.0 * force * half / (2.0 * speed)
    assert found[1, 4] == pytest.approx(impulse / MASS, rel=2e-3)
    assert found[0, 4] == pytest.approx(-found[1, 4], rel=1e-12)


def test_spheres_that_pass_without_touching():
    place = [(-0.5 * RADIUS, 0.0, 0.5), (0.5 * RADIUS, 2.0 * RADIUS * (1.0 + 1e-15), 0.5)]
    velocity = [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0)]
    engine = Engine(spheres(place, velocity, dt=1e-6))
    engine.step_to(2000)
    assert np.array_equal(rows(engine)[:, 3:6], velocity)


@pytest.mark.parametrize("start", np.linspace(0.0, 1.0, 5))
def test_spheres_that_touch_for_less_than_a_step(start):
    """Seen or missed: momentum stays and no energy is won."""
    speed = 300.0
    place = [(0.0, 0.0, 0.5), ((0.3 + 0.02 * start) * RADIUS, 1.999 * RADIUS, 0.5)]
    engine = Engine(spheres(place, [(speed, 0.0, 0.0), (-speed, 0.0, 0.0)], dt=1e-6, pair_contact=contact(0.5)))
    engine.step_to(40)
    found = rows(engine)
    energy = 0.5 * (MASS * (found[:, 3:6] ** 2).sum() + INERTIA * (found[:, 6:] ** 2).sum())
    assert found[0, 3:6] == pytest.approx(-found[1, 3:6], rel=1e-14, abs=1e-14 * speed)
    assert energy <= MASS * speed**2 * (1.0 + 1e-12)


def test_grains_of_1_gpa_on_a_wall_of_210_gpa():
    """An impact on a wall that is two hundred times as stiff, against an integration of its own to 1e-10."""
    restitution, speed = 0.6, 2.0
    touch = contact(restitution, 0.0, materials=((1e9, POISSON), (210e9, 0.3)))
    stiffness = hertz_stiffness(1e9, (210e9, 0.3))
    number = elastic.damping_where_cut(restitution)

    def rates(_, state):
        sunk, v = max(state[0], 0.0), state[1]
        spring = stiffness * sqrt(RADIUS) * sunk**1.5
        push = spring + number * sqrt(stiffness * MASS * sqrt(RADIUS * sunk)) * v
        return v, -max(push, 0.0) / MASS

    _, time = of_an_impact(stiffness, speed, MASS, RADIUS)
    apart = solve_ivp(rates, (0.0, 3.0 * time), (0.0, speed), rtol=1e-10, atol=1e-16, max_step=time / 100.0)
    engine = Engine(spheres([(0.0, 0.0, SURFACE)], [(0.0, 0.0, -speed)], wall_contact=touch, dt=time / 4000.0))
    heights = []
    for step in range(12000):
        engine.step_to(step + 1)
        heights.append(rows(engine)[0, 2])
    assert SURFACE - min(heights) == pytest.approx(apart.y[0].max(), rel=2e-3)
    assert rows(engine)[0, 5] == pytest.approx(-apart.y[1, -1], rel=2e-3)
    assert -apart.y[1, -1] == pytest.approx(restitution * speed, rel=1e-4)


def test_spin_of_1e5_about_the_normal_of_an_impact():
    """Without resistance to twisting a sphere bounces as if it stood still, and goes on spinning."""
    still, spun = (
        Engine(spheres([(0.0, 0.0, SURFACE)], [(0.0, 0.0, -0.3)], (0.0, 0.0, spin), wall_contact=contact(0.7), dt=1e-6))
        for spin in (0.0, 1e5)
    )
    for engine in (still, spun):
        engine.step_to(3000)
    assert np.array_equal(rows(still)[:, :6], rows(spun)[:, :6])
    assert rows(still)[0, 5] == pytest.approx(0.21, rel=5e-3)
    assert np.array_equal(rows(spun)[0, 6:], (0.0, 0.0, 1e5))


def test_restart_inside_an_impact_of_spheres():
    """Between the first and the last touch, while the tangential spring is loaded and both spin."""

    def start():
        place = [(0.0, 0.0, 0.5), (1.6 * RADIUS, 1.1 * RADIUS, 0.5 + 0.44 * RADIUS)]
        return Engine(spheres(place, [(0.3, 0.1, 0.0), (-0.3, 0.0, 0.1)], [(30.0, -5.0, 9.0), (0.0, 8.0, 1.0)],
                              pair_contact=contact(0.7), dt=1e-6))  # fmt: skip

    through, before, after = start(), start(), start()
    before.step_to(300)
    saved = checkpoint(before)
    assert np.linalg.norm(np.diff(rows(before)[:, :3], axis=0)) < 2.0 * RADIUS
    assert np.abs(saved["pair_stored"]).max() > 0.0
    restore(after, saved)
    for engine in (through, after):
        engine.step_to(4000)
    assert np.linalg.norm(np.diff(rows(through)[:, :3], axis=0)) > 2.0 * RADIUS
    assert np.array_equal(rows(through), rows(after))


@pytest.mark.parametrize("turn", [0.0, 0.7, pi / 4.0, 2.2])
def test_an_impact_that_looks_alike_from_everywhere(turn):
    """Oblique, with spins, turned about the upright axis: the same to rounding."""

    def after(angle):
        c, s = cos(angle), sin(angle)
        about = np.array([(c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)])
        place = np.array([(0.0, 0.0, 0.5), (1.6 * RADIUS, 1.1 * RADIUS, 0.5 + 0.5 * RADIUS)]) @ about.T
        velocity = np.array([(0.3, 0.1, 0.0), (-0.3, 0.0, 0.1)]) @ about.T
        spin = np.array([(30.0, -5.0, 9.0), (0.0, 8.0, 1.0)]) @ about.T
        engine = Engine(spheres(place, velocity, spin, pair_contact=contact(0.7), dt=1e-6))
        engine.step_to(3000)
        return rows(engine).reshape(2, 3, 3) @ about

    assert after(turn) == pytest.approx(after(0.0), rel=1e-8, abs=1e-8)


@pytest.mark.parametrize("power", [-6, 6])
def test_spheres_of_another_scale(power):
    """Lengths and speeds 2^power times as large, density so that time stays: nothing has a size of its own."""
    k = 2.0**power
    place = np.array([(0.0, 0.0, 0.5), (1.6 * RADIUS, 1.1 * RADIUS, 0.5 + 0.5 * RADIUS)])
    velocity = np.array([(0.25, 0.125, 0.0), (-0.25, 0.0, 0.125)])
    small, large = (
        Engine(spheres(place * f, velocity * f, (3.0, 1.0, 2.0), radius=np.full(2, RADIUS * f), density=2500.0 / f**2,
                       pair_contact=contact(0.7), dt=2.0**-20))
        for f in (1.0, k)
    )  # fmt: skip
    for engine in (small, large):
        engine.step_to(3000)
    assert np.abs(rows(small)[:, 3:6] - velocity).max() > 0.05
    assert rows(large)[:, :6] == pytest.approx(k * rows(small)[:, :6], rel=1e-9, abs=1e-12 * k)
    assert rows(large)[:, 6:] == pytest.approx(rows(small)[:, 6:], rel=1e-9)
