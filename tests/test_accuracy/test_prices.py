"""Prices of effects: measured on one state; and a scene without an effect costs no more than a kernel written without it."""

from dataclasses import replace

import numpy as np
import pytest

from silostudy.accuracy.instructions import count, missing
from silostudy.accuracy.price_table import scenes_of_spheres
from silostudy.accuracy.prices import prices, still, without
from silostudy.accuracy.silo import silo_of_rows
from silostudy.dem.engine import Engine
from tests.conftest import ROOT
from tests.test_accuracy import by_hand_spheres
from tests.test_accuracy.by_hand import engines, silos

MOST = 0.02  # of the instructions by hand


SILOS = ("friction", "no friction")


@pytest.mark.long
@pytest.mark.parametrize("name", SILOS)
def test_by_hand_gives_the_same_bits(name):
    pair = engines(silos(8, 12)[name])
    for engine in pair.values():
        engine.step_to(3000)
    built, by_hand = (engine.bodies.rows[: engine.n] for engine in pair.values())
    assert np.abs(built[:, 3]).max() > 0
    assert np.array_equal(built, by_hand)


@pytest.mark.long
def test_prices_compare_the_same_state():
    model, _ = silo_of_rows(8, 12)
    model = still(replace(model, watched=True, radius=model.radius * (1 - 0.001 * (np.arange(len(model.x)) % 2))))
    pairs = without(model)
    assert set(pairs) == {"friction, rotation, history", "discs of several sizes", "wall forces every step"}
    for whole, less in pairs.values():
        assert np.array_equal(whole.x, less.x)
        counts = []
        for one in (whole, less):
            engine = Engine(one)
            engine.step_to(50)
            assert np.abs(engine.places - np.c_[one.x, one.y]).max() < 1e-12
            counts.append(int(engine.parts[0].pairs.begin[engine.blocks_of(engine.parts[0]) + 1]))
        assert counts[0] == counts[1]
    assert not pairs["friction, rotation, history"][1].pieces.turns
    assert pairs["discs of several sizes"][0].pieces.unequal
    assert not pairs["discs of several sizes"][1].pieces.unequal


@pytest.mark.long
@pytest.mark.parametrize("watched", [False, True])
def test_friction_has_a_price(watched):
    """Also where wall forces are recorded: when arrays were handed from piece to piece it cost less than nothing there."""
    whole, found = prices(replace(silo_of_rows(18, 20)[0], watched=watched), turns=7)
    assert whole > 0
    price = found["friction, rotation, history"]
    assert price.low <= price.time <= price.high
    assert 0.2 < price.memory < 0.9


@pytest.mark.long
@pytest.mark.skipif(bool(missing()), reason=missing() or "counted")
def test_instructions_of_the_built_kernel_beside_the_one_by_hand():
    counted = count("tests.test_accuracy.by_hand:work", ROOT)
    assert counted.keys() == {f"{name}, {how}" for name in SILOS for how in ("built", "by hand")}
    for name in SILOS:
        assert counted[f"{name}, by hand"] > 1e7
        assert counted[f"{name}, built"] / counted[f"{name}, by hand"] < 1.0 + MOST


@pytest.mark.long
def test_spheres_by_hand_give_the_same_bits():
    pair = by_hand_spheres.engines(by_hand_spheres.smooth_spheres(500))
    for engine in pair.values():
        engine.step_to(20_000)
        assert engine.parts[0].pairs.begin.max() > 2 * engine.n  # they have fallen together
    built, by_hand = (engine.bodies.rows[: engine.n, :9] for engine in pair.values())
    assert np.abs(built[:, 5]).max() > 0
    assert np.array_equal(built, by_hand)


@pytest.mark.long
@pytest.mark.skipif(bool(missing()), reason=missing() or "counted")
def test_instructions_of_spheres_beside_a_kernel_by_hand():
    counted = count("tests.test_accuracy.by_hand_spheres:work", ROOT)
    assert counted["spheres, by hand"] > 1e7
    assert counted["spheres, built"] / counted["spheres, by hand"] < 1.0 + MOST


def test_every_family_of_laws_of_spheres_has_a_price():
    effects = set().union(*(without(model) for model in scenes_of_spheres()))
    laws = {"rolling resistance", "cohesion", "twisting resistance"}
    assert effects == {"friction, rotation, history", "wall forces every step", *laws}
    for model in scenes_of_spheres():
        for name, (whole, less) in without(model).items():
            acting = [sum(row.acts for row in one.pair_contact.rows) for one in (whole, less)]
            assert acting[1] < acting[0] or name == "wall forces every step"
            assert np.array_equal(whole.place, less.place)


def two_sums():
    """Work for the counter, a hundred times as much the second time."""
    return {"a sum (of few)": lambda: sum(range(10_000)), "a sum, of many": lambda: sum(range(1_000_000))}


@pytest.mark.long
@pytest.mark.skipif(bool(missing()), reason=missing() or "counted")
def test_every_count_belongs_to_its_name():
    few, many = count("tests.test_accuracy.test_prices:two_sums", ROOT).values()
    assert 10 < many / few < 100
