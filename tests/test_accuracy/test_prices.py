"""Prices of effects: measured on one state; and a scene without an effect costs no more than a kernel written without it."""

from dataclasses import replace

import numpy as np
import pytest

from silostudy.accuracy import priced_effects
from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.instructions import count, missing
from silostudy.accuracy.price_table import COUNTED, PARTS
from silostudy.accuracy.priced_effects import SPHERES
from silostudy.accuracy.prices import FRICTION, LAW_EFFECTS, prices, still, without
from silostudy.accuracy.silo import silo_of_rows
from silostudy.commands.explain_scene import listed
from silostudy.contact import SPHERE_LAWS
from silostudy.dem.engine import Engine
from silostudy.dem.pace import FIXED, longer_at_rest
from silostudy.scene.spheres_about import sphere_effects
from silostudy.tables.effect_prices import EFFECT_PRICES
from silostudy.tables.kiyama_1983 import ACTIVE
from tests.conftest import ROOT
from tests.test_accuracy import by_hand, by_hand_spheres
from tests.test_spheres.small import scene_of as spheres_scene

MOST = 0.02  # of the instructions by hand


BY_HAND = ("friction", "no friction")


def check_bits(built, by_hand):
    """Both engines have brought their bodies to the same place, and those have moved."""
    motion = slice(by_hand.space.motion)
    rows, others = (engine.bodies.rows[: engine.n, motion] for engine in (built, by_hand))
    assert np.abs(rows[:, list(built.space.velocity)]).max() > 0
    assert np.array_equal(rows, others)


@pytest.mark.long
@pytest.mark.parametrize("name", BY_HAND)
def test_discs_by_hand_give_the_same_bits(name):
    pair = by_hand.engines(by_hand.silos(8, 12)[name])
    for engine in pair.values():
        engine.step_to(3000)
    check_bits(*pair.values())


@pytest.mark.long
@pytest.mark.parametrize("name", BY_HAND)
def test_spheres_by_hand_give_the_same_bits(name):
    pair = by_hand_spheres.engines(by_hand_spheres.bins(500)[name])
    for engine in pair.values():
        engine.step_to(20_000)
        assert engine.parts[0].pairs.begin.max() > 2 * engine.n  # they have fallen together
    check_bits(*pair.values())


def test_what_is_priced_is_a_step_and_no_tick():
    model, _ = silo_of_rows(4, 3)
    changing = still(replace(model, dt=model.dt / 16.0, pace=longer_at_rest(0.25)))
    assert changing.pace is FIXED
    assert np.array_equal(changing.x, still(model).x)


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
@pytest.mark.parametrize("module", [by_hand, by_hand_spheres], ids=["discs", "spheres"])
def test_instructions_of_the_built_kernel_beside_the_one_by_hand(module):
    counted = count(f"{module.__name__}:work", ROOT)
    assert counted.keys() == {f"{name}, {how}" for name in BY_HAND for how in ("built", "by hand")}
    for name in BY_HAND:
        assert counted[f"{name}, by hand"] > 1e7
        assert counted[f"{name}, built"] / counted[f"{name}, by hand"] < 1.0 + MOST


@pytest.fixture
def pairs(monkeypatch):
    """What is priced, of grains that have not been brought to rest."""
    loose = {"disc": silo_of_rows(ACTIVE, 4)[0], "sphere": bin_of_spheres(Bin(count=200, wide=0.03))}
    monkeypatch.setattr(priced_effects, "base", loose.__getitem__)
    return priced_effects.priced_effects()


def test_every_law_of_spheres_has_a_price(pairs):
    for family, effect in LAW_EFFECTS.items():
        for law in SPHERE_LAWS[family].values():
            if law.acts:
                whole, less = (getattr(one.pair_contact.laws, family) for one in pairs[f"{effect}: {law.key}{SPHERES}"])
                assert whole.key == law.key
                assert not less.acts


def test_what_is_priced_differs_in_nothing_else(pairs):
    """Without the effect the kernel is that of friction alone, and the grains stand where they do with it."""
    for name, (whole, less) in pairs.items():
        base = priced_effects.base("sphere" if name.endswith(SPHERES) else "disc").pieces
        assert np.array_equal(whole.place, less.place), name
        if name.startswith(FRICTION):
            assert whole.pieces.turns
            assert not less.pieces.turns
        else:
            assert less.pieces == base != whole.pieces, name


def test_the_shipped_list_has_every_effect_and_part(pairs):
    listed = [*pairs, *(part.name for part in PARTS)]
    uncounted = {part.name for part in PARTS if part not in COUNTED}
    assert list(EFFECT_PRICES) == listed
    for name, price in EFFECT_PRICES.items():
        assert np.isfinite(price.instructions) == (name not in uncounted), name


def test_effects_of_a_scene_of_spheres_are_in_the_list():
    """Those that are compiled in; a scene's outlets, inserts and events cost what bodies meet there."""
    scene = spheres_scene(record__energy=True, spheres__rolling="constant-torque", spheres__rolling_friction=0.1)
    on = [effect for effect in sphere_effects(scene) if effect.on]
    told = {effect.name: listed(effect) for effect in on}
    assert {name for name, text in told.items() if "of instructions" in text} == {
        FRICTION,
        "rolling resistance",
        "wall forces every step",
        "energy balance",
    }


def two_sums():
    """Work for the counter, a hundred times as much the second time."""
    return {"a sum (of few)": lambda: sum(range(10_000)), "a sum, of many": lambda: sum(range(1_000_000))}


@pytest.mark.long
@pytest.mark.skipif(bool(missing()), reason=missing() or "counted")
def test_every_count_belongs_to_its_name():
    few, many = count("tests.test_accuracy.test_prices:two_sums", ROOT).values()
    assert 10 < many / few < 100
