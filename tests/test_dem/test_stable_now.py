"""The longest stable step of a run's contacts as they are."""

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.stability import longest_step
from silostudy.dem.stable_now import NEARLY, deepest, present, stable_now
from tests.test_spheres import small as spheres

from .scenes import free, silo

CLOSE = 2.0 * NEARLY


def test_at_the_start_of_linear_springs_it_is_that_of_the_model():
    model = silo(across=8, height=0.2)
    assert stable_now(Engine(model)) == pytest.approx(longest_step(model), rel=CLOSE)


def test_discs_that_came_together_shorten_it():
    """Three discs that do not touch yet; then they stand in a row in touch."""
    apart, close = free([0.0, 0.1, 0.2], [0.0] * 3), free([0.0, 0.02, 0.04], [0.0] * 3)
    engine = Engine(apart)
    before = stable_now(engine)
    engine.bodies.rows[:3, :2] = close.place
    assert before == pytest.approx(longest_step(apart), rel=CLOSE)
    assert stable_now(engine) == pytest.approx(longest_step(close), rel=CLOSE)
    assert stable_now(engine) < 0.9 * before


def test_slow_shallow_contacts_of_hertz_bear_a_longer_step_and_fast_spheres_a_shorter():
    """The slope goes with the root of the overlap, the step with its fourth root."""
    run = spheres.run(spheres.scene_of())
    engine = run.engine
    run.go(until=4000)
    model = present(engine)
    assert len(model.x) == engine.n
    share = deepest(engine, model)
    assert stable_now(engine) == pytest.approx(longest_step(model, engine.walls, share), rel=CLOSE)
    engine.bodies.rows[: engine.n, list(engine.space.velocity)] *= 1e-6
    assert deepest(engine, present(engine)) <= share
    engine.bodies.rows[: engine.n, list(engine.space.velocity)] = 0.0
    engine.bodies.rows[0, engine.space.velocity[2]] = -10.0
    fast = deepest(engine, present(engine))
    assert fast > share
    slow_step, fast_step = (longest_step(model, engine.walls, deep) for deep in (share, fast))
    assert fast_step == pytest.approx(slow_step * (share / fast) ** 0.25, rel=0.1)


def test_looking_changes_no_bit():
    model = silo(across=8, height=0.2)
    looked, other = Engine(model), Engine(model)
    for step in (200, 400, 600):
        looked.step_to(step)
        stable_now(looked)
        other.step_to(step)
    assert np.array_equal(looked.bodies.rows[: looked.n], other.bodies.rows[: other.n])
