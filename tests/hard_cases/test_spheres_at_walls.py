"""Hard cases of spheres at rest between walls, in cones, on edges and under loads: forces that statics give; one kernel."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.space.cones import EccentricCone
from silostudy.dem.space.level import Hole, LevelPiece, Outline
from silostudy.dem.space.walls import FlatPiece, TurnedLine
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import FLOOR, SpaceSilo
from tests.hard_cases.test_spheres_impacts import hertz_stiffness
from tests.test_spheres.scenes import GRAVITY, INERTIA, MASS, MODULUS, POISSON, RADIUS, bin_walls, contact, floor, rows, spheres

pytestmark = pytest.mark.long
WEIGHT = MASS * GRAVITY
SMOOTH = contact(0.2, 0.0)
K = hertz_stiffness(MODULUS)


def sunk(force, radius=RADIUS, stiffness=K) -> float:
    """Overlap (m) of Hertz's contact under a force (N)."""
    return (force / (stiffness * sqrt(radius))) ** (2.0 / 3.0)


def bent(wide) -> float:
    """Reduced radius (m) of a sphere inside a cylinder, of the mean curvature of that."""
    return RADIUS / (1.0 - RADIUS / (2.0 * wide))


def slope(name, half_angle, turn) -> FlatPiece:
    """A plane from the origin upward, that leans outward in the direction of an angle about the axis (rad)."""
    out, up, along = np.array([cos(turn), sin(turn), 0.0]), np.array([0.0, 0.0, 1.0]), np.array([-sin(turn), cos(turn), 0.0])
    rise = 9.0 * (sin(half_angle) * out + cos(half_angle) * up)
    foot = -1e-3 * rise
    corners = (foot - 9.0 * along, foot + 9.0 * along, rise + 9.0 * along, rise - 9.0 * along)
    return FlatPiece(name=name, corners=tuple(tuple(map(float, corner)) for corner in corners))


def settle(place, walls, gravity, steps, dt=2e-6, touch=SMOOTH, **changes):
    """The engine after so many steps from a place."""
    engine = Engine(spheres(place, walls=walls, gravity=gravity, wall_contact=touch, dt=dt, **changes))
    engine.step_to(steps)
    return engine


@pytest.mark.parametrize("half_angle", [1.0, 10.0, 45.0, 80.0, 89.0])
def test_sphere_wedged_between_two_planes(half_angle):
    """Each presses with m g/(2 sin)."""
    theta = radians(half_angle)
    push = WEIGHT / (2.0 * sin(theta))
    height = (RADIUS - sunk(push)) / sin(theta)
    walls = slope("right", theta, 0.0), slope("left", theta, pi)
    engine = settle([(0.0, 0.0, height * (1.0 + 1e-8))], walls, (0.0, 0.0, -GRAVITY), 100_000)
    (x, y, z, *moving) = rows(engine)[0]
    assert RADIUS - z * sin(theta) == pytest.approx(sunk(push), rel=1e-5)
    assert np.abs([x, y]).max() < 1e-12 * RADIUS
    assert np.abs(moving).max() < 1e-6


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_sphere_slides_down_an_eccentric_cone(side):
    """Without friction it goes by g sin along the line of the wall in the plane of symmetry, pressed by m g cos on the way."""
    low, top, aside, high = 0.02, 0.1, 0.05, 0.12
    cone = EccentricCone(name="hopper", start=(low, 0.0), end=(top, high), foot=(aside, 0.0), head=(0.0, 0.0))
    way = np.array([side * top - (aside + side * low), 0.0, high])
    along, inward = way / np.linalg.norm(way), np.array([-side * high, 0.0, abs(way[0])]) / np.linalg.norm(way)
    place = np.array([aside + side * low, 0.0, 0.0]) + 0.8 * way + (RADIUS - sunk(WEIGHT * inward[2])) * inward
    steps, dt = 40_000, 2e-6
    engine = settle([place], (cone,), (0.0, 0.0, -GRAVITY), steps)
    gone = rows(engine)[0, :3] - place
    assert gone @ along == pytest.approx(-0.5 * GRAVITY * along[2] * (steps * dt) ** 2, rel=1e-4)
    assert abs(gone @ inward) < 1e-3 * RADIUS
    assert abs(gone[1]) < 1e-12 * RADIUS


@pytest.mark.parametrize("half_angle", [5.0, 30.0, 60.0])
def test_sphere_in_the_apex_of_a_pyramid(half_angle):
    """Four faces press with m g/(4 sin) each."""
    silo = Silo(plan="square", diameter=0.04, wall_depth=0.02, hopper=Hopper(half_angle=radians(half_angle), outlet_width=0.0))
    theta = radians(half_angle)
    push = WEIGHT / (4.0 * sin(theta))
    height = (RADIUS - sunk(push)) / sin(theta)
    engine = settle([(0.0, 0.0, height + 1e-9)], SpaceSilo(silo=silo).walls(), (0.0, 0.0, -GRAVITY), 100_000)
    x, y, z = rows(engine)[0, :3]
    assert RADIUS - z * sin(theta) == pytest.approx(sunk(push), rel=1e-5)
    assert np.abs([x, y]).max() < 1e-12 * RADIUS


@pytest.mark.parametrize("half_angle", [1.0, 20.0, 60.0, 89.0])
def test_sphere_in_the_apex_of_a_cone(half_angle):
    """A cone pushes from its nearest point, from one side after the other: momentum balances, and it stays in the apex."""
    theta = radians(half_angle)
    cone = TurnedLine(name="cone", start=(0.0, 0.0), end=(0.5 * sin(theta), 0.5 * cos(theta)))
    height, dt = RADIUS / sin(theta), 2e-6
    engine = settle([(1e-6, 0.0, height)], (cone,), (0.0, 0.0, -GRAVITY), 50_000, dt)
    engine.clear_window()
    start, heights = rows(engine)[0, 5], []
    for step in range(50_000, 250_001, 1000):
        engine.step_to(step)
        heights.append(rows(engine)[0, 2])
    upward = engine.record.window[:, :, 0].sum() * dt * sin(theta)
    gained = MASS * (rows(engine)[0, 5] - start)
    assert upward == pytest.approx(WEIGHT * 200_000 * dt + gained, rel=1e-6)
    assert max(heights) < height + 0.01 * RADIUS
    assert min(heights) > height - 2.0 * RADIUS


@pytest.mark.parametrize("half_angle", [1.0, 89.0])
def test_sphere_slides_down_a_cone(half_angle):
    """Without friction g cos along the wall, from one degree off the upright to one degree off the level."""
    theta = radians(half_angle)
    along, normal = np.array([sin(theta), 0.0, cos(theta)]), np.array([-cos(theta), 0.0, sin(theta)])
    cone = TurnedLine(name="cone", start=(0.0, 0.0), end=tuple(9.0 * along[[0, 2]]))
    start = 5.0 * along + RADIUS * normal
    wide = 5.0 * sin(theta)
    radius = RADIUS / (1.0 - RADIUS * cos(theta) / (2.0 * wide))
    start -= sunk(WEIGHT * sin(theta), radius) * normal
    engine = settle([start], (cone,), (0.0, 0.0, -GRAVITY), 50_000)
    velocity = rows(engine)[0, 3:6]
    assert velocity @ along == pytest.approx(-GRAVITY * cos(theta) * engine.time, rel=1e-6)
    assert abs(velocity @ normal) < 1e-4 * abs(velocity @ along)
    assert rows(engine)[0, [1, 4, 6, 7, 8]] == pytest.approx(0.0, abs=1e-12)


def test_sphere_rolls_down_a_cone_of_89_degrees():
    """5/7 g sin of the slope, which is a degree."""
    theta = radians(89.0)
    along, normal = np.array([sin(theta), 0.0, cos(theta)]), np.array([-cos(theta), 0.0, sin(theta)])
    cone = TurnedLine(name="cone", start=(0.0, 0.0), end=tuple(9.0 * along[[0, 2]]))
    start = 5.0 * along + (RADIUS - sunk(WEIGHT * sin(theta))) * normal
    engine = settle([start], (cone,), (0.0, 0.0, -GRAVITY), 100_000, touch=contact(0.5, 0.3))
    assert rows(engine)[0, 3:6] @ along == pytest.approx(-5.0 / 7.0 * GRAVITY * cos(theta) * engine.time, rel=5e-3)


def test_sphere_exactly_on_the_edge_of_an_outlet():
    """Its centre above a ring's inner edge and above a hole's rim: the weight goes straight up, and it stays."""
    high = 0.1
    hole = Hole(name="outlet", outline=Outline(sides=0, half=(3.0 * RADIUS,) * 2))
    piece = LevelPiece(name="floor", height=high, outline=Outline(sides=0, half=(1.0, 1.0)), holes=(hole,))
    ring = TurnedLine(name="floor", start=(3.0 * RADIUS, high), end=(1.0, high))
    for wall in (ring, piece):
        engine = Engine(spheres([(3.0 * RADIUS, 0.0, high + RADIUS)], walls=(wall,), gravity=(0.0, 0.0, -GRAVITY),
                                wall_contact=contact(0.2, 0.5), dt=1e-6))  # fmt: skip
        if isinstance(wall, LevelPiece):
            engine.walls.shape[0, 22] = 1.0  # open
        engine.step_to(30_000)
        x, y, z = rows(engine)[0, :3]
        assert high + RADIUS - z == pytest.approx(sunk(WEIGHT), rel=1e-6)
        assert (x, y) == (3.0 * RADIUS, 0.0)


@pytest.mark.parametrize("load", [0.1, 1.0, 10.0, 100.0])
def test_jammed_dome_under_rising_load(load):
    """A keystone on three spheres that a cylinder holds: statics of the places as they are, at a load 1000 times as high."""
    off, turns = 1.5 * RADIUS, np.arange(3) * 2.0 * pi / 3.0 + 0.2
    lean = sqrt(4.0 * RADIUS**2 - off**2)
    low = np.c_[off * np.cos(turns), off * np.sin(turns), np.full(3, RADIUS)]
    wide = off + RADIUS
    engine = settle(np.vstack([low, (0.0, 0.0, RADIUS + lean)]), bin_walls(wide, 0.05), (0.0, 0.0, -load), 100_000,
                    pair_contact=contact(0.2, 0.0))  # fmt: skip
    place, weight = rows(engine)[:, :3], MASS * load
    across, up = np.hypot(*place[0, :2]), place[3, 2] - place[0, 2]
    thrust = weight / 3.0 * across / up
    down = sqrt(thrust**2 + (weight / 3.0) ** 2)
    assert 2.0 * RADIUS - np.hypot(across, up) == pytest.approx(sunk(down, RADIUS / 2.0), rel=1e-5)
    assert RADIUS - place[0, 2] == pytest.approx(sunk(weight * 4.0 / 3.0), rel=1e-5)
    assert across + RADIUS - wide == pytest.approx(sunk(thrust, bent(wide)), rel=1e-5)
    assert np.abs(rows(engine)[:, 3:6]).max() < 1e-8


def test_stack_of_two_hundred_spheres_on_one():
    """Started where each contact carries what lies above it: nothing moves, and the lowest carries all."""
    n = 201
    above = WEIGHT * np.arange(n, 0, -1)
    low = sunk(above[0], stiffness=100.0 * K)
    between = sunk(above[1:], RADIUS / 2.0, 100.0 * K)
    z = RADIUS - low + np.r_[0.0, np.cumsum(2.0 * RADIUS - between)]
    hard = contact(0.5, 0.5, 100.0 * MODULUS)
    engine = settle(np.c_[np.zeros((n, 2)), z], (floor(),), (0.0, 0.0, -GRAVITY), 20_000, 1e-6, hard, pair_contact=hard)
    found = rows(engine)
    assert (RADIUS - found[0, 2]) / low == pytest.approx(1.0, rel=1e-8)
    assert np.abs(found[:, 2] - z).max() < 1e-10 * RADIUS
    assert np.all(found[:, [0, 1, 3, 4, 6, 7, 8]] == 0.0)


def test_tilted_gravity_in_the_corner_of_a_box():
    """Three walls at once: each carries its own component of the weight."""
    silo = Silo(plan="square", diameter=0.04, wall_depth=0.05)
    pull = (3.0, -5.0, -8.0)
    engine = settle([(0.02 - RADIUS, RADIUS - 0.02, RADIUS)], SpaceSilo(silo=silo).walls(), pull, 60_000)
    x, y, z = rows(engine)[0, :3]
    depths = [x + RADIUS - 0.02, RADIUS - 0.02 - y, RADIUS - z]
    assert depths == pytest.approx([sunk(MASS * abs(part)) for part in pull], rel=1e-6)


def test_sphere_on_floor_and_cylinder_at_once():
    """Each its component, the cylinder by its curvature; the corner of both adds nothing."""
    wide = 0.01
    engine = settle([(wide - RADIUS, 0.0, RADIUS)], bin_walls(wide, 0.05), (4.0, 0.0, -GRAVITY), 60_000)
    x, _, z = rows(engine)[0, :3]
    assert x + RADIUS - wide == pytest.approx(sunk(4.0 * MASS, bent(wide)), rel=1e-6)
    assert RADIUS - z == pytest.approx(sunk(WEIGHT), rel=1e-6)


@pytest.mark.parametrize("modulus", [1e6, 1e9, 210e9])
def test_sphere_at_rest_on_walls_of_any_stiffness(modulus):
    """A grain of 1 GPa sinks by what both moduli give."""
    touch = contact(0.5, 0.5, materials=((1e9, POISSON), (modulus, 0.3)))
    depth = sunk(WEIGHT, stiffness=hertz_stiffness(1e9, (modulus, 0.3)))
    dt = 0.02 * sqrt(MASS * depth / WEIGHT)
    engine = settle([(0.0, 0.0, RADIUS)], (floor(),), (0.0, 0.0, -GRAVITY), 60_000, dt, touch)
    assert RADIUS - rows(engine)[0, 2] == pytest.approx(depth, rel=1e-8)


def test_a_sphere_as_wide_as_its_cylinder_falls_freely():
    """It touches the wall all around without being pressed."""
    walls = (TurnedLine(name="cylinder", start=(RADIUS, -1.0), end=(RADIUS, 1.0)),)
    engine = settle([(0.0, 0.0, 0.5)], walls, (0.0, 0.0, -GRAVITY), 50_000, touch=contact(0.5, 0.5))
    assert rows(engine)[0, 5] == pytest.approx(-GRAVITY * engine.time, rel=1e-12)
    assert np.array_equal(rows(engine)[0, :2], (0.0, 0.0))


@pytest.mark.parametrize("speed", [1.0, 10.0, 30.0])
def test_joint_of_cylinder_and_cone_at_speed(speed):
    """Pressed along the wall and into the cone: no energy is won or lost, momentum about the axis stays."""
    silo = Silo(plan="circular", diameter=0.04, wall_depth=0.04, hopper=Hopper(half_angle=radians(30.0), outlet_width=0.016))
    space = SpaceSilo(silo=silo)
    walls = tuple(wall for wall in space.walls() if wall.name != FLOOR)
    hard = contact(None, 0.0, 1e10)
    start = [(0.02 - RADIUS, 0.0, space.bottom + 0.01)]
    engine = Engine(spheres(start, [(0.0, 0.3 * speed, -speed)], walls=walls, wall_contact=hard, dt=2e-8))
    turning = start[0][0] * 0.3 * speed
    engine.step_to(round(0.03 / speed / 2e-8))
    (x, y, _, u, v, w, *spin) = rows(engine)[0]
    assert w > -0.9 * speed  # thrown back
    assert u**2 + v**2 + w**2 == pytest.approx(1.09 * speed**2, rel=2e-3)
    assert x * v - y * u == pytest.approx(turning, rel=1e-6)
    assert np.hypot(x, y) < 0.02 - 0.99 * RADIUS
    assert spin == [0.0, 0.0, 0.0]


def test_corner_of_a_pyramid_at_speed():
    """Into the edge of two faces and back: energy stays, and both faces are met alike."""
    silo = Silo(plan="square", diameter=0.04, wall_depth=0.02, hopper=Hopper(half_angle=radians(30.0), outlet_width=0.016))
    space = SpaceSilo(silo=silo)
    hard = contact(None, 0.0, 1e10)
    start = [(0.005, 0.005, 0.5 * space.bottom)]
    velocity = np.array([5.0, 5.0, 1.0])
    engine = Engine(spheres(start, velocity, walls=space.walls(), wall_contact=hard, dt=2e-8))
    engine.step_to(100_000)
    (x, y, _, u, v, w, *_) = rows(engine)[0]
    assert u**2 + v**2 + w**2 == pytest.approx(51.0, rel=2e-3)
    assert (x, u) == pytest.approx((y, v), rel=1e-9)
    assert u < 0.0


def test_pyramid_whose_outlet_is_tangent_to_the_wall():
    """One face is in one plane with the wall above it: a sphere slides over their joint as on one wall."""
    silo = Silo(plan="square", diameter=0.04, wall_depth=0.03, outlet_eccentricity=0.012,
                hopper=Hopper(half_angle=radians(30.0), outlet_width=0.016))  # fmt: skip
    space = SpaceSilo(silo=silo)
    assert any(abs(wall.normal[0] + 1.0) < 1e-12 for wall in space.walls() if wall.name.startswith("hopper"))
    walls = tuple(wall for wall in space.walls() if wall.name != FLOOR)
    side = 4.0
    start = [(0.02 - RADIUS + sunk(side * MASS), 0.0, space.bottom + 2.0 * RADIUS)]
    engine = settle(start, walls, (side, 0.0, -GRAVITY), 20_000)
    x, y, z, u, v, w = rows(engine)[0, :6]
    assert z < space.bottom - 0.9 * RADIUS
    assert x + RADIUS - 0.02 == pytest.approx(sunk(side * MASS), rel=1e-6)
    assert (y, v) == (0.0, 0.0)
    assert abs(u) < 1e-9
    assert w == pytest.approx(-GRAVITY * engine.time, rel=1e-12)


def test_energy_in_a_bin_without_losses():
    """One sphere that bounces between floor and walls of a bin for a long while, elastic and smooth: its energy stays."""
    engine = Engine(spheres([(0.003, 0.001, 0.006)], [(0.2, 0.13, 0.0)], (5.0, 1.0, 2.0), walls=bin_walls(0.0124, 0.05),
                            gravity=(0.0, 0.0, -GRAVITY), wall_contact=contact(None, 0.0), dt=1e-6))  # fmt: skip

    def energy():
        row = rows(engine)[0]
        return 0.5 * MASS * (row[3:6] ** 2).sum() + 0.5 * INERTIA * (row[6:] ** 2).sum() + WEIGHT * row[2]

    start, found = energy(), []
    for step in range(10_000, 500_001, 10_000):
        engine.step_to(step)
        x, y, z = rows(engine)[0, :3]
        if z > RADIUS and np.hypot(x, y) < 0.0124 - RADIUS:
            found.append(energy())
    assert len(found) > 30
    assert found == pytest.approx([start] * len(found), rel=1e-4)
