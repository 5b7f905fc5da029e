"""Spheres at rest and at edges: forces that statics give."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from silostudy.contact import elastic
from silostudy.dem.engine import Engine
from silostudy.dem.space.walls import TurnedLine
from tests.test_spheres.scenes import DENSITY, GRAVITY, MASS, MODULUS, POISSON, RADIUS, contact, rows, spheres

pytestmark = pytest.mark.long  # the kernel of Hertz and Mindlin, as of the other exact tests
STIFFNESS = 4.0 / 3.0 * elastic.contact_modulus(MODULUS, POISSON, MODULUS, POISSON)


def cone(half_angle, high):
    return TurnedLine(name="cone", start=(0.0, 0.0), end=(high * np.tan(half_angle), high), joined=(True, False))


@pytest.mark.parametrize("degrees", [30.0, 50.0])
def test_a_stack_in_a_cone(degrees):
    """Three spheres in a smooth cone and one on them: walls carry the weight, and whatever pushes the three apart."""
    half = radians(degrees)
    off = 2.0 * RADIUS / sqrt(3.0)
    turns = np.arange(3) * 2.0 * pi / 3.0 + 0.3
    height = (RADIUS + off * cos(half)) / sin(half)  # a centre at this height and so far off is a radius away from the cone
    low = np.c_[off * np.cos(turns), off * np.sin(turns), np.full(3, height)]
    place = np.vstack([low, (0.0, 0.0, height + 2.0 * RADIUS * sqrt(2.0 / 3.0))])
    touch = contact(0.1, 0.0, MODULUS * 10.0)
    model = spheres(place, walls=(cone(half, 10.0 * RADIUS),), gravity=(0.0, 0.0, -GRAVITY), pair_contact=touch,
                    wall_contact=touch, dt=2e-6)  # fmt: skip
    engine = Engine(model)
    engine.step_to(150000)
    engine.clear_window()
    engine.step_to(151000)
    found = rows(engine)
    assert np.abs(found[:, 3:6]).max() < 1e-5
    weight = MASS * GRAVITY
    pressed = engine.record.window[0, 0, 0] / 1000
    assert pressed == pytest.approx(4.0 * weight / sin(half), rel=1e-4)  # all three walls' forces, each along its normal

    def force(i, j):
        overlap = 2.0 * RADIUS - np.linalg.norm(found[i, :3] - found[j, :3])
        return 10.0 * STIFFNESS * sqrt(0.5 * RADIUS) * max(overlap, 0.0) ** 1.5

    down = [force(3, k) for k in range(3)]
    assert down == pytest.approx([weight / (3.0 * sqrt(2.0 / 3.0))] * 3, rel=5e-3)
    outward = 4.0 * weight / (3.0 * sin(half)) * cos(half) - weight / 3.0 * sqrt(0.5)
    between = [force(i, j) for i, j in ((0, 1), (1, 2), (2, 0))]
    assert between == pytest.approx([outward / sqrt(3.0)] * 3, rel=5e-3)


@pytest.mark.parametrize("turn", [0.0, 2.0])
@pytest.mark.parametrize("slant", [20.0, 70.0])
def test_a_sphere_on_the_edge_of_an_outlet(turn, slant):
    """It is pushed from the nearest point of the edge's circle, and goes back as it came."""
    outlet = 3.0 * RADIUS
    edge = TurnedLine(name="floor", start=(outlet, 0.1), end=(10.0 * RADIUS, 0.1))
    away = np.array([-sin(radians(slant)) * cos(turn), -sin(radians(slant)) * sin(turn), cos(radians(slant))])
    corner = np.array([outlet * cos(turn), outlet * sin(turn), 0.1])
    touch, speed = contact(None, 0.0), 0.3
    model = spheres([corner + 1.0001 * RADIUS * away], [-speed * away], walls=(edge,), wall_contact=touch, dt=2e-7)
    engine = Engine(model)
    engine.step_to(3000)
    assert np.linalg.norm(rows(engine)[0, :3] - corner) < RADIUS  # pressed on the edge
    engine.step_to(20000)
    (row,) = rows(engine)
    assert row[3:6] == pytest.approx(speed * away, abs=2e-3 * speed)
    assert row[6:9] == pytest.approx(0.0, abs=1e-9)


def test_two_spheres_of_unequal_sizes_and_materials():
    """Largest overlap, contact time and peak force of Hertz by the reduced mass, radius and modulus of both."""
    radii, speed = np.array([RADIUS, 1.6 * RADIUS]), 0.4
    both = (MODULUS, 0.25), (3.0 * MODULUS, 0.4)
    masses = DENSITY * 4.0 / 3.0 * pi * radii**3
    mass, radius = masses.prod() / masses.sum(), radii.prod() / radii.sum()
    modulus = 1.0 / sum((1.0 - nu**2) / e for e, nu in both)
    time = 2.868 * (mass**2 / (radius * modulus**2 * speed)) ** 0.2
    touch = contact(None, 0.0, materials=both)
    place = [(0.0, 0.0, 0.5), (0.0, radii.sum() + 0.01 * speed * time, 0.5)]
    engine = Engine(spheres(place, [(0.0, speed, 0.0), (0.0, 0.0, 0.0)], radius=radii, pair_contact=touch, dt=time / 2000.0))
    overlaps, speeds = [], []
    for step in range(3000):
        engine.step_to(step + 1)
        one, other = rows(engine)
        overlaps.append(radii.sum() - (other[1] - one[1]))
        speeds.append(one[4])
    deepest = (15.0 * mass * speed**2 / (16.0 * modulus * sqrt(radius))) ** 0.4
    assert max(overlaps) == pytest.approx(deepest, rel=1e-3)
    assert (np.array(overlaps) > 0.0).sum() * engine.model.dt == pytest.approx(time, rel=3e-3)
    peak = -np.diff(speeds).min() * masses[0] / engine.model.dt
    assert peak == pytest.approx(4.0 / 3.0 * modulus * sqrt(radius) * deepest**1.5, rel=2e-3)
    assert other[4] == pytest.approx(2.0 * masses[0] / masses.sum() * speed, rel=1e-3)
