"""Findings of silos of grains beside codes, of made-up pressures: what the hopper and the wall around say, and the verdicts."""

import pytest

from silostudy.figures.beside import verdict
from silostudy.figures.silo_findings import findings
from tests.test_figures.small_cubes import cube_of


@pytest.fixture(scope="module")
def table():
    return findings(cube_of("silo-of-spheres", "beside"))


def rows(table, quantity, of=None):
    """Rows of a quantity, or of those whose name begins so."""
    chosen = table[table["quantity"].str.startswith(quantity)]
    return chosen if of is None else chosen[chosen["of"] == of]


def test_the_hopper_stands_beside_every_method_that_knows_one(table):
    """The made-up hopper feels Janssen's pressures and 1 Pa: its switch is where the doubled cell is, in the second level."""
    place = rows(table, "height of the largest rise")
    assert len(place) == 6
    levels = cube_of("silo-of-spheres", "beside").sizes["wall_level"]
    assert place["mean"].to_numpy() == pytest.approx(1.5 / levels)
    cover = rows(table, "hopper pressure at the transition", "en1991_4")
    assert len(cover) == 12
    assert cover["verdict"].isin(["covers it", "does not cover it", "may cover it"]).all()
    assert rows(table, "mean pressure on the hopper", "janssen").empty


def test_a_patch_load_factor_stands_beside_the_largest_cell(table):
    """One cell feels twice its level in flow, and none any more at rest."""
    largest = rows(table, "largest cell over the mean")
    rest = largest[largest["phase"] == "filling"]["mean"].dropna()  # silos too low for deep levels have none
    assert len(rest) == 4
    assert rest.to_numpy() == pytest.approx(0.0, abs=1e-9)
    flow = largest[largest["phase"] == "discharge"]["mean"].dropna()
    assert flow.to_numpy() == pytest.approx(2.0 / (1.0 + 1.0 / 16) - 1.0)


@pytest.mark.parametrize(
    ("ends", "told"),
    [((1.0, 1.2), "covers it"), ((0.9, 1.1), "may cover it"), ((0.7, 0.9), "does not cover it"),
     ((float("nan"), 1.0), "no interval: fewer than two fillings have a value")],
)  # fmt: skip
def test_verdicts_hang_on_the_ends_of_the_interval(ends, told):
    assert verdict(*ends) == told
