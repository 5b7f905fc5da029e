"""Steps that are longer at rest: short ones while discs move, fewer in all, the same bits however carried out."""

import pickle
from pathlib import Path

import numpy as np
import pytest

from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.scenes_windows import whole_windows
from silostudy.dem.calm import fastest
from silostudy.dem.engine import Engine
from silostudy.dem.follow import steps_made
from silostudy.dem.lanes import V, W
from silostudy.dem.pace import LIVELY, TICKS, Pace, longer_at_rest
from silostudy.errors import BadInput
from silostudy.scene.notes import notes

from .branches import PLAIN, branched, ended, same_motion, stop
from .scenes import free
from .small import carried, scene_of

EIGHTH = {"step": "longer_at_rest", "step_factor": 0.125, "step_s": None}
RESTS = [stop(0.3)]
LOWERED = [{"when": "time", "value": 0.15, "do": "lower_lid"}, stop(0.15)]
OPENS = [{"when": "time", "value": 0.25, "do": "open_slit"}, stop(0.4)]


def of_scene(*events, **march):
    return scene_of(march=EIGHTH | {"limit_s": 1.0} | march, events=[*events], record={"wall_force_window_s": 0.01})


@pytest.fixture(scope="module")
def through():
    return carried(of_scene(*OPENS))


def ticks_at(run, time):
    """Ticks of the steps made at a time (s)."""
    since, ticks = np.array(run.recording.steps).T
    return int(ticks[np.searchsorted(since * run.engine.model.dt, time, side="right") - 1])


def test_steps_are_short_until_rest_long_at_rest_and_short_again_once_it_opens(through):
    longest = through.engine.model.pace.longest
    assert longest == 8 * TICKS
    assert ticks_at(through, 0.0) == ticks_at(through, 0.01) == TICKS
    assert ticks_at(through, 0.2499) == longest
    assert ticks_at(through, 0.2501) == ticks_at(through, 0.26) == TICKS
    assert not through.trouble
    assert through.dropped > 0.0
    assert whole_windows(through).all()


def test_forces_at_rest_are_those_of_the_short_step():
    """To a quarter of what the long step throughout is off, in a fifth of the steps."""
    runs = [carried(of_scene(*RESTS, **march)) for march in ({"step": "fixed"}, {}, {"step": "fixed", "step_factor": 1.0})]
    short, longer, long = (run.recording.window[-1][:, :, 0].sum(axis=-1) for run in runs)
    off, of_long = (np.abs(forces - short).max() / short.max() for forces in (longer, long))
    assert 4.0 * off < of_long
    assert 5 * steps_made(runs[1]) < steps_made(runs[0])


def test_the_cube_holds_the_steps(through):
    cube = cube_of(through, of_scene(*OPENS))
    spans = np.diff(cube["step_time"].values, append=through.engine.time)
    assert (spans / cube["step_from_then"].values).sum() == pytest.approx(cube.attrs["steps"], rel=1e-9)
    assert cube["step_from_then"].values.max() == pytest.approx(8.0 * cube.attrs["time_step_s"], rel=1e-12)


@pytest.mark.parametrize("how", [{"threads": 2}, {"chunk": 997}, {"restarts": True}])
def test_any_threads_chunk_and_restart(how, through):
    scene = of_scene(*OPENS)
    run = run_of(scene, scene_model(scene, Path()), threads=how.get("threads", 1))
    if "restarts" in how:
        run.go(until=next(tick for tick, ticks in through.recording.steps if ticks > TICKS))
        assert run.engine.past != run.engine.ticks
        other = run_of(scene, scene_model(scene, Path()), threads=2)
        other.restore(pickle.loads(pickle.dumps(run.checkpoint())))
        run = other
    while not run.done:
        run.go(until=run.engine.step + how["chunk"] if "chunk" in how else None)
    assert same_motion(run, through)
    assert run.recording.steps == through.recording.steps
    assert np.array_equal(run.recording.window, through.recording.window)


@pytest.mark.parametrize("stopped", [0.15, 0.201])
def test_a_branch_goes_on_with_the_bits_of_one_run(stopped, tmp_path):
    march = {f"march__{key}": value for key, value in EIGHTH.items()}
    whole = carried(scene_of(events=[*OPENS], **PLAIN | march))
    ended(tmp_path, stop(stopped), **march)
    assert same_motion(branched(tmp_path, *OPENS, **march), whole)
    with pytest.raises(BadInput, match=r"other march\.step_factor: 0\.125 there, 0\.25 here"):
        branched(tmp_path, *OPENS, **march | {"march__step_factor": 0.25})


def test_what_is_moved_keeps_the_short_step(tmp_path):
    """A base that is still all along may shake, and a lid that waits may come down."""
    file = tmp_path / "base.csv"
    np.savetxt(file, [[0.0, 0.0, 0.0], [0.5, 0.0, 0.0]], delimiter=",", header="time_s,x_m_s2,y_m_s2", comments="")
    shaken = scene_of(march=EIGHTH | {"limit_s": 1.0}, events=[stop(0.15)], quake={"file": str(file)}, record={})
    closed = scene_of(march=EIGHTH | {"limit_s": 1.0}, events=LOWERED, silo__lid=True, silo__slit_width_m=0.0, record={})
    for scene in (shaken, closed):
        run = carried(scene)
        assert run.recording.steps == [(0, TICKS)]
        assert fastest(run.engine) < 0.01 * LIVELY


def test_the_fastest_body_counts_with_its_spin():
    engine = Engine(free([0.0, 1.0], [0.0, 0.0], gravity=(0.0, -10.0)))
    radius = engine.radius[0]
    fall = np.sqrt(2.0 * 10.0 * radius)
    engine.bodies.rows[1, V] = 0.2
    assert fastest(engine) == pytest.approx(0.2 / fall, rel=1e-12)
    engine.bodies.rows[0, W] = 0.4 / radius
    assert fastest(engine) == pytest.approx(np.sqrt(0.5) * 0.4 / fall, rel=1e-12)
    engine.gravity = (0.0, 0.0)
    assert fastest(engine) == np.inf


def test_the_fastest_body_moves_no_further_in_a_longer_step():
    pace = Pace(ticks=16, longest=64, lively=0.1)
    assert [pace.at_speed(16, speed, 1.0) for speed in (np.inf, 0.1, 0.05, 0.026, 0.01, 0.0)] == [16, 16, 32, 61, 64, 64]
    assert [pace.at_speed(16, speed, 0.1) for speed in (0.1, 0.03, 0.01)] == [16, 16, 48]  # three tenths of the largest count
    assert pace.at_speed(31, 0.05, 1.0) == 31  # less than a twentieth more
    assert pace.at_speed(63, 0.001, 1.0) == 64
    assert pace.at_speed(64, 0.2, 1.0) == 16
    pace = longer_at_rest(0.7)
    assert (pace.ticks, pace.longest, pace.usual, pace.kind) == (16, 22, 22, "longer_at_rest")
    assert longer_at_rest(0.125).factor == 0.125


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"march__step_s": 1e-5}, "march.step_s = .*: must be left out: step: longer_at_rest chooses the time step"),
        ({"march__beyond_stability": True}, "march.beyond_stability = True: must be left out: step: longer_at_rest chooses"),
        ({"accuracy": {"wall_force": 0.1}}, "march.step = 'longer_at_rest': give either accuracy or this"),
    ],
)
def test_what_does_not_go_with_it_is_refused(changes, said):
    with pytest.raises(BadInput, match=said):
        scene_of(**{"march": {"step": "longer_at_rest", "limit_s": 1.0}} | changes)


def test_times_after_events_add_up_to_the_limit():
    """Events come up to a step late, and count from when they were due."""
    events = [{"when": "after", "value": 0.05, "do": "set_friction", "wall_friction": 0.2} for _ in range(3)]
    march = EIGHTH | {"limit_s": 0.2}
    run = carried(scene_of(march=march, events=[*events, {"when": "after", "value": 0.05, "do": "stop"}], **PLAIN))
    assert not run.trouble
    assert [time for time, *_ in run.recording.happened] == pytest.approx([0.05, 0.1, 0.15, 0.2], abs=run.engine.model.step * 8)
    assert [time for time, *_ in run.recording.happened][-1] >= 0.2


def test_a_tick_has_one_step(tmp_path):
    """A branch that begins with an event makes the first step again where the longest was to come."""
    march = {f"march__{key}": value for key, value in EIGHTH.items()}
    ended(tmp_path, stop(0.2), **march)
    branch = branched(tmp_path, {"when": "after", "value": 0.0, "do": "open_slit"}, stop(0.21), **march)
    since = [tick for tick, _ in branch.recording.steps]
    assert len(since) == len(set(since))


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"march__step_factor": 1.0}, "without a march.step_factor below 1"),
        ({"silo__lid": True, "silo__slit_width_m": 0.0, "events": LOWERED}, "a wall of it moves"),
        ({}, ""),
    ],
)  # fmt: skip
def test_check_says_where_no_step_gets_longer(changes, said):
    scene = scene_of(**{"march": EIGHTH | {"limit_s": 1.0}, "record": {}} | changes)
    told = " ".join(notes(scene, scene_model(scene, Path())))
    assert ("longer_at_rest" in told) == bool(said)
    assert said in told
