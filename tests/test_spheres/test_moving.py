"""Walls that move: a lid's load, speed and stops, surfaces that turn, torque and work, the same bits."""

from math import pi, sqrt

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import CREATED, KINETIC, TURNOVER, WALLS, balance
from silostudy.dem.model import Lid
from silostudy.dem.moves import force_on_lid, lid_height, lid_rests, lower_lid, move_lid, press_lid, turn_walls
from silostudy.dem.space.felt import TORQUE
from silostudy.dem.space.lanes import P, U, X
from silostudy.dem.space.walls import TurnedLine
from tests.test_spheres.scenes import GRAVITY, INERTIA, MASS, RADIUS, bin_walls, contact, heap, rows, same, spheres

pytestmark = pytest.mark.long
WIDE, HIGH = 6.2 * RADIUS, 0.035
FRICTION = 0.3


def lid(high=HIGH, wide=WIDE) -> TurnedLine:
    return TurnedLine(name="lid", start=(0.0, high), end=(wide, high), joined=(True, True), cells=(2, 3))


def pressed(high=HIGH, layers=6, mass=np.inf, **changes):
    """Spheres that fall into a cylinder with a lid."""
    area = pi * WIDE**2
    settings = {"walls": (*bin_walls(WIDE, HIGH), lid(high)), "moving": True,
                "lid": Lid(area=area, touching=area / (2.0 * sqrt(3.0) * RADIUS**2), mass=mass)}  # fmt: skip
    return heap(layers=layers, **(settings | changes))


def one(height=RADIUS, high=2.0 * RADIUS, **changes):
    """One sphere on the floor under a lid."""
    walls = (*bin_walls(WIDE, HIGH), lid(high))
    settings = {"walls": walls, "moving": True, "lid": Lid(area=pi * WIDE**2, touching=1.0), "gravity": (0.0, 0.0, -GRAVITY),
                "dt": 2e-6, "wall_contact": contact(0.3)}  # fmt: skip
    return spheres([(0.001, 0.0, height)], **(settings | changes))


def hertz(engine) -> float:
    """Stiffness of F = k delta^1.5 between a sphere and a flat wall, N m-1.5."""
    return engine.model.wall_contact.coefficients["hertz_stiffness"] * sqrt(RADIUS)


def test_a_loaded_lid_compresses_a_sphere_between_two_flat_walls():
    engine, load = Engine(one()), 0.5
    press_lid(engine, load, 0.1, 0.02, 0.0)
    engine.step_to(300_000)
    weight, k = MASS * GRAVITY, hertz(engine)
    felt = engine.record.now[:, 0]
    assert lid_rests(engine)
    assert force_on_lid(engine) == pytest.approx(load, rel=1e-9)
    assert felt[:8].sum() == pytest.approx(load + weight, rel=1e-9)  # the floor's
    deep = (load / k) ** (2 / 3) + ((load + weight) / k) ** (2 / 3)
    assert lid_height(engine) == pytest.approx(2.0 * RADIUS - deep, rel=1e-10)


def test_a_lid_in_next_to_no_drag_swings_on_its_contacts_and_keeps_its_energy():
    mass, load = 100.0 * MASS, 0.2
    engine = Engine(one(wall_contact=contact(1.0, 0.0), booked=True, gravity=(0.0, 0.0, 0.0), dt=5e-7))
    k = hertz(engine)
    deep = (load / k) ** (2 / 3)
    engine.bodies.rows[0, X + 2] = RADIUS - deep
    engine.space.lift(engine.walls.shape, 2, -2.02 * deep)
    press_lid(engine, load, mass, 1e9, 0.0)
    start, heights = lid_height(engine), []
    for step in range(20, 40_001, 20):
        engine.step_to(step)
        heights.append(lid_height(engine))
    middle = np.array(heights) - (2.0 * RADIUS - 2.0 * deep)
    turns = np.flatnonzero((middle[:-1] < 0.0) & (middle[1:] >= 0.0))
    period = np.diff(turns).mean() * 20 * engine.model.dt
    stiffness = 0.5 * 1.5 * k * sqrt(deep)
    assert period == pytest.approx(2.0 * pi * sqrt((mass + MASS / 4.0) / stiffness), rel=5e-3)
    moved = 0.5 * mass * engine.walls.shape[2, engine.space.rise] ** 2
    given = load * (start - lid_height(engine)) - moved
    swing = 0.5 * stiffness * (0.02 * deep) ** 2
    assert engine.ledger.account[WALLS] == pytest.approx(given, abs=0.05 * swing)


def test_a_lid_stops_at_the_step_of_a_force_and_at_a_height():
    engine = Engine(pressed())
    engine.step_to(4000)
    lower_lid(engine)
    top = (engine.bodies.rows[: engine.n, X + 2] + RADIUS).max()
    assert lid_height(engine) == pytest.approx(top, rel=1e-15)
    move_lid(engine, -0.05, 2.0, -np.inf)
    forces = []
    while not lid_rests(engine):
        engine.step_to(engine.step + 1)
        forces.append(force_on_lid(engine))
    assert forces[-1] >= 2.0 > max(forces[:-1])
    still = lid_height(engine)
    assert still == pytest.approx(top - 0.05 * engine.model.dt * (len(forces) - 1), rel=1e-12)
    engine.step_to(engine.step + 50)
    assert lid_height(engine) == still
    move_lid(engine, 0.1, np.inf, still + 1.2345e-3)
    engine.step_to(engine.step + 2000)
    assert lid_height(engine) == pytest.approx(still + 1.2345e-3, rel=1e-15)
    assert lid_rests(engine)


def drum(angle, spin, turning, friction=FRICTION, pressed_in=0.0):
    """A sphere in a cylinder that lies, at an angle from its lowest line (rad), and the cylinder's spin."""
    wide = 0.03
    away = wide - RADIUS + pressed_in
    place = (-away * np.cos(angle), -away * np.sin(angle), 0.01)  # at a positive angle the wall below it moves towards -y
    cylinder = TurnedLine(name="cylinder", start=(wide, -0.1), end=(wide, 0.1))
    engine = Engine(
        spheres(
            [place],
            spin=(0.0, 0.0, spin),
            walls=(cylinder,),
            moving=True,
            gravity=(-GRAVITY, 0.0, 0.0),
            dt=2e-6,
            wall_contact=contact(0.3, friction),
        )
    )
    turn_walls(engine, turning, "cylinder")
    return engine, wide


def bent_hertz(engine, wide) -> float:
    return engine.model.wall_contact.coefficients["hertz_stiffness"] * sqrt(RADIUS / (1.0 - RADIUS / (2.0 * wide)))


def test_a_sphere_slides_in_a_drum_at_the_angle_of_friction_while_it_spins_up():
    angle = np.arctan(FRICTION)
    normal = MASS * GRAVITY * np.cos(angle)
    probe, wide = drum(angle, 0.0, 0.0)
    engine, _ = drum(angle, 0.0, 50.0, pressed_in=(normal / bent_hertz(probe, wide)) ** (2 / 3))
    engine.step_to(10_000)
    x, y, _, *_, spin = rows(engine)[0]
    assert np.arctan2(-y, -x) == pytest.approx(angle, abs=2e-4)
    assert spin == pytest.approx(FRICTION * normal * RADIUS / INERTIA * engine.time, rel=2e-3)
    assert FRICTION * normal * RADIUS / INERTIA * engine.time < 0.5 * 50.0 * wide / RADIUS


def test_a_sphere_in_a_drum_comes_to_roll_at_the_speed_of_the_wall():
    engine, wide = drum(0.0, 0.0, 2.0, friction=0.6)
    engine.step_to(150_000)
    x, y, _, u, v, _, _, _, spin = rows(engine)[0]
    normal = np.array([-x, -y]) / np.hypot(x, y)
    along = np.array([u, v]) @ (normal[1], -normal[0])
    assert along + spin * RADIUS == pytest.approx(2.0 * wide, rel=2e-3)
    steady, _ = drum(0.0, 2.0 * wide / RADIUS, 2.0, friction=0.6)
    steady.step_to(20_000)
    assert rows(steady)[0, P + 2] == pytest.approx(2.0 * wide / RADIUS, rel=1e-9)
    assert rows(steady)[0, X + 1] == pytest.approx(0.0, abs=1e-9 * RADIUS)


def test_momentum_torque_and_ledger_close_while_walls_move():
    engine = Engine(pressed(booked=True))
    engine.step_to(6000)
    lower_lid(engine)
    press_lid(engine, 3.0, 0.05, 0.2, 0.0)
    turn_walls(engine, 15.0, "cylinder")
    turn_walls(engine, -5.0, "lid")
    engine.clear_window()
    before, start, steps = rows(engine), balance(engine.ledger.account), 5000
    engine.step_to(6000 + steps)
    after, account = rows(engine), engine.ledger.account
    assert abs(balance(account) - start) < 1e-10 * account[TURNOVER]
    assert account[WALLS] > 0.01 * account[TURNOVER]
    felt = engine.record.window[:, :, 0] * engine.model.dt
    floor, cylinder, top = felt[:8], felt[8:48], felt[48:]
    gained = MASS * (after[:, U + 2] - before[:, U + 2]).sum()
    pushed = floor[:, 0].sum() + cylinder[:, 1].sum() - top[:, 0].sum()
    weight = MASS * GRAVITY * engine.n * steps * engine.model.dt
    assert pushed - weight == pytest.approx(gained, abs=1e-10 * weight)
    swirl = [MASS * (at[:, 0] * at[:, 4] - at[:, 1] * at[:, 3]).sum() + INERTIA * at[:, 8].sum() for at in (before, after)]
    assert np.diff(swirl)[0] == pytest.approx(-felt[:, TORQUE].sum(), rel=2e-2)  # levers of drag end a depth apart
    assert cylinder[:, TORQUE].sum() < 0.0 < abs(top[:, TORQUE].sum())
    assert abs(cylinder[:, TORQUE].sum()) == pytest.approx(WIDE * abs(cylinder[:, 2].sum()), rel=1e-9)


def test_what_the_step_creates_in_a_turning_cylinder_vanishes_with_it():
    created = []
    for dt in (1e-5, 2.5e-6):
        engine = Engine(pressed(booked=True, dt=dt))
        turn_walls(engine, 20.0, "cylinder")
        engine.step_to(round(0.1 / dt))
        created.append(abs(engine.ledger.account[CREATED]) / engine.ledger.account[TURNOVER])
    assert engine.ledger.account[WALLS] > 0.0
    assert engine.ledger.account[KINETIC] > 0.0
    assert created[1] < 0.3 * created[0]


def stepped(engine, stops=(6000,)):
    """A lid that comes down under a load while the cylinder turns."""
    lower_lid(engine)
    press_lid(engine, 3.0, 0.05, 0.2, 0.0)
    turn_walls(engine, 15.0, "cylinder")
    return onward(engine, stops)


def onward(engine, stops=(6000,)):
    for stop in stops:
        engine.step_to(stop)
    return rows(engine), engine.record.window.copy(), engine.walls.shape.copy(), engine.walls.drive.copy()


@pytest.fixture(scope="module")
def reference():
    return stepped(Engine(pressed()))


def test_any_skin_any_chunk_and_a_restart_while_the_lid_moves(reference):
    for skin in (0.05, 1.0):
        assert same(stepped(Engine(pressed(), skin=skin * RADIUS)), reference)
    assert same(stepped(Engine(pressed()), (*range(37, 6000, 37), 6000)), reference)
    begun, again = Engine(pressed()), Engine(pressed())
    stepped(begun, (2345,))
    restore(again, checkpoint(begun))
    assert same(onward(again), reference)
    assert np.abs(reference[2] - Engine(pressed()).walls.shape).max() > RADIUS  # the lid has come far


def test_any_number_of_threads():
    many = [stepped(Engine(pressed(layers=60, high=0.3), threads=threads), (3000,)) for threads in (1, 2)]
    assert same(*many)


def test_python_twin_of_the_step():
    place = RADIUS * np.array([(0.0, 0.0, 0.99), (2.0, 0.1, 1.0), (-1.0, 1.8, 0.995), (0.3, 0.6, 2.6)])
    engines = []
    for plain in (False, True):
        engine = Engine(spheres(place, walls=(*bin_walls(WIDE, HIGH), lid(3.7 * RADIUS)), moving=True, dt=1e-5,
                                lid=Lid(area=1.0, touching=4.0)))  # fmt: skip
        engine._kernel = engine._kernel.py_func if plain else engine._kernel
        press_lid(engine, 0.3, 0.01, 0.5, 0.0)
        turn_walls(engine, 10.0, "floor", "lid")
        engine.step_to(150)
        engines.append(engine)
    compiled, plain = engines
    assert np.array_equal(rows(compiled), rows(plain))
    assert np.array_equal(compiled.walls.shape, plain.walls.shape)
    assert force_on_lid(compiled) > 0.0


def test_walls_that_may_move_and_stand_change_no_bit():
    engines = [Engine(heap(layers=6, moving=moving)) for moving in (False, True)]
    for engine in engines:
        engine.step_to(3000)
    assert np.array_equal(rows(engines[0]), rows(engines[1]))
    assert np.array_equal(engines[0].record.window, engines[1].record.window[:, :3])
