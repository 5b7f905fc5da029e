"""Motions whose answers are known exactly."""

from math import atan2, cos, exp, pi, sin, sqrt

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.lanes import TORQUE, U, V, W, X, Y
from silostudy.dem.model import Wall
from silostudy.dem.pieces import Laws
from silostudy.dem.walls import sums_by_wall
from silostudy.scene.plane_silo import FLOOR, SIDES

from .scenes import DENSITY, RADIUS, SLIDING, STIFFNESS, contact, free, rows, silo

MASS = DENSITY * pi * RADIUS**2
INERTIA = 0.5 * MASS * RADIUS**2
SPEED = 0.1


def restitution(zeta):
    """Of a spring and dashpot that never pulls: the force ends where spring and dashpot cancel (Schwager & Poeschel 2007)."""
    if zeta == 0.0:
        return 1.0
    if zeta < 1.0:
        root = sqrt(1.0 - zeta**2)
        return exp(-zeta / root * atan2(2.0 * zeta * root, 2.0 * zeta**2 - 1.0))
    if zeta == 1.0:
        return exp(-2.0)
    root = sqrt(zeta**2 - 1.0)
    return exp(-zeta / root * np.log((zeta + root) / (zeta - root)))


def head_on(zeta, laws, **changes):
    """Two equal discs meet at 2 SPEED; the share of it with which they part."""
    reduced = MASS / 2.0
    damping = 2.0 * zeta * sqrt(reduced * STIFFNESS)
    model = free(
        [0.0, 2.02 * RADIUS],
        [0.0, 0.0],
        u=[SPEED, -SPEED],
        pair_contact=contact(damping=damping, laws=laws),
        dt=2e-7,
        **changes,
    )
    engine = Engine(model)
    engine.step_to(30000)
    left, right = rows(engine)
    assert left[U] + right[U] == 0.0  # momentum
    return (right[U] - left[U]) / (2.0 * SPEED)


@pytest.mark.parametrize("zeta", [0.0, 0.05, 0.2, 0.5, 0.7, 0.71, 0.9, 1.0, 1.5, 3.0])
def test_restitution_without_pull(zeta):
    assert head_on(zeta, SLIDING) == pytest.approx(restitution(zeta), rel=2e-3)


@pytest.mark.parametrize("zeta", [0.05, 0.2, 0.5, 0.7, 0.9])
def test_restitution_with_pull_ends_at_zero_overlap(zeta):
    laws = Laws.of(normal="spring-dashpot-tension", tangential="spring-slider")
    assert head_on(zeta, laws) == pytest.approx(exp(-pi * zeta / sqrt(1.0 - zeta**2)), rel=2e-2)


@pytest.mark.parametrize("angle", np.deg2rad([75.0, 80.0, 85.0, 89.0]))
def test_gross_slip_of_an_oblique_impact(angle):
    """Speed lost along the wall mu (1 + e) v_n, spin won 2 mu (1 + e) v_n / r, while the contact slips throughout."""
    mu, zeta = 0.1, 0.2
    normal, along = cos(angle), sin(angle)
    damping = 2.0 * zeta * sqrt(MASS * STIFFNESS)
    model = free(
        [0.0], [1.001 * RADIUS], u=[along], v=[-normal], dt=2e-7, walls=(Wall("floor", (-1.0, 0.0), (1.0, 0.0)),),
        wall_contact=contact(1.0, mu, damping=damping, laws=Laws.of(normal="spring-dashpot", tangential="spring-slider-total")),
    )  # fmt: skip
    engine = Engine(model)
    engine.step_to(40000)
    ((_, _, u, v, w),) = rows(engine)
    e = restitution(zeta)
    assert along > 3.0 * mu * (1.0 + e) * normal
    assert v / normal == pytest.approx(e, rel=2e-3)
    assert along - u == pytest.approx(mu * (1.0 + e) * normal, rel=2e-3)
    assert abs(w) == pytest.approx(2.0 * mu * (1.0 + e) * normal / RADIUS, rel=2e-3)


@pytest.mark.parametrize("angle", np.deg2rad([0.0, 5.0, 15.0, 30.0, 45.0, 60.0, 70.0]))
def test_an_oblique_impact_keeps_the_angular_momentum_about_its_contact(angle):
    """Over the whole range of angles, sticking or slipping: m u r + I w about the floor does not change."""
    model = free(
        [0.0], [1.001 * RADIUS], u=[sin(angle)], v=[-cos(angle)], dt=2e-7,
        walls=(Wall("floor", (-1.0, 0.0), (1.0, 0.0)),),
        wall_contact=contact(1.0, 0.3, laws=Laws.of(tangential="spring-slider-total")),
    )  # fmt: skip
    engine = Engine(model)
    engine.step_to(40000)
    ((_, _, u, v, w),) = rows(engine)
    assert v > 0.0
    assert MASS * RADIUS * (u - sin(angle)) == pytest.approx(INERTIA * w, rel=1e-9, abs=1e-15)
    assert abs(u - sin(angle)) <= 0.3 * (v + cos(angle)) * (1.0 + 1e-6)  # friction stays in its cone


def rolling_disc(mu, tilt=0.0, u=0.0):
    overlap = MASS * 9.81 * cos(tilt) / (2.0 * STIFFNESS)
    gravity = (9.81 * sin(tilt), -9.81 * cos(tilt))
    return Engine(
        free([0.0], [RADIUS - overlap], u=[u], gravity=gravity, dt=1e-5, walls=(Wall("floor", (-9.0, 0.0), (9.0, 0.0)),),
             wall_contact=contact(2.0, mu))
    )  # fmt: skip


def test_slip_turns_into_rolling_at_two_thirds_of_the_speed():
    mu, u = 0.2, 1.0
    engine = rolling_disc(mu, u=u)
    end = u / (3.0 * mu * 9.81)
    engine.step_to(round(0.98 * end / 1e-5))
    ((_, _, before, _, spin),) = rows(engine)
    assert before == pytest.approx(u - mu * 9.81 * engine.time, rel=1e-3)
    assert before + spin * RADIUS > 1e-3  # still slips
    engine.step_to(round(1.5 * end / 1e-5))
    ((_, _, after, _, spin),) = rows(engine)
    assert after == pytest.approx(2.0 * u / 3.0, rel=2e-3)
    assert -spin * RADIUS == pytest.approx(after, rel=2e-3)


@pytest.mark.parametrize(("tilt", "mu"), [(0.2, 0.577), (0.5, 0.577), (1.0, 0.6), (0.5, 0.1), (1.0, 0.2)])
def test_incline(tilt, mu):
    """Rolling at 2/3 g sin while tan(tilt) <= 3 mu, else sliding at g (sin - mu cos)."""
    engine = rolling_disc(mu, tilt)
    engine.step_to(20000)
    ((_, _, u, _, _),) = rows(engine)
    rolls = np.tan(tilt) <= 3.0 * mu
    expected = 2.0 / 3.0 * 9.81 * sin(tilt) if rolls else 9.81 * (sin(tilt) - mu * cos(tilt))
    assert u / engine.time == pytest.approx(expected, rel=5e-3)


def test_a_column_at_rest():
    """Each contact carries what lies above it, and the overlaps follow from the stiffness."""
    n = 6
    y = RADIUS * (1.0 + 2.0 * np.arange(n))
    engine = Engine(free(np.zeros(n), y, gravity=(0.0, -9.81), dt=2.5e-5, walls=(Wall("floor", (-1.0, 0.0), (1.0, 0.0)),)))
    engine.step_to(60000)
    above = MASS * 9.81 * np.arange(n, 0, -1)
    overlap = above / (STIFFNESS * np.r_[2.0, np.ones(n - 1)])
    expected = RADIUS - overlap[0] + np.r_[0.0, np.cumsum(2.0 * RADIUS - overlap[1:])]
    np.testing.assert_allclose(rows(engine)[:, Y], expected, rtol=1e-12)


def test_momentum_and_angular_momentum_of_a_cloud():
    random = np.random.default_rng(3)
    x, y = (4.0 * RADIUS * np.mgrid[:5, :5].reshape(2, -1)) * 0.5 + random.uniform(-1e-4, 1e-4, (2, 25))
    u, v = random.uniform(-0.5, 0.5, (2, 25))
    engine = Engine(free(x, y, u=u, v=v, dt=1e-5))

    def sums():
        r = rows(engine)
        turn = MASS * (r[:, X] * r[:, V] - r[:, Y] * r[:, U]) + INERTIA * r[:, W]
        return np.array([MASS * r[:, U].sum(), MASS * r[:, V].sum(), turn.sum()])

    before = sums()
    engine.step_to(3000)
    turnover = MASS * np.hypot(u, v).sum()
    after = sums()
    assert np.abs(after - before)[:2].max() < 1e-13 * turnover
    assert abs(after - before)[2] < 1e-3 * turnover * RADIUS  # arms are radii, the overlap's share is left
    assert not np.array_equal(rows(engine)[:, W], np.zeros(25))


def test_floor_force_and_wall_shear_carry_the_weight():
    model = silo()
    engine = Engine(model)
    engine.step_to(80000)
    engine.clear_window()
    engine.step_to(80100)
    mean = engine.record.window[:, :, 0] / 100
    walls = sums_by_wall(model, mean)
    floor, sides = walls[FLOOR][0], sum(walls[name][1] for name in SIDES)
    assert floor + sides == pytest.approx(model.mass.sum() * 9.81, rel=1e-6)
    assert sum(walls[name][0] for name in SIDES) > 0.0
    assert np.abs(engine.bodies.rows[: engine.n, TORQUE]).max() == 0.0
