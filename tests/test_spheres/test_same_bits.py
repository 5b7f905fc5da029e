"""The same scene of spheres gives the same bits, however it is carried out."""

import numpy as np
import pytest

from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.engine import Engine
from tests.test_spheres.scenes import RADIUS, heap, rows, same, spheres, stepped

pytestmark = pytest.mark.long
STEPS = 6000


@pytest.fixture(scope="module")
def reference():
    return stepped(Engine(heap()), STEPS)


def test_the_scene_moves(reference):
    assert np.abs(reference[0][:, 3:]).max() > 0.1
    assert reference[1][:, :, 0].any(axis=0).all()  # all three components are felt


@pytest.mark.parametrize("skin", [0.05, 0.5, 1.5])
def test_any_skin(reference, skin):
    assert same(stepped(Engine(heap(), skin=skin * RADIUS), STEPS), reference)


@pytest.mark.parametrize("threads", [2, 3])
def test_any_number_of_threads(threads):
    model = heap(layers=60)  # more than one block of spheres a thread
    assert same(stepped(Engine(model, threads=threads), 3000), stepped(Engine(model), 3000))


def test_any_chunk_of_steps(reference):
    engine = Engine(heap())
    for step in range(0, STEPS, 37):
        engine.step_to(step)
    assert same(stepped(engine, STEPS), reference)


@pytest.mark.parametrize("stop", [1237, 4000])
def test_restart_from_a_checkpoint(reference, stop):
    before, after = Engine(heap()), Engine(heap(), threads=2)
    before.step_to(stop)
    restore(after, checkpoint(before))
    assert same(stepped(after, STEPS), reference)
    assert same(stepped(before, STEPS), reference)  # taking a checkpoint disturbs nothing


def test_observers_change_no_bit(reference):
    assert np.array_equal(stepped(Engine(heap(watched=False)), STEPS)[0], reference[0])


def test_unequal_spheres_of_nearly_equal_size_move_alike():
    """A sphere a hair larger, far away from all others, calls for the lists of radii."""
    model, alone = heap(), {"x": 0.5, "y": 0.5, "z": 0.5, "radius": RADIUS * (1.0 + 1e-9)}
    columns = {name: np.append(getattr(model, name), alone.get(name, 0.0)) for name in model.columns}
    many, fewer = Engine(heap(**columns)), Engine(model)
    assert many.model.unequal
    for engine in (many, fewer):
        engine.step_to(2000)
    assert np.allclose(rows(many)[:-1], rows(fewer), rtol=1e-9, atol=1e-12)


def test_thousands_of_small_spheres_near_a_great_one_are_all_listed():
    """A shell of them in touch with one fifty times as large: half of them come after it, more than there was room for."""
    count, great = 3000, 50.0 * RADIUS
    share, turn = (np.arange(count) + 0.5) / count, np.pi * (1.0 + 5.0**0.5) * np.arange(count)
    outward = np.column_stack([np.cos(turn) * np.sin(np.arccos(1 - 2 * share)), np.sin(turn) * np.sin(np.arccos(1 - 2 * share)),
                               1 - 2 * share])  # fmt: skip
    place = np.array([0.0, 0.0, 1.0]) + np.vstack([np.zeros(3), (great + RADIUS) * 0.9999 * outward])
    engine = Engine(spheres(place, radius=np.append(great, np.full(count, RADIUS)), dt=1e-7))
    engine.step_to(1)
    (part,), largest = engine.parts, int(np.argmax(engine.radius))
    listed = part.pairs.begin[engine.blocks_of(part)]
    pairs = np.column_stack([part.pairs.first[:listed], part.pairs.second[:listed]])
    partners = pairs[(pairs == largest).any(axis=1)].sum(axis=1) - largest
    assert sorted(partners) == [number for number in range(count + 1) if number != largest]
