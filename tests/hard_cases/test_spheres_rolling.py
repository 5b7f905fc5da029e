"""Spheres that roll and spin, against the mechanics of rigid spheres; the last stands on a wall that turns."""

from math import cos, pi, radians, sin, sqrt

import mpmath
import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.moves import turn_walls
from silostudy.dem.space.walls import TurnedLine
from tests.hard_cases.test_spheres_at_walls import WEIGHT, bent, sunk
from tests.test_spheres.scenes import GRAVITY, MASS, RADIUS, contact, floor, rows, spheres

pytestmark = pytest.mark.long
GRIP = contact(0.3, 1e3)  # next to no slip
DOWN = (0.0, 0.0, -GRAVITY)


def on_the_floor(velocity, spin, touch, **changes):
    place = [(0.0, 0.0, RADIUS - sunk(WEIGHT))]
    return Engine(spheres(place, [velocity], spin, wall_contact=touch, gravity=DOWN, dt=2e-6, **changes))


def test_spin_of_1e5_on_a_floor():
    """It slides at mu g, whatever its spin: its surface goes at 200 m/s."""
    friction = 0.3
    engine = on_the_floor((0.0, 0.0, 0.0), (0.0, 1e5, 0.0), contact(0.5, friction))
    engine.step_to(50_000)
    row = rows(engine)[0]
    assert row[3] == pytest.approx(friction * GRAVITY * engine.time, rel=1e-3)
    assert row[7] == pytest.approx(1e5 - 2.5 * friction * GRAVITY / RADIUS * engine.time, rel=1e-6)
    assert row[[1, 4, 6, 8]] == pytest.approx(0.0, abs=1e-9)


def test_a_million_steps_of_a_sphere_at_rest():
    """No creep, no drift, no gain."""
    engine = on_the_floor((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), contact(0.5, 0.5))
    engine.step_to(20_000)
    before = rows(engine)
    engine.step_to(1_020_000)
    assert np.abs(rows(engine) - before)[:, :3].max() < 1e-15
    assert np.abs(rows(engine)[:, 3:6]).max() < 1e-9
    assert RADIUS - rows(engine)[0, 2] == pytest.approx(sunk(WEIGHT), rel=1e-8)


def test_billiard_ball_with_side_spin():
    """On a parabola while it slides; then straight at (5 v + 2 r spin x up)/7, the spin about the upright axis untouched."""
    friction, velocity, spin = 0.3, np.array([0.2, 0.0, 0.0]), np.array([-90.0, -60.0, 40.0])
    engine = on_the_floor(velocity, spin, contact(0.5, friction))
    rolling = (5.0 * velocity + 2.0 * RADIUS * np.cross(spin, (0.0, 0.0, 1.0))) / 7.0
    slip = velocity - RADIUS * np.cross(spin, (0.0, 0.0, 1.0))
    until = 2.0 * np.linalg.norm(slip) / (7.0 * friction * GRAVITY)
    engine.step_to(round(0.5 * until / 2e-6))
    pull = -friction * GRAVITY * slip / np.linalg.norm(slip)
    assert rows(engine)[0, 3:5] == pytest.approx((velocity + pull * engine.time)[:2], abs=2e-3 * 0.2)
    way = (velocity * engine.time + 0.5 * pull * engine.time**2)[:2]
    assert rows(engine)[0, :2] == pytest.approx(way, abs=2e-3 * np.linalg.norm(way))
    engine.step_to(round(2.0 * until / 2e-6))
    assert rows(engine)[0, 3:5] == pytest.approx(rolling[:2], abs=3e-3 * 0.2)
    assert rows(engine)[0, 8] == pytest.approx(40.0, rel=1e-12)


@pytest.mark.parametrize("degrees", [1.0, 60.0, 85.0])
def test_rolling_pendulum(degrees):
    """In a cylinder that lies: a quarter of the period by the elliptic integral in 30 digits."""
    wide, angle = 0.03, radians(degrees)
    reach = wide - RADIUS + sunk(WEIGHT * cos(angle), bent(wide))
    place = (-reach * cos(angle), -reach * sin(angle), 0.0)
    cylinder = TurnedLine(name="cylinder", start=(wide, -0.1), end=(wide, 0.1))
    engine = Engine(spheres([place], walls=(cylinder,), gravity=(-GRAVITY, 0.0, 0.0), wall_contact=GRIP, dt=2e-6))
    with mpmath.workdps(30):
        quarter = float(mpmath.sqrt(mpmath.mpf(7) / 5 * (wide - RADIUS) / GRAVITY) * mpmath.ellipk(mpmath.sin(angle / 2) ** 2))
    engine.step_to(round(0.9 * quarter / 2e-6))
    while rows(engine)[0, 1] < 0.0:
        engine.step_to(engine.step + 20)
    assert engine.time == pytest.approx(quarter, rel=2e-3)
    speed = sqrt(10.0 / 7.0 * GRAVITY * (wide - RADIUS) * (1.0 - cos(angle)))
    assert rows(engine)[0, 4] == pytest.approx(speed, rel=2e-3)


def test_a_ball_that_runs_round_a_hole_comes_up_again():
    """In an upright cylinder, without slip: it sinks by 5 g/W^2 and is up again after sqrt(7/2) turns."""
    wide, speed = 0.02, 1.0
    off = wide - RADIUS
    turning = speed / off
    place = (off + sunk(MASS * speed * turning, bent(wide)), 0.0, 0.0)
    cylinder = TurnedLine(name="cylinder", start=(wide, -0.5), end=(wide, 0.5))
    engine = Engine(spheres([place], [(0.0, speed, 0.0)], (0.0, 0.0, -speed / RADIUS), walls=(cylinder,), gravity=DOWN,
                            wall_contact=contact(0.3, 1e3), dt=1e-6))  # fmt: skip
    period = 2.0 * pi / turning * sqrt(3.5)
    engine.step_to(round(0.5 * period / 1e-6))
    assert rows(engine)[0, 2] == pytest.approx(-5.0 * GRAVITY / turning**2, rel=2e-2)
    assert abs(rows(engine)[0, 5]) < 0.02 * speed
    engine.step_to(round(period / 1e-6))
    assert abs(rows(engine)[0, 2]) < 0.02 * 5.0 * GRAVITY / turning**2
    assert np.hypot(*rows(engine)[0, 3:5]) == pytest.approx(speed, rel=5e-3)


def test_rolling_on_a_turntable():
    """A circle whose angular speed is two sevenths of the table's, wherever the table's middle is."""
    table, velocity, place = 50.0, np.array([0.1, 0.0, 0.0]), np.array([0.01, 0.02, RADIUS - sunk(WEIGHT)])
    against = table * np.array([-place[1], place[0], 0.0]) - velocity
    spin = (against[1] / RADIUS, -against[0] / RADIUS, 0.0)
    model = spheres([place], [velocity], spin, walls=(floor(),), gravity=DOWN, wall_contact=GRIP, dt=2e-6, moving=True)
    engine = Engine(model)
    turn_walls(engine, table, "floor")
    period, radius = 3.5 * 2.0 * pi / table, 0.1 / (2.0 / 7.0 * table)
    far = []
    for share in (0.25, 0.5, 0.75, 1.0):
        engine.step_to(round(share * period / 2e-6))
        turn = 2.0 * pi * share
        expected = place[:2] + radius * np.array([sin(turn), 1.0 - cos(turn)])
        far.append(np.linalg.norm(rows(engine)[0, :2] - expected))
    assert max(far) < 0.01 * radius
