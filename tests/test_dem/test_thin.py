"""Bodies that leave are taken out of the wide list, which goes on, and what comes of it is the same to the bit."""

from collections.abc import Callable

import numpy as np
import pytest

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.dem.change import keep_discs
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model

from .scenes import rows, silo


def heap() -> Model:
    return silo(across=20, height=0.3, slit=0.12)


def ball_bin() -> Model:
    return bin_of_spheres(Bin(count=600, wide=0.03))


def thinned(model: Model, forget: Callable[[Engine], None]) -> Engine:
    """An engine that loses every tenth body at steps 300, 400 and 500."""
    engine = Engine(model)
    for stop in (300, 400, 500):
        engine.step_to(stop)
        keep_discs(engine, np.arange(engine.n) % 10 != 3)
        forget(engine)
    engine.step_to(1500)
    return engine


def forget_wide(engine: Engine) -> None:
    engine.blocks.wide_travel[:] = np.inf


@pytest.mark.parametrize("model", [heap, ball_bin])
def test_a_thinned_list_gives_the_bits_of_one_made_anew(model):
    one, other = thinned(model(), lambda engine: None), thinned(model(), forget_wide)
    assert len(rows(one)) < 0.75 * len(model().radius)
    assert np.array_equal(rows(one), rows(other))


@pytest.mark.parametrize("model", [heap, ball_bin])
def test_a_thinned_list_holds_all_that_is_near_and_goes_on(model):
    engine = thinned(model(), lambda engine: None)
    keep_discs(engine, np.arange(engine.n) % 10 != 3)
    blocks = engine.blocks_of(engine.parts[0])
    ways = engine.blocks.wide_travel[:blocks].copy()
    engine.step_to(engine.step)  # lists the contacts
    assert ways.max() > 0.0
    assert (engine.blocks.wide_travel[:blocks] >= ways).all()  # a new list would begin at none
    listed = pairs_of(engine)
    forget_wide(engine)
    engine.give_memories(*engine.take_memories())
    engine.step_to(engine.step)
    assert np.array_equal(listed, pairs_of(engine))
    assert listed.shape[1] > 20


def pairs_of(engine: Engine) -> np.ndarray:
    """Listed pairs of bodies, without what pads the list."""
    pairs = engine.parts[0].pairs
    end = pairs.begin[engine.blocks_of(engine.parts[0])]
    listed = np.stack([pairs.first[:end], pairs.second[:end]])
    return listed[:, listed[0] < engine.n]
