"""The same scene gives the same bits, however it is carried out."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.coarse import fields_now
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.grid import Grid
from silostudy.dem.run import Run
from silostudy.dem.snapshot import pair_contacts, wall_contacts

from .scenes import rows, silo

STEPS = 6000
OPEN = (Event("time", 0.02, "open", ("floor", "floor_left", "floor_right")), Event("time", STEPS * 2.5e-5, "stop"))


@pytest.fixture(scope="module")
def reference():
    return finish(Engine(silo()))


def finish(engine, until=None):
    run = Run(engine, OPEN, limit=1.0, window=500)
    recording = run.go(until=until)
    return rows(engine), np.array(recording.window), run


def same(a, b):
    return np.array_equal(a[0], b[0]) and np.array_equal(a[1], b[1])


def test_the_scene_flows(reference):
    places, windows, run = reference
    assert run.dropped > 0.0
    assert windows[-1, :, 0, 2].max() > 0.0
    assert len(places) < len(silo().x)


@pytest.mark.parametrize("skin", [0.0005, 0.004, 0.015])
def test_any_skin(reference, skin):
    assert same(finish(Engine(silo(), skin=skin)), reference)


def read_outs(engine):
    """Contacts of discs and walls with their forces, by the discs' labels, and the fields in cells."""
    tables = [of(engine).table for of in (pair_contacts, wall_contacts)]
    grid = Grid((0.0, 0.0), (0.09, 0.09), (5, 5))
    return [*(table[np.lexsort(table.T[1::-1])] for table in tables), *fields_now(engine, grid, 0.02)]


@pytest.mark.parametrize("threads", [2, pytest.param(3, marks=pytest.mark.long)])
def test_any_number_of_threads(threads):
    # more than one block of discs a thread
    model = silo(across=20, height=0.3, slit=0.12)
    many, one = Engine(model, threads=threads), Engine(model)
    assert same(finish(many), finish(one))
    for found, expected in zip(read_outs(many), read_outs(one), strict=True):
        assert expected.any()
        assert np.array_equal(found, expected, equal_nan=True)


def test_any_chunk_of_steps():
    one, many = Engine(silo()), Engine(silo())
    one.step_to(1500)
    for step in range(0, 1501, 37):
        many.step_to(step)
    many.step_to(1500)
    assert np.array_equal(rows(one), rows(many))
    assert np.array_equal(one.record.window, many.record.window)


@pytest.mark.parametrize("stop", [137, 2500])
def test_restart_from_a_checkpoint(stop):
    through, before = Engine(silo()), Engine(silo())
    before.step_to(stop)
    after = Engine(silo(), threads=2)
    restore(after, checkpoint(before))
    for engine in (through, before, after):
        engine.step_to(4000)
    assert np.array_equal(rows(through), rows(after))
    assert np.array_equal(rows(through), rows(before))  # taking a checkpoint disturbs nothing
    assert np.array_equal(through.record.window, after.record.window)


def test_many_scenes_at_once(reference):
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: finish(Engine(silo())), range(4)))
    assert all(same(result, reference) for result in results)


def test_the_order_in_memory_does_not_touch_a_lone_pair():
    model = silo()
    a, b = Engine(model), Engine(model, sort=False)
    a.step_to(200)
    b.step_to(200)
    np.testing.assert_allclose(rows(a), rows(b), rtol=1e-9, atol=1e-12)
