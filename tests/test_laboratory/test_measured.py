"""Small laboratories that are really pressed and sheared: what must come out of any, and what friction does to it."""

import numpy as np
import pytest

from silostudy.compute import laboratory
from silostudy.errors import BadInput
from tests.test_laboratory.made_up import ROLLING, expansion
from tests.test_laboratory.measured import check_balanced, check_bits, measured

pytestmark = pytest.mark.long
PLAIN = {"cells": [8], "fillings": 2, "stresses_kPa": [20]}


def numbers(case=0, **changes):
    """The numbers of a cell 8 grains wide under 20 kPa."""
    return measured(expansion(**(PLAIN | changes)), case)


@pytest.fixture(scope="module")
def usual():
    return numbers()


def test_a_cell_is_in_balance_under_the_stress_asked_for(usual):
    check_balanced(usual, within=1e-3)


def test_a_plate_s_friction_is_the_law_s_and_below_that_inside(usual):
    assert usual["wall_steady_shear_ratio"] == pytest.approx([0.2], rel=0.06)
    assert usual["wall_steady_shear_ratio"] < usual["internal_steady_shear_ratio"]


def test_a_dropped_grain_comes_back_as_asked(usual):
    # 0.293 at the step that the scene chooses by itself, 0.299 at a tenth of it
    assert usual["tested_restitution"] == pytest.approx(0.3, abs=0.01)
    assert usual["asked_restitution"] == 0.3


def test_what_is_drained_stays_steeper_than_what_is_poured(usual):
    assert usual["tested_drawn_angle"] > usual["tested_repose_angle"]
    assert np.radians(10.0) < usual["tested_drawn_angle"] < np.radians(45.0)


def test_pressed_grains_are_denser_and_bear_on_the_wall_less_than_on_the_lid(usual):
    assert usual["loose_unit_weight"] < usual["tested_unit_weight"][0] < 0.74 * 9.81 * 1350
    assert 0.25 < usual["tested_lateral_pressure_ratio"][0] < 0.9
    assert (np.diff(usual["path_horizontal_stress"]) > -100.0).all()


def test_the_same_filling_gives_the_same_bits_and_another_does_not(usual):
    check_bits(usual, numbers(), numbers(case=1))


def test_internal_friction_rises_with_friction_and_with_rolling_friction(usual):
    slippery = numbers(scene__spheres=ROLLING | {"sliding_friction": 0.1})
    held = numbers(scene__spheres=ROLLING | {"sliding_friction": 0.45, "rolling_friction": 0.3})
    steady = [float(one["internal_steady_shear_ratio"][0]) for one in (slippery, usual, held)]
    assert steady[0] + 0.05 < steady[1]
    assert steady[1] + 0.05 < steady[2]


def test_what_is_off_is_told_in_place_of_a_number(monkeypatch):
    monkeypatch.setattr(laboratory, "OFF", 1e-9)
    with pytest.raises(BadInput, match=r"of the load on the floor: must be within 0%; .*lower inertial_number"):
        numbers()
