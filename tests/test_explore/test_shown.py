"""What the explorer shows of a cube: its numbers, their scope and source."""

import numpy as np
import pytest

from silostudy.explore.picture import png
from silostudy.explore.shown import Selection, labels, numbers, overlays, quantities, usual_axis, usual_place

METHODS = ("janssen", "deutsch")


@pytest.fixture(scope="module")
def choice(wheat):
    place = labels(wheat, "phase").index("filling")
    return Selection("wall_normal_pressure", "depth", "pressure_method", METHODS, {"phase": place})


def test_depth_and_methods_come_first(wheat):
    assert next(iter(quantities(wheat).values())) == "wall_normal_pressure"
    assert usual_axis(wheat, "wall_normal_pressure") == "depth"
    assert overlays(wheat, "wall_normal_pressure", "depth")[0] == "pressure_method"
    assert labels(wheat, "phase")[usual_place(wheat, "wall_normal_pressure", "phase")] == "discharge"


def test_numbers_are_the_cube_s_with_scope_and_source(wheat, choice):
    table = numbers(wheat, choice)
    janssen = table[table.curve == "janssen"]
    expected = wheat["wall_normal_pressure"].sel(pressure_method="janssen", phase="filling")
    np.testing.assert_array_equal(janssen["wall_normal_pressure"], expected)
    assert set(janssen["scope"]) == {"in scope"}
    assert janssen["source"].str.endswith("section 4.2.2 (a)").all()
    deutsch = table[table.curve == "deutsch"]
    assert deutsch["wall_normal_pressure"].isnull().all()
    assert set(deutsch["scope"]) == {"phase not covered"}


def test_the_picture_holds_a_curve_for_each_label(wheat, choice, kept):
    png(wheat, choice, numbers(wheat, choice), "wheat")
    (axes,) = kept[0].axes
    assert [line.get_label() for line in axes.lines] == list(METHODS)
    assert axes.yaxis_inverted()
    assert axes.get_xlabel().endswith("(Pa)")
