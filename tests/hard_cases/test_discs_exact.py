"""Hard cases of discrete elements that have exact answers.  Three kernels: equal discs, unequal discs with their ledger,
and semi-implicit dashpots."""

from math import atan2, cos, exp, log, pi, radians, sin, sqrt

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.model import Wall
from silostudy.dem.pieces import Laws
from tests.test_dem.scenes import DENSITY, RADIUS, SLIDING, STIFFNESS, contact, free, rows

MASS = DENSITY * pi * RADIUS**2
FLOOR = (Wall("floor", (-9.0, 0.0), (9.0, 0.0)),)
ELASTIC = {"pair_contact": contact(damping=0.0), "wall_contact": contact(damping=0.0)}


def stiff(stiffness, zeta=0.0, friction=0.577, mass=MASS / 2.0):
    """A contact of another stiffness, and of a damping ratio at a reduced mass."""
    return contact(stiffness / STIFFNESS, friction, damping=2.0 * zeta * sqrt(mass * stiffness) * STIFFNESS / stiffness)


def head_on(speed, pair, dt, steps, radius=RADIUS, **changes):
    """Two discs that just do not touch meet at 2 speed; x, y, u, v, w after so many steps."""
    gap = 1e-3 * speed * dt * steps
    radii = np.broadcast_to(radius, 2)
    model = free([0.0, radii.sum() + gap], [0.0, 0.0], u=[speed, -speed], pair_contact=pair, dt=dt, radius=radii, **changes)
    engine = Engine(model)
    engine.step_to(steps)
    return engine


@pytest.mark.long
def test_mass_ratio_of_a_million():
    radii = np.array([RADIUS, RADIUS / 1e3])
    heavy, light = DENSITY * pi * radii**2
    reduced = 1.0 / (1.0 / heavy + 1.0 / light)
    speed, dt = 1e-4, 2e-3 * sqrt(reduced / STIFFNESS)
    engine = head_on(speed, contact(damping=0.0), dt, 4000, radii, booked=True)
    (left, right), total = rows(engine)[:, 2], heavy + light
    assert left == pytest.approx(((heavy - light) * speed - 2.0 * light * speed) / total, rel=1e-12)
    assert right == pytest.approx((2.0 * heavy * speed - (light - heavy) * speed) / total, rel=1e-4)
    assert heavy * left + light * right == pytest.approx((heavy - light) * speed, rel=1e-13)


def test_radius_ratio_of_a_hundred():
    """A small disc on the top of a large one: the small one's weight and both weights, in two overlaps."""
    radii = np.array([RADIUS, RADIUS / 100.0])
    mass = DENSITY * pi * radii**2
    overlap = 9.81 * np.array([mass.sum() / (2.0 * STIFFNESS), mass[1] / STIFFNESS])
    low = radii[0] - overlap[0]
    y = np.array([low, low + radii.sum() - overlap[1]])
    dt = 0.1 * sqrt(mass[1] / STIFFNESS)
    start = y + np.array([0.0, 1e-9])
    engine = Engine(free([0.0, 0.0], start, radius=radii, gravity=(0.0, -9.81), dt=dt, walls=FLOOR, booked=True,
                         pair_contact=stiff(STIFFNESS, 1.0, mass=mass[1])))  # fmt: skip
    engine.step_to(20000)
    found = rows(engine)[:, 1]
    assert radii[0] - found[0] == pytest.approx(overlap[0], rel=1e-4)
    assert radii.sum() - (found[1] - found[0]) == pytest.approx(overlap[1], rel=1e-4, abs=0)


@pytest.mark.parametrize("power", range(2, 13))
def test_stiffness_over_ten_decades(power):
    """The same collision on another clock: restitution of a damped spring that never pulls."""
    stiffness, zeta = 10.0**power, 0.2
    clock = sqrt(MASS / 2.0 / stiffness)
    speed = 1e-3 * RADIUS / clock
    engine = head_on(speed, stiff(stiffness, zeta), 2e-4 * clock, 30000)
    root = sqrt(1.0 - zeta**2)
    expected = exp(-zeta / root * atan2(2.0 * zeta * root, 2.0 * zeta**2 - 1.0))
    left, right = rows(engine)[:, 2]
    assert left == -right
    assert right / speed == pytest.approx(expected, rel=2e-3)


def test_stack_of_a_thousand_discs_on_one():
    """Started where each contact carries what lies above it: nothing moves, and the lowest carries a thousand weights."""
    n = 1001
    above = MASS * 9.81 * np.arange(n, 0, -1)
    overlap = above / (STIFFNESS * np.r_[2.0, np.ones(n - 1)])
    y = RADIUS - overlap[0] + np.r_[0.0, np.cumsum(2.0 * RADIUS - overlap[1:])]
    engine = Engine(free(np.zeros(n), y, gravity=(0.0, -9.81), dt=2.5e-5, walls=FLOOR))
    engine.step_to(5000)
    found = rows(engine)
    assert (RADIUS - found[0, 1]) * 2.0 * STIFFNESS == pytest.approx(n * MASS * 9.81, rel=1e-9)
    assert np.abs(found[:, 1] - y).max() < 1e-9 * RADIUS
    assert np.all(found[:, [0, 2, 4]] == 0.0)


@pytest.mark.parametrize("half_angle", [0.5, 5.0, 30.0, 60.0, 85.0])
def test_disc_wedged_between_two_converging_walls(half_angle):
    """Without friction each wall presses with m g / (2 sin), and the disc sinks by that over K sin."""
    theta = radians(half_angle)
    walls = tuple(Wall(name, *ends) for name, ends in {
        "left": ((-9.0 * sin(theta), 9.0 * cos(theta)), (0.0, 0.0)), "right": ((0.0, 0.0), (9.0 * sin(theta), 9.0 * cos(theta)))
    }.items())  # fmt: skip
    smooth = contact(2.0, 0.0)
    push = MASS * 9.81 / (2.0 * sin(theta))
    y = (RADIUS - push / (2.0 * STIFFNESS)) / sin(theta)
    engine = Engine(free([0.0], [y * (1.0 + 1e-6)], gravity=(0.0, -9.81), dt=5e-5, walls=walls, wall_contact=smooth))
    engine.step_to(round(min(6e5, 2e4 / sin(theta) ** 2)))
    x, found = rows(engine)[0, :2]
    assert RADIUS - found * sin(theta) == pytest.approx(push / (2.0 * STIFFNESS), rel=1e-6)
    assert abs(x) < 1e-12 * RADIUS


def test_disc_exactly_on_the_edge_of_a_slit():
    """Its centre above the end of a wall: the edge pushes straight up and carries the weight; on both edges alike."""
    overlap = MASS * 9.81 / (2.0 * STIFFNESS)
    one = Engine(
        free([0.0], [RADIUS - overlap], gravity=(0.0, -9.81), dt=1e-5, walls=(Wall("floor", (-1.0, 0.0), (0.0, 0.0)),))
    )
    one.step_to(20000)
    assert RADIUS - rows(one)[0, 1] == pytest.approx(overlap, rel=1e-9)
    assert rows(one)[0, 0] == 0.0
    halves = (Wall("l", (-1.0, 0.0), (-RADIUS / 2.0, 0.0)), Wall("r", (RADIUS / 2.0, 0.0), (1.0, 0.0)))
    rise = sqrt(3.0) / 2.0  # of the direction from an edge
    smooth = contact(2.0, 0.0)
    both = Engine(free([0.0], [rise * RADIUS], gravity=(0.0, -9.81), dt=1e-5, walls=halves, wall_contact=smooth))
    both.step_to(40000)
    x, y = rows(both)[0, :2]
    length = sqrt(y**2 + RADIUS**2 / 4.0)
    assert 2.0 * 2.0 * STIFFNESS * (RADIUS - length) * y / length == pytest.approx(MASS * 9.81, rel=1e-9)
    assert abs(x) < 1e-12 * RADIUS


@pytest.mark.parametrize("overlap", [0.0, 1e-16, 1e-12, 1e-9])
def test_grazing_contact(overlap):
    """Two discs pass with next to no overlap: the push across is that of the spring along the chord."""
    speed, offset = 1.0, 2.0 * RADIUS * (1.0 - overlap)
    smooth = contact(damping=0.0, friction=0.0)
    engine = Engine(free([-0.1 * RADIUS, 0.1 * RADIUS], [0.0, offset], u=[speed, -speed], pair_contact=smooth, dt=1e-7))
    engine.step_to(2 * round(0.1 * RADIUS / speed / 1e-7))
    found = rows(engine)
    impulse = STIFFNESS * 4.0 / 3.0 * sqrt(4.0 * RADIUS) * (2.0 * RADIUS * overlap) ** 1.5 / (2.0 * speed)
    if overlap < 1e-12:
        assert np.array_equal(found[:, 2], [speed, -speed])
        assert np.abs(found[:, 3]).max() < 1e-12 * speed
    else:
        assert found[1, 3] == pytest.approx(impulse / MASS, rel=0.05, abs=2e-4 * STIFFNESS * 1e-7 / MASS * 2e-9)
    assert found[0, 3] == -found[1, 3]


def test_contact_that_opens_and_closes_within_a_step():
    """Discs so fast that a chord is over within a step: whether seen or missed, momentum stays and no energy is won."""
    for start in np.linspace(0.0, 1.0, 7):
        engine = Engine(free([0.0, (0.3 + 0.02 * start) * RADIUS], [0.0, 1.9999 * RADIUS], u=[300.0, -300.0], dt=1e-5))
        engine.step_to(40)
        found = rows(engine)
        energy = MASS * (found[:, 2] ** 2 + found[:, 3] ** 2 + RADIUS**2 * found[:, 4] ** 2 / 2.0).sum() / 2.0
        assert found[0, 2] == -found[1, 2]
        assert found[0, 3] == -found[1, 3]
        assert energy <= MASS * 300.0**2 * (1.0 + 1e-12)


@pytest.mark.parametrize("friction", [0.0, 1e6])
def test_no_friction_and_huge_friction_on_an_incline(friction):
    """Without it a disc slides at g sin and never turns; with all of it, it rolls at 2/3 g sin and never slips."""
    tilt = 1.2
    overlap = MASS * 9.81 * cos(tilt) / (2.0 * STIFFNESS)
    wall = contact(2.0, friction) if friction else contact(2.0, friction, damping=1e-9)
    pull = (9.81 * sin(tilt), -9.81 * cos(tilt))
    engine = Engine(free([0.0], [RADIUS - overlap], gravity=pull, dt=1e-5, walls=FLOOR, wall_contact=wall))
    engine.step_to(20000)
    _, _, u, _, w = rows(engine)[0]
    share = 2.0 / 3.0 if friction else 1.0
    assert u == pytest.approx(share * 9.81 * sin(tilt) * engine.time, rel=5e-4)
    assert -w * RADIUS == pytest.approx(u if friction else 0.0, rel=5e-3, abs=1e-6)


@pytest.mark.parametrize("zeta", [1.0, 3.0, 30.0, 300.0])
def test_critical_and_overcritical_damping(zeta):
    clock = sqrt(MASS / 2.0 / STIFFNESS)
    speed = 1e-3 * RADIUS / clock
    engine = head_on(speed, stiff(STIFFNESS, zeta), 4e-3 * clock / zeta, round(4000 * zeta))
    expected = exp(-2.0)
    if zeta > 1.0:
        root = sqrt(zeta**2 - 1.0)
        expected = exp(-zeta / root * log((zeta + root) / (zeta - root)))
    assert rows(engine)[1, 2] / speed == pytest.approx(expected, rel=2e-2)


def test_no_gravity_and_no_motion_change_no_bit():
    random = np.random.default_rng(1)
    x, y = 2.5 * RADIUS * (np.mgrid[:6, :6].reshape(2, -1) + random.uniform(-0.1, 0.1, (2, 36)))
    engine = Engine(free(x, y, dt=1e-4))
    engine.step_to(20000)
    assert np.array_equal(rows(engine)[:, :2], np.c_[x, y])


def test_impact_at_a_hundred_metres_a_second():
    stiffness = 1e12
    clock = sqrt(MASS / 2.0 / stiffness)
    engine = head_on(50.0, stiff(stiffness), 1e-3 * clock, 8000)
    left, right = rows(engine)[:, 2]
    assert left == -right
    assert right == pytest.approx(50.0, rel=1e-5)


def test_jammed_arch_under_rising_load():
    """A keystone on two discs that walls hold apart, as gravity grows a thousandfold: statics of the places as they are."""
    width = 5.0 * RADIUS
    lean = sqrt(4.0 * RADIUS**2 - (width / 2.0 - RADIUS) ** 2)
    x, y = [RADIUS, width - RADIUS, width / 2.0], [RADIUS, RADIUS, RADIUS + lean]
    walls = (
        Wall("floor", (0.0, 0.0), (width, 0.0)),
        Wall("left", (0.0, 1.0), (0.0, 0.0)),
        Wall("right", (width, 0.0), (width, 1.0)),
    )
    engine = Engine(
        free(
            x, y, gravity=(0.0, -0.1), dt=1e-5, walls=walls, pair_contact=contact(friction=0.0), wall_contact=contact(2.0, 0.0)
        )
    )
    for gravity in (0.1, 1.0, 10.0, 100.0):
        engine.gravity = (0.0, -gravity)
        engine.step_to(engine.step + 60000)
        (x0, y0), _, (x2, y2) = rows(engine)[:, :2]
        across, up = x2 - x0, y2 - y0
        thrust = MASS * gravity / 2.0 * across / up
        push = STIFFNESS * (2.0 * RADIUS - sqrt(across**2 + up**2))
        assert push == pytest.approx(sqrt(thrust**2 + (MASS * gravity / 2.0) ** 2), rel=1e-7)
        assert 2.0 * STIFFNESS * (RADIUS - x0) == pytest.approx(thrust, rel=1e-7)
        assert 2.0 * STIFFNESS * (RADIUS - y0) == pytest.approx(1.5 * MASS * gravity, rel=1e-7)


def test_overlap_at_rest_by_every_dashpot():
    """A disc on the floor sinks by m g / K, whatever the dashpot and the step: none may hold a share of the weight."""
    implicit = Laws.of(normal="spring-dashpot-implicit", tangential="spring-slider-implicit")
    overlap = MASS * 9.81 / (2.0 * STIFFNESS)
    for laws in (SLIDING, implicit):
        for dt in (1e-6, 5e-5):
            engine = Engine(free([0.0], [RADIUS], gravity=(0.0, -9.81), dt=dt, walls=FLOOR,
                                 wall_contact=contact(2.0, laws=laws), pair_contact=contact(laws=laws)))  # fmt: skip
            engine.step_to(round(0.1 / dt))
            assert RADIUS - rows(engine)[0, 1] == pytest.approx(overlap, rel=1e-9)


def test_restart_in_the_middle_of_a_collision():
    def start():
        return Engine(free([0.0, 1.9 * RADIUS], [0.0, 0.6 * RADIUS], u=[0.3, -0.3], w=[3.0, 5.0], dt=1e-6))

    through, before = start(), start()
    before.step_to(200)
    assert np.hypot(*np.diff(rows(before)[:, :2], axis=0)[0]) < 2.0 * RADIUS
    saved = checkpoint(before)
    assert saved["pair_stored"][0] != 0.0
    after = start()
    restore(after, saved)
    for engine in (through, after):
        engine.step_to(3000)
    assert np.array_equal(rows(through), rows(after))


def test_far_from_the_origin():
    """The same pile a kilometre away: what rounding of places leaves, and no more."""
    x = np.array([0.0, 2.0, 1.0]) * RADIUS
    y = np.array([1.0, 1.0, 1.0 + sqrt(3.0)]) * RADIUS
    near, far = (
        Engine(free(x + shift, y, gravity=(0.0, -9.81), dt=2e-5, walls=(Wall("floor", (-9.0, 0.0), (2e3, 0.0)),)))
        for shift in (0.0, 1024.0)
    )
    for engine in (near, far):
        engine.step_to(3000)
    ulp = np.spacing(1024.0)
    assert np.abs(rows(far)[:, 1] - rows(near)[:, 1]).max() < 2000 * ulp
    assert np.abs(rows(far)[:, 0] - 1024.0 - rows(near)[:, 0]).max() < 1e5 * ulp
