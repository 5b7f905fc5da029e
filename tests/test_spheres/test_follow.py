"""Steps that follow the contacts of spheres: shorter where these stiffen, longer where they are loose; nothing else changes."""

import numpy as np
import pytest

from silostudy.choice.dem import load
from silostudy.compute.sphere_cube import load_at_end
from silostudy.dem.follow import follow
from silostudy.dem.leaving import ticks_below
from silostudy.dem.space.lanes import PASSED
from tests.conftest import ROOT
from tests.test_spheres.small import carried, resumed, run, scene_of
from tests.test_spheres.test_moving_scene import FLAT

FOLLOWS = {"limit_s": 1.0, "step": "follow"}
PRESS = [
    {"when": "rest", "do": "lower_lid"},
    {"when": "after", "value": 0.2, "do": "press_lid", "stress_kPa": 20.0, "lid_mass_kg": 0.3},
    {"when": "after", "value": 0.2, "do": "stop"},
]


def test_the_step_falls_with_the_speed_of_what_may_hit_and_rises_again():
    small = run(scene_of(march=FOLLOWS))
    engine, steps = small.engine, []
    small.go(until=64_000)
    follow(engine, steps, False)
    before = engine.ticks
    engine.bodies.rows[0, engine.space.velocity[2]] = -20.0
    follow(engine, steps, False)
    assert engine.ticks < 0.8 * before
    assert steps[-1] == (engine.step, engine.ticks)
    engine.bodies.rows[0, engine.space.velocity[2]] = 0.0
    follow(engine, steps, False)
    assert engine.ticks == pytest.approx(before, abs=1)


def test_a_lid_that_presses_shortens_the_step():
    pressed = carried(scene_of(march=FOLLOWS, silo=FLAT, lid=True, events=PRESS, record={}))
    assert not pressed.trouble
    (_, _, _), (load, _, _), _ = pressed.recording.happened
    time, ticks = np.array(pressed.recording.steps).T
    resting = ticks[time * pressed.engine.model.dt < load][-1]
    assert ticks[-1] < 0.8 * resting


def test_how_long_spheres_have_been_below_stays_where_the_step_changes():
    engine = run(scene_of(march=FOLLOWS)).engine
    engine.n = 3
    engine.bodies.rows[:3, PASSED] = 0.0, 5.0, 1000.0
    below = ticks_below(engine)
    assert below.tolist() == [0.0, 5.0 * 16, 1000.0 * 16]
    for ticks in (23, 7, 21):
        engine.take_steps_of(ticks)
        assert np.array_equal(ticks_below(engine), below)


@pytest.mark.long
def test_restart_on_two_threads():
    scene = scene_of(march=FOLLOWS)
    through = carried(scene)
    other, _ = resumed(scene, 16 * 5237, threads=2)
    assert len(through.recording.steps) > 3
    assert other.recording.steps == through.recording.steps
    assert other.recording.passed == through.recording.passed
    assert np.array_equal(through.engine.bodies.rows[: through.engine.n], other.engine.bodies.rows[: other.engine.n])


@pytest.mark.long
def test_what_rains_in_later_is_not_met_with_a_step_that_few_bear():
    """Sixty spheres of 2 to 20 mm come in within a fifth of a second, most of them after the first look at the contacts."""
    path = ROOT / "config/scenes/hard/size-ratio-10.yaml"
    scene, _ = load(path)
    scene = scene.model_copy(update={"march": scene.march.model_copy(update={"step": "follow"})})
    follows = run(scene, path.parent)
    follows.go()
    assert not follows.trouble
    steps = [ticks for tick, ticks in follows.recording.steps if tick * follows.engine.model.dt < 60 / scene.filling.rate_1_s]
    assert max(steps) <= follows.engine.model.pace.ticks
    assert load_at_end(follows) == pytest.approx(scene.expected[0].value_N, abs=scene.expected[0].tolerance_N)
