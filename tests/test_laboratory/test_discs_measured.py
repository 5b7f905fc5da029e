"""A small laboratory of discs that are really pressed, sheared, drained and dropped: what must come out of any."""

import numpy as np
import pytest

from tests.test_laboratory.made_up import DISCS, of_discs
from tests.test_laboratory.measured import check_balanced, check_bits, measured

pytestmark = pytest.mark.long
LEVEL = 9.81 * 1350.0  # N/m3: of discs without voids
SLIPPERY = DISCS["scene"]["discs"] | {"sliding_friction": 0.05}


def numbers(case=0, **changes):
    """The numbers of a cell 64 grains wide under 2 kPa."""
    return measured(of_discs(**({"cells": [64], "fillings": 2, "stresses_kPa": [2]} | changes)), case)


@pytest.fixture(scope="module")
def usual():
    return numbers()


def test_a_cell_is_in_balance_under_the_stress_asked_for(usual):
    check_balanced(usual, within=0.01)


def test_a_plate_s_friction_is_the_law_s_at_most_and_near_it(usual):
    assert 0.23 < usual["wall_steady_shear_ratio"][0] <= 0.25
    assert usual["wall_peak_shear_ratio"][0] <= 0.25 * (1.0 + 1e-6)


def test_pressed_discs_are_denser_and_no_denser_than_a_triangular_grid(usual):
    assert usual["loose_unit_weight"] < usual["tested_unit_weight"][0] < LEVEL * np.pi / (2.0 * np.sqrt(3.0))


def test_the_lateral_pressure_ratio_lies_between_yield_and_no_friction(usual):
    sine = np.sin(np.arctan(usual["internal_peak_shear_ratio"][0]))
    assert (1.0 - sine) / (1.0 + sine) < usual["tested_lateral_pressure_ratio"][0] < 1.0


def test_internal_friction_rises_with_that_of_the_discs(usual):
    slippery = numbers(scene__discs=SLIPPERY)
    for name in ("internal_peak_shear_ratio", "internal_steady_shear_ratio"):
        assert 0.0 < slippery[name][0] + 0.03 < usual[name][0], name


def test_a_dropped_disc_comes_back_as_asked(usual):
    assert usual["tested_restitution"] == pytest.approx(0.5, abs=0.005)


def test_heap_and_crater_are_slopes_of_loose_grains(usual):
    for name in ("tested_repose_angle", "tested_drawn_angle"):
        assert np.radians(8.0) < usual[name] < np.radians(35.0), name


def test_the_same_filling_gives_the_same_bits_and_another_does_not(usual):
    check_bits(usual, numbers(), numbers(case=1))
