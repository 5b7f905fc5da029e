"""Walls whose face runs along them: what they drag, the work that they do, the same bits, and what a scene may ask."""

import copy

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.ledger import SLIDING, TURNOVER, WALLS, balance
from silostudy.dem.model import Wall
from silostudy.dem.moves import run_belts
from silostudy.dem.run import Run
from silostudy.dem.walls import belt_at
from silostudy.errors import BadInput
from silostudy.scene.dem import effects, events_of
from tests.test_dem.scenes import DENSITY, GRAVITY, RADIUS, contact, free, rows, silo
from tests.test_dem.small import scene_of

SPEED = 0.3
FRICTION = 0.2
BELTS = (Event("time", 0.01, "run", (SPEED, "floor", "right")), Event("time", 0.06, "stop"))


def on_a_belt(way: tuple[float, float], friction: float = FRICTION) -> Engine:
    """A disc that bears its weight on a wall of a direction, whose face begins to run."""
    x, y = way
    touch = contact(2.0, friction, damping=0.0)
    weight = DENSITY * np.pi * RADIUS**2 * GRAVITY
    high = RADIUS - weight / touch.coefficients["normal_stiffness"]
    belt = Wall("belt", (-x, -y), (x, y))
    engine = Engine(
        free([-y * high], [x * high], walls=(belt,), wall_contact=touch, moving=True, gravity=(y * GRAVITY, -x * GRAVITY))
    )
    run_belts(engine, SPEED, "belt")
    return engine


@pytest.mark.parametrize("way", [(1.0, 0.0), (-1.0, 0.0), (0.6, 0.8)])
def test_a_disc_slides_on_a_belt_until_it_rolls_along_at_a_third_of_its_speed(way):
    engine, weight = on_a_belt(way), DENSITY * np.pi * RADIUS**2 * GRAVITY
    grip = SPEED / (3.0 * FRICTION * GRAVITY)  # three times the friction, by weight and by spin, takes the sliding away
    engine.step_to(int(0.5 * grip / engine.model.dt))
    _, _, u, v, spin = rows(engine)[0]
    assert np.array([u, v]) @ way == pytest.approx(FRICTION * GRAVITY * engine.time, rel=1e-3)
    assert spin * RADIUS == pytest.approx(2.0 * FRICTION * GRAVITY * engine.time, rel=1e-3)
    assert engine.record.now[:, 0].sum() == pytest.approx(weight, rel=1e-6)
    engine.step_to(int(2.0 * grip / engine.model.dt))
    _, _, u, v, spin = rows(engine)[0]
    along = np.array([u, v]) @ way
    assert along == pytest.approx(SPEED / 3.0, rel=0.01)
    assert along + spin * RADIUS == pytest.approx(SPEED, rel=0.02)


def test_the_end_of_a_belt_stands_still_along_it():
    engine = on_a_belt((0.6, 0.8))
    shape = engine.walls.shape
    assert belt_at(shape, 0, -0.8, 0.6) == pytest.approx((0.6 * SPEED, 0.8 * SPEED))
    assert belt_at(shape, 0, 0.6, 0.8) == pytest.approx((0.0, 0.0), abs=1e-15)


def carried(threads=1, **changes) -> Run:
    """The small silo with floor and right wall as belts."""
    run = Run(Engine(silo(moving=True, slit=0.0, **changes), threads=threads), BELTS, limit=1.0, window=500)
    run.go()
    return run


def test_the_ledger_closes_over_the_work_of_belts():
    engine = Engine(silo(moving=True, slit=0.0, booked=True))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    Run(engine, BELTS, limit=1.0).go()
    account = engine.ledger.account
    assert account[WALLS] > 0.1 * account[SLIDING] > 0.0
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]


def test_belts_give_the_same_bits_on_more_threads_and_after_a_restart():
    whole, many = carried(), carried(threads=2)
    assert np.array_equal(rows(whole.engine), rows(many.engine))
    assert np.array_equal(whole.recording.window, many.recording.window)
    halved, again = (Engine(silo(moving=True, slit=0.0)) for _ in range(2))
    first = Run(halved, BELTS, limit=1.0, window=500)
    first.go(until=1111)
    rest = Run(again, BELTS, limit=1.0, window=500)
    rest.restore(copy.deepcopy(first.checkpoint()))
    rest.go()
    assert np.array_equal(rows(again), rows(whole.engine))
    assert np.array_equal(rest.recording.motion, whole.recording.motion)
    restored = Engine(silo(moving=True, slit=0.0))
    restore(restored, checkpoint(whole.engine))
    assert (restored.walls.shape == whole.engine.walls.shape).all()


def test_walls_that_could_run_and_do_not_give_the_bits_of_walls_that_stand():
    still, able = Engine(silo()), Engine(silo(moving=True))
    for engine in (still, able):
        engine.step_to(3000)
    assert np.array_equal(rows(still), rows(able))


def asked(**changes):
    belt = {"when": "time", "value": 0.05, "do": "run_belt"} | changes
    return scene_of(events=[belt, {"when": "after", "value": 0.1, "do": "stop"}], silo__slit_width_m=0.0)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"speed_m_s": 0.1}, "surfaces: must be given where do is run_belt"),
        ({"surfaces": ["floor"]}, "speed_m_s: must be given where do is run_belt"),
        ({"speed_m_s": 0.1, "surfaces": ["floor"], "stress_kPa": 1.0}, "run_belt takes no stress_kPa; it takes speed_m_s"),
    ],
)
def test_belts_that_lack_or_have_too_much(changes, told):
    with pytest.raises(BadInput, match=told):
        asked(**changes)


def test_a_belt_runs_either_way_and_is_of_a_wall_that_there_is():
    scene = asked(speed_m_s=-0.1, surfaces=["floor", "left"])
    event, _ = events_of(scene, 1.0)
    assert (event.action, event.what) == ("run", (-0.1, "floor", "left"))
    assert next(effect for effect in effects(scene) if effect.name == "walls that move").on
    with pytest.raises(BadInput, match=r"events.0.surfaces = 'lid': unknown; known: floor, left, right"):
        events_of(asked(speed_m_s=0.1, surfaces=["lid"]), 1.0)
