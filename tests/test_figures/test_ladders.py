"""What settings change in means of fillings, found again in cubes that were made so."""

import numpy as np
import pytest

from silostudy.figures.ladders import _unseen, changed, ladders
from tests.test_figures.small_cubes import ladder_cube


@pytest.fixture
def table():
    return ladders(ladder_cube("spheres-ladders"))


def test_a_change_is_that_of_the_means_with_its_interval():
    random = np.random.default_rng(1)
    kept = []
    for _ in range(400):
        base, other = 2.0 + 0.1 * random.normal(size=6), 2.2 + 0.2 * random.normal(size=6)
        change, half = changed(other, base)
        kept.append(abs(change - 0.1) <= half)
    assert 0.92 < np.mean(kept) < 0.98
    assert changed(np.array([2.2, np.nan, 2.2]), np.array([2.0, 2.0, 2.1])) == pytest.approx(
        (2.2 / (6.1 / 3) - 1, 0.0705), rel=1e-2
    )


def test_every_setting_stands_in_every_panel_and_laws_apart(table):
    assert len(table) == 3 * 18
    assert set(table[table["model"]]["setting"]) == {title for title in table["setting"] if title.startswith("law: ")}
    assert len(set(table[table["model"]]["setting"])) == 4
    first = table[table["setting"] == "as the others are held against"]
    assert (first["change"] == 0.0).all()
    assert (first["low"] < 0.0).all()
    assert (first["low"] == -first["high"]).all()


def test_a_setting_that_shows_nothing_is_named(table):
    made = ladder_cube("spheres-ladders").copy(deep=True)
    made["mean_mass_flow"][3] = np.nan
    seen = ladders(made)
    assert _unseen(table) == []
    assert _unseen(seen) == ["Not come to rest, or not flowing in time: an eighth of the step (mass flow)."]
    assert seen["change"].isna().sum() == 1
