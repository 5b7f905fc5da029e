"""Several kinds of discs in one scene: how many of each, of which size, and what pairs of them do."""

import numpy as np
import pytest

from silostudy.compute.dem import scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.config.dem import DemScene
from silostudy.config.load import validated
from silostudy.dem.contacts import Contact
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput
from tests.conftest import ROOT
from tests.test_dem.small import SMALL, carried, scene_of

STONES = {"radius_m": 0.005, "density_kg_m3": 4000, "number_share": 0.25}


def model_of(**changes):
    return scene_model(scene_of(**({"other_grains": {"stones": STONES}, "march__step_s": 1e-5} | changes)), ROOT)


def test_numbers_radii_and_densities():
    model = model_of()
    stones = model.kind == 1
    assert stones.sum() == round(0.25 * len(model.x))
    assert set(model.radius[stones]) == {0.005}
    assert set(model.radius[~stones]) == {0.01}
    assert model.mass[stones] == pytest.approx(4000.0 * np.pi * 0.005**2)
    assert np.array_equal(model.place, model_of(other_grains={}).place)  # they take places of the packing


def test_shares_of_mass():
    model = model_of(other_grains={"stones": {**STONES, "number_share": None, "mass_share": 0.1}})
    assert model.mass[model.kind == 1].sum() / model.mass.sum() == pytest.approx(0.1, abs=0.005)


def test_kinds_that_push_alike_have_one_set_of_coefficients():
    model = model_of()
    assert isinstance(model.pair_contact, Contact)
    assert isinstance(model.wall_contact, Contact)


def test_what_pairs_say():
    pairs = [
        {"between": ["stones", "grain"], "sliding_friction": 0.3},
        {"between": ["stones", "floor"], "sliding_friction": 0.4},
        {"between": ["walls", "grain"], "sliding_friction": 0.1},
    ]
    model = model_of(pairs=pairs, surfaces={"left": {"sliding_friction": 0.2}})
    friction = [[model.between(a, b).coefficients["sliding_friction"] for a in (0, 1)] for b in (0, 1)]
    assert friction == [[0.577, 0.3], [0.3, 0.577]]
    at = {
        wall.name: [model.at_wall(kind, number).coefficients["sliding_friction"] for kind in (0, 1)]
        for number, wall in enumerate(model.walls)
    }
    assert at["floor"] == at["floor_left"] == [0.1, 0.4]
    assert at["left"] == [0.2, 0.2]
    assert at["right"] == [0.1, 0.176]
    assert isinstance(model.pair_contact, Varied)


WRONG = {
    "no share": (
        {"stones": {**STONES, "number_share": None}},
        (),
        "other_grains.stones: give either mass_share or number_share",
    ),
    "a taken name": ({"walls": STONES}, (), "other_grains.walls: the name is taken"),
    "no rest": ({"stones": STONES, "dust": {**STONES, "number_share": 0.8}}, (), "adds up to 1.05"),
    "a pair of none": ({}, [{"between": ["stnes", "left"]}], "pairs.0.between = .*: names no kind of grains; known: grain"),
    "an unknown surface": ({}, [{"between": ["grain", "roof"], "sliding_friction": 0.1}], "roof.*known: grain, floor"),
    "a surface's name": ({"left": STONES}, (), "other_grains = 'left': is a kind of grains and a surface"),
    "too few": ({"stones": {**STONES, "number_share": 1e-4}}, (), "leave none to stones"),
}


@pytest.mark.parametrize("case", WRONG)
def test_bad_kinds(case):
    others, pairs, told = WRONG[case]
    with pytest.raises(BadInput, match=told):
        scene_model(validated(DemScene, {**SMALL, "other_grains": others, "pairs": pairs}, "small.yaml"), ROOT)


def test_a_file_does_not_tell_kinds():
    with pytest.raises(BadInput, match="a file of discs does not tell their kinds"):
        scene_of(other_grains={"stones": STONES}, packing={"kind": "given", "file": "no.nc"})


@pytest.mark.long
def test_a_kind_like_the_other_changes_no_bit():
    like = {"radius_m": 0.01, "density_kg_m3": 2650, "mass_share": 0.5}
    scene = scene_of(other_grains={"twin": like})
    cube, plain = cube_of(carried(scene), scene), cube_of(carried(scene_of()), scene_of())
    assert np.array_equal(cube["disc_x"], plain["disc_x"], equal_nan=True)
    assert abs(cube["disc_kind"].to_numpy().sum() - 0.5 * cube.sizes["disc"]) < 1.0
    assert cube.attrs["grain_kinds"] == "grain, twin"
