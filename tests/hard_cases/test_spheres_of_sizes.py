"""Hard cases of unequal, clinging and shaken spheres.  Three kernels: unequal ones, the same by velocity Verlet and shaken,
and that of every effect of a contact."""

from dataclasses import replace
from math import atan2, cos, pi, radians, sin, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from silostudy.contact import elastic
from silostudy.dem.engine import Engine
from silostudy.dem.integrate import PLAIN, VERLET
from tests.hard_cases.test_spheres_at_walls import WEIGHT, K, sunk
from tests.hard_cases.test_spheres_impacts import of_an_impact
from tests.test_spheres.scenes import DENSITY, GRAVITY, MASS, RADIUS, bin_walls, contact, floor, rows, spheres
from tests.test_spheres.test_clinging import ADHESION, ceiling, clinging, sticky

pytestmark = pytest.mark.long
DOWN = (0.0, 0.0, -GRAVITY)


def masses(radii):
    return DENSITY * 4.0 / 3.0 * pi * np.asarray(radii) ** 3


def test_spheres_of_a_mass_ratio_of_a_million():
    radii = RADIUS * np.array([1.0, 0.01])
    heavy, light = masses(radii)
    total, speed = heavy + light, 1e-2
    deepest, time = of_an_impact(K, 2.0 * speed, heavy * light / total, radii.prod() / radii.sum())
    place = [(0.0, 0.0, 0.5), (radii.sum() + 0.01 * deepest, 0.0, 0.5)]
    engine = Engine(spheres(place, [(speed, 0.0, 0.0), (-speed, 0.0, 0.0)], radius=radii, pair_contact=contact(None, 0.0),
                            dt=time / 2000.0))  # fmt: skip
    engine.step_to(4000)
    left, right = rows(engine)[:, 3]
    assert left == pytest.approx((heavy - 3.0 * light) * speed / total, rel=1e-9)
    assert right == pytest.approx((3.0 * heavy - light) * speed / total, rel=1e-4)
    assert heavy * left + light * right == pytest.approx((heavy - light) * speed, rel=1e-13)


def test_sphere_on_one_of_a_thousand_times_its_radius():
    """The small one's weight and both weights, a ratio of a thousand million, in two overlaps."""
    radii = RADIUS * np.array([1.0, 1e-3])
    weights = masses(radii) * GRAVITY
    low, between = sunk(weights.sum()), sunk(weights[1], radii.prod() / radii.sum())
    place = [(0.0, 0.0, radii[0] - low), (0.0, 0.0, radii[0] - low + radii.sum() - 0.95 * between)]
    touch, dt = contact(0.2, 0.5), 0.05 * sqrt(between / GRAVITY)
    engine = Engine(spheres(place, radius=radii, gravity=DOWN, pair_contact=touch, wall_contact=touch, dt=dt))
    engine.step_to(30_000)
    z = rows(engine)[:, 2]
    assert radii[0] - z[0] == pytest.approx(low, rel=1e-6)
    assert radii.sum() - (z[1] - z[0]) == pytest.approx(between, rel=1e-4)


def test_several_sizes_at_once():
    """Spheres of four sizes up to a ratio of 10 come to rest in a bin: floor and wall carry all, for any list the same."""
    random, pitch = np.random.default_rng(5), 2.1 * RADIUS
    place = np.array([(x, y, z) for z in range(3) for x in (-1, 0, 1) for y in (-1, 0, 1)], float) * pitch
    place[:, 2] += 1.05 * RADIUS
    radii = RADIUS * np.tile([1.0, 0.5, 0.25, 0.1], 7)[: len(place)]
    place += random.uniform(-0.02, 0.02, place.shape) * RADIUS
    touch = contact(0.3, 0.4)
    model = spheres(place, radius=radii, walls=bin_walls(6.4 * RADIUS, 0.03), gravity=DOWN, pair_contact=touch,
                    wall_contact=touch, dt=2e-6)  # fmt: skip
    engine, other = Engine(model), Engine(model, skin=0.19 * RADIUS)
    for one in (engine, other):
        one.step_to(2000)
    assert np.array_equal(rows(engine), rows(other))
    engine.step_to(150_000)
    engine.clear_window()
    engine.step_to(200_000)
    floor_cells = engine.record.window[:8, :, 0].sum(axis=0)[0]
    upright = engine.record.window[8:, :, 0].sum(axis=0)[1]
    assert (floor_cells + upright) / 50_000 == pytest.approx(GRAVITY * masses(radii).sum(), rel=5e-3)


@pytest.mark.parametrize("integrator", [PLAIN.key, VERLET.key])
def test_sphere_rolls_off_one_of_ten_times_its_radius(integrator):
    """Without slip it leaves where the cosine from the top is 10/17 of that at the start: friction of unlike sizes by both."""
    radii, start = RADIUS * np.array([10.0, 1.0]), radians(20.0)
    density = np.array([1e9, DENSITY])
    stiff = contact(0.5, 0.5, 1e16)
    heavy = 1e9 * 4.0 / 3.0 * pi * radii[0] ** 3 * GRAVITY
    low = radii[0] - (heavy / (1e16 / 1e7 * K * sqrt(radii[0]))) ** (2.0 / 3.0)
    apart = radii.sum() - sunk(WEIGHT * cos(start), radii.prod() / radii.sum(), 100.0 * K)
    place = [(0.0, 0.0, low), (apart * sin(start), 0.0, low + apart * cos(start))]
    changes = {"quake": np.zeros((400_001, 3))} if integrator == VERLET.key else {}
    model = spheres(place, radius=radii, density=density, gravity=DOWN, pair_contact=contact(0.5, 1e3, 1e9),
                    wall_contact=stiff, dt=1e-6, integrator=integrator, **changes)  # fmt: skip
    engine = Engine(model)
    away = np.diff(rows(engine)[:, :3], axis=0)[0]
    while np.linalg.norm(away) < radii.sum():
        engine.step_to(engine.step + 50)
        away = np.diff(rows(engine)[:, :3], axis=0)[0]
        assert engine.step < 390_000
    assert cos(atan2(away[0], away[2])) == pytest.approx(10.0 / 17.0 * cos(start), rel=5e-3)
    moving = rows(engine)[1]
    fallen = radii.sum() * cos(start) - away[2]
    assert (moving[3:6] ** 2).sum() == pytest.approx(10.0 / 7.0 * GRAVITY * fallen, rel=1e-2)


def test_earthquake_at_resonance():
    """A sphere on a floor shaken at its own frequency until it lifts off: against an integration of its own to 1e-10."""
    restitution, strongest = 0.9, 0.08 * GRAVITY
    depth = sunk(WEIGHT)
    frequency = sqrt(1.5 * GRAVITY / depth)
    dt, steps = 2.0 * pi / frequency / 400.0, 8000
    number = elastic.damping_where_cut(restitution)

    def rates(t, state):
        deep, v = max(state[0], 0.0), state[1]  # overlap and speed downward
        push = K * sqrt(RADIUS) * deep**1.5 + number * sqrt(K * MASS * sqrt(RADIUS * deep)) * v
        return v, GRAVITY + strongest * sin(frequency * t) - max(push, 0.0) / MASS

    found = solve_ivp(rates, (0.0, dt * steps), (depth, 0.0), rtol=1e-10, atol=1e-18, max_step=20.0 * dt, dense_output=True)
    quake = np.zeros((steps + 1, 3))
    quake[:, 2] = strongest * np.sin(frequency * dt * np.arange(steps + 1))
    # two unlike spheres far from each other, so that the kernel is that of unlike spheres
    place, radii = [(0.0, 0.0, RADIUS - depth), (0.5, 0.0, 0.5)], RADIUS * np.array([1.0, 10.0])
    engine = Engine(spheres(place, radius=radii, gravity=DOWN, wall_contact=contact(restitution, 0.0), dt=dt, quake=quake,
                            integrator=VERLET.key, walls=(floor(0.1),)))  # fmt: skip
    sinking = []
    for step in range(20, steps + 1, 20):
        engine.step_to(step)
        sinking.append(RADIUS - rows(engine)[0, 2])
    times = dt * np.arange(20, steps + 1, 20)
    expected = found.sol(times)[0]
    swing = np.ptp(expected)
    assert swing > 0.8 * depth  # far from a small motion
    assert np.abs(sinking - expected).max() < 0.02 * swing


@pytest.mark.parametrize("modulus", [1e6, 1e7, 1e9])
@pytest.mark.parametrize(("share", "holds"), [(0.995, True), (1.005, False)])
def test_jkr_pull_off(modulus, share, holds):
    """3/2 pi w R, whatever the modulus: half a per cent less is held, as deep as the law says; half more tears off."""
    largest = 1.5 * pi * ADHESION * RADIUS
    touch = clinging(0.3)
    factor = modulus / 1e7
    stiff = touch.changed({name: touch.coefficients[name] * factor for name in ("hertz_stiffness", "mindlin_stiffness")})
    stiff = stiff.changed({"hertz_damping": touch.coefficients["hertz_damping"] * sqrt(factor)})
    c = stiff.coefficients["hertz_stiffness"]
    root = RADIUS / 2.0 * sqrt(6.0 * pi * ADHESION) * (1.0 + sqrt(max(1.0 - share, 0.0)))  # of c a^3
    a = (root**2 / c) ** (1.0 / 3.0)
    overlap = a**2 / RADIUS - sqrt(2.0 * pi * ADHESION * a / (0.75 * c))
    model = sticky([(0.0, 0.0, 0.5 - RADIUS + 1e-9)], walls=(ceiling(),), gravity=(0.0, 0.0, -share * largest / MASS),
                   dt=1e-6 / sqrt(factor))  # fmt: skip
    engine = Engine(replace(model, wall_contact=stiff))
    engine.step_to(1)  # it has touched
    engine.bodies.rows[0, 2:6] = (0.5 - RADIUS + overlap, 0.0, 0.0, 0.0)
    engine.step_to(100_000)
    z = rows(engine)[0, 2]
    if holds:
        assert z - (0.5 - RADIUS) == pytest.approx(overlap, rel=2e-3)
    else:
        assert 0.5 - RADIUS - z > 2.0 * stiff.gap(RADIUS)
