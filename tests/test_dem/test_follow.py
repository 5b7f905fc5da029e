"""Steps that follow the contacts: exact where they change, the same bits however a run is carried out, and what is refused."""

import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.scenes_windows import whole_windows
from silostudy.dem.engine import Engine
from silostudy.dem.follow import steps_made
from silostudy.dem.lanes import U, V, Y
from silostudy.dem.ledger import BASE, balance
from silostudy.dem.pace import FIXED, TICKS, Pace, following
from silostudy.errors import BadInput
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY

from .scenes import free, silo
from .small import scene_of

FOLLOWS = {"step": "follow", "limit_s": 1.0}
TICK = 1e-6


@pytest.fixture(scope="module", params=["still", "shaken"])
def scene(request, tmp_path_factory):
    if request.param == "still":
        return scene_of(march=FOLLOWS)
    time = np.linspace(0.0, 1.0, 501)
    record = np.column_stack([time, 2.0 * np.sin(2.0 * np.pi * 10.0 * time), np.sin(2.0 * np.pi * 7.0 * time)])
    path = tmp_path_factory.mktemp("shaken") / "base.csv"
    np.savetxt(path, record, delimiter=",", header="time_s,x_m_s2,y_m_s2", comments="")
    return scene_of(march=FOLLOWS, quake={"file": str(path)})


@pytest.fixture(scope="module")
def through(scene):
    return carried(scene)


def started(scene, **how):
    run = run_of(scene, scene_model(scene, Path()), threads=how.pop("threads", 1))
    if how:
        run.engine = Engine(run.engine.model, **how)
    return run


def carried(scene, chunk=None, **how):
    run = started(scene, **how)
    while not run.done:
        run.go(until=None if chunk is None else run.engine.step + chunk)
    return run


def same(one, other):
    assert np.array_equal(one.engine.bodies.rows[: one.engine.n], other.engine.bodies.rows[: other.engine.n])
    assert np.array_equal(one.recording.window, other.recording.window)
    for name in ("window_time", "steps", "happened", "discharge_time"):
        assert getattr(one.recording, name) == getattr(other.recording, name), name


def test_a_step_is_shortened_at_once_and_lengthened_by_a_twentieth_at_least():
    pace = Pace(share=0.5, ticks=20, longest=40)
    assert pace.after(20, 39.0) == 19
    assert pace.after(20, 41.9) == 20
    assert pace.after(20, 42.0) == 21
    assert pace.after(20, 1e3) == 40
    assert pace.after(30, 1e3, filling=True) == 20
    assert pace.after(20, 1.0) == 1
    assert following(0.5).share == 0.5 * following().share


def test_the_step_changes_and_the_run_comes_to_its_end(through):
    ticks = [ticks for _, ticks in through.recording.steps]
    assert ticks[0] == TICKS < max(ticks)
    assert not through.trouble
    assert through.dropped > 0.0
    assert steps_made(through) < through.engine.step / TICKS
    assert whole_windows(through).all()
    assert len(through.recording.window) == 20


@pytest.mark.parametrize("how", [{"threads": 2}, {"skin": 0.004}, {"chunk": 1237}])
def test_any_threads_skin_and_chunk(through, scene, how):
    same(carried(scene, **how), through)


def test_restart_just_after_a_change(through, scene):
    """The step past is another there than the step to come."""
    begun, other = started(scene), started(scene, threads=2)
    begun.go(until=through.recording.steps[1][0])
    assert begun.engine.past != begun.engine.ticks
    other.restore(pickle.loads(pickle.dumps(begun.checkpoint())))
    other.go()
    same(other, through)


def test_the_cube_tells_the_steps(through, scene):
    cube = cube_of(through, scene)
    assert cube.attrs["steps"] == steps_made(through)
    assert cube["step_from_then"].values[0] == cube.attrs["time_step_s"]
    spans = np.diff(cube["step_time"].values, append=through.engine.time)
    assert (spans / cube["step_from_then"].values).sum() == pytest.approx(cube.attrs["steps"], rel=1e-9)


def test_the_energy_balance_holds_where_steps_change(scene):
    booked = carried(scene.model_copy(update={"record": scene.record.model_copy(update={"energy": True})}))
    energy = np.array(booked.recording.energy)
    assert len(booked.recording.steps) > 1
    assert np.ptp([balance(entries) for entries in energy]) < 1e-12 * np.abs(energy).max()
    assert (np.abs(energy[:, BASE]).max() > 1e-3) == (scene.quake is not None)


def test_a_scene_that_does_not_ask_keeps_its_step():
    run = started(scene_of())
    run.go(until=400)
    assert run.engine.model.pace is FIXED
    assert run.recording.steps == [(0, 1)]
    assert "step_from_then" not in cube_of(run, scene_of())


def test_velocity_verlet_falls_exactly_whatever_its_steps():
    """A constant pull is followed exactly: half a kick first, and the mean of both steps where they change."""
    model = free([0.0], [0.0], gravity=(0.0, -GRAVITY), dt=TICK, integrator="velocity-verlet", pace=Pace(0.5, 8, 40))
    engine = Engine(model)
    for ticks, stop in ((8, 800), (21, 5000), (3, 5600), (40, 9590)):
        engine.take_steps_of(ticks)
        engine.step_to(stop)
    assert engine.step > 9590  # it ends with a step
    assert engine.column(Y)[0] == pytest.approx(-0.5 * GRAVITY * engine.time**2, rel=1e-12)
    assert engine.column(V)[0] == pytest.approx(-GRAVITY * engine.time, rel=1e-12)


def test_a_step_takes_the_base_motion_of_when_it_begins():
    """A disc alone in a box that rings: its speed is the sum of the accelerations that its steps began with."""
    quake = np.random.default_rng(1).normal(size=(3001, 2))
    engine = Engine(free([0.0], [0.0], dt=TICK, quake=quake, pace=Pace(0.5, 8, 40)))
    gained, tick = np.zeros(2), 0
    for ticks, stop in ((8, 800), (21, 1640), (3, 1940), (40, 2940)):
        engine.take_steps_of(ticks)
        engine.step_to(stop)
        gained -= ticks * TICK * quake[tick:stop:ticks].sum(axis=0)
        tick = stop
    assert engine.step == tick
    assert [engine.column(lane)[0] for lane in (U, V)] == pytest.approx(gained, rel=1e-12)


def test_a_spring_stretches_by_the_way_of_the_step_before():
    """A disc drifts along another's side, both far too heavy to be turned from their way."""
    model = free([0.0, 0.0199], [0.0, 0.0], v=[0.0, 1e-3], density=1e12, dt=TICK, pace=Pace(0.5, 8, 40))
    engine = Engine(model)
    engine.step_to(8)  # it touches, and its spring stretches by a step before it has moved
    for ticks, stop in ((8, 800), (40, 1600), (3, 2200)):
        engine.take_steps_of(ticks)
        engine.step_to(stop)
    pairs, _ = engine.take_memories()
    stiffness = model.pair_contact.coefficients["tangential_stiffness"]
    last = 8 + engine.step - engine.past  # forces of the last step were of where it began
    assert abs(pairs.stored).max() == pytest.approx(stiffness * 1e-3 * last * TICK, rel=1e-6)


def test_a_window_weighs_forces_by_their_steps():
    """A disc falls onto nothing for most of a window: its mean is over time, not over steps."""
    model = silo(across=8, height=0.2)
    engine = Engine(replace(model, dt=model.dt / 8.0, pace=Pace(0.5, 8, 40)))
    engine.step_to(80_000)
    engine.clear_window()
    start = engine.step
    for ticks, stop in ((8, start + 800), (2, start + 1200), (8, start + 3200)):
        engine.take_steps_of(ticks)
        engine.step_to(stop)
    mean = engine.record.window[:, 0, 0].sum() * engine.ticks / (engine.step - start)
    assert mean == pytest.approx(engine.record.now[:, 0].sum(), rel=1e-3)


@pytest.mark.parametrize(
    ("march", "more", "said"),
    [
        ({"step_s": 1e-5}, {}, "march.step_s = .*: must be left out: step: follow chooses the time step"),
        ({"beyond_stability": True}, {}, "march.beyond_stability = True: must be left out: step: follow chooses"),
        ({"step": "follows"}, {}, "'fixed', 'follow' or 'longer_at_rest'"),
        ({}, {"accuracy": {"wall_force": 0.1}}, "march.step = 'follow': give either accuracy or this"),
    ],
)
def test_what_does_not_go_with_it_is_refused(march, more, said):
    with pytest.raises(BadInput, match=said):
        scene_of(march=FOLLOWS | march, **more)
