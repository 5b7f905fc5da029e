"""Wall pressures with each setting of a ladder, found again in cubes that were made so."""

import numpy as np
import pytest

from silostudy.figures.ladder_walls import DEPTHS, wall_ladders
from tests.test_figures.made_scenes import ladder_cube

MEAN_OFF = 0.02  # of chance in the means of six fillings


@pytest.fixture(scope="module")
def cube():
    return ladder_cube("spheres-ladders")


@pytest.fixture(scope="module")
def table(cube):
    return wall_ladders(cube)


def test_each_ladder_has_its_settings_from_the_least_value(table):
    settings = {name: list(dict.fromkeys(part["setting"])) for name, part in table.groupby("ladder", sort=False)}
    assert settings == {
        "time step": ["0.125 of the chosen", "0.25 of the chosen", "0.5 of the chosen", "1 of the chosen"],
        "softened modulus": ["1 MPa", "3 MPa", "10 MPa", "30 MPa", "100 MPa"],
        "size of grains": ["5 mm", "6.3 mm", "8 mm", "10 mm"],
        "restitution": ["0.1", "0.3", "0.5", "0.8"],
    }
    bases = table[table["base"]].groupby("ladder", sort=False)["setting"].first()
    assert list(bases) == ["0.125 of the chosen", "100 MPa", "5 mm", "0.5"]


def test_the_profile_is_over_the_filled_height(table):
    rest = table[(table["area"] == "") & (table["setting"] == "10 MPa")]
    assert rest["relative_depth"].tolist() == DEPTHS.tolist()
    assert rest["pressure_kPa"].values == pytest.approx(4.0 * 0.25 * DEPTHS, rel=3 * MEAN_OFF)


def test_largest_means_fall_with_their_area(table, cube):
    """One cell of the lowest level bears five times what the others do, for one window."""
    flow = table[(table["area"] != "") & (table["setting"] == "10 MPa")].set_index("area")["pressure_kPa"]
    turns, falls = cube.sizes["wall_turn"], 4.0 * 0.3 / cube.sizes["wall_level"]
    lowest = 4.0 * 0.25 - 0.5 * falls
    assert flow["1x1"] == pytest.approx(5.0 * lowest, rel=3 * MEAN_OFF)
    assert flow["ring"] / flow["1x1"] == pytest.approx((turns + 4.0) / (5.0 * turns), rel=1e-9)
    assert flow["2x2"] / flow["1x1"] == pytest.approx((8.0 * lowest - 2.0 * falls) / (20.0 * lowest), rel=1e-9)


def test_changes_are_from_the_finest(table):
    rows = table[(table["ladder"] == "time step") & (table["area"] == "ring")].set_index("setting")
    assert rows.loc["0.125 of the chosen", "change"] == 0.0
    change = rows.loc["1 of the chosen", "pressure_kPa"] / rows.loc["0.125 of the chosen", "pressure_kPa"] - 1.0
    assert rows.loc["1 of the chosen", "change"] == pytest.approx(change, rel=1e-9)
    assert rows.loc["1 of the chosen", "change_interval"] > 0.0


def test_a_setting_without_flow_shows_its_rest_alone(cube):
    still = cube.copy(deep=True)
    still["wall_pressure_in_flow"][3] = np.nan
    table = wall_ladders(still)
    rows = table[table["setting"] == "0.125 of the chosen"]
    assert (rows["pressure_kPa"].isna() == (rows["area"] != "")).all()
