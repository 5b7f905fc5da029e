"""Prices of means by the error asked for: fillings for the scatter, and no setting below what it is surely off."""

import numpy as np
import pytest

from silostudy.errors import BadInput
from silostudy.figures.price_of_means import ASKED, MARKED, prices, steps_of
from tests.test_figures.made_scenes import ladder_cube

FIRST, FINEST, SOFT = "as the others are held against", "an eighth of the step", "modulus 1 MPa"


def cube(first=1.0, soft=1.0, scatter=0.1):
    """A cube whose mass flow scatters by so much, with other means of the first and of the softest setting."""
    made = ladder_cube("spheres-ladders").copy(deep=True)
    mean = np.ones((made.sizes["setting"], 1))
    names = list(made["setting_title"].values)
    mean[names.index(FIRST)], mean[names.index(SOFT)] = first, soft
    spread = scatter * np.sqrt(5.0 / 6.0) * np.array([-1.0, 1.0, -1.0, 1.0, -1.0, 1.0])
    made["mean_mass_flow"] = ("setting", "filling"), mean * (1.0 + spread)
    return made


def flow_of(made):
    table = prices(made)
    return table[table["quantity"] == "mean_mass_flow"].set_index(["setting", "asked"])


def test_a_mean_costs_its_scatter_squared_over_the_error_squared():
    made = cube()
    flow, steps = flow_of(made), steps_of(made)
    assert steps[0] == pytest.approx(2000 * 0.5 / 1e-5)
    for asked in MARKED:
        row = flow.loc[(FIRST, asked)]
        assert row["fillings"] == np.ceil((1.96 * 0.1 / asked) ** 2)
        assert row["particle_steps"] == row["fillings"] * steps[0]
        assert row["surely_off"] == 0.0


def test_a_setting_that_is_surely_off_never_reaches_below_it():
    flow = flow_of(cube(soft=1.1, scatter=0.005))
    off = flow.loc[SOFT]["surely_off"].iloc[0]
    assert 0.08 < off < 0.1
    assert flow.loc[SOFT].index.min() > off
    assert flow.loc[FIRST].index.min() == ASKED[-1]


def test_every_ladder_stands_on_the_first_setting_in_what_it_does_not_vary():
    """The first alone is off by 5 %: finer steps are of its modulus and size, and the other two ladders do not see them."""
    flow = flow_of(cube(first=1.05, scatter=0.002))
    assert 0.04 < flow.loc[FINEST]["surely_off"].iloc[0] / 2.0 < 0.05
    assert 0.04 < flow.loc[FIRST]["surely_off"].iloc[0] / 3.0 < 0.05


def test_the_cheapest_setting_is_one_for_each_error():
    table = prices(cube())
    least = table[table["cheapest"]].groupby(["quantity", "asked"])["particle_steps"]
    assert (least.max() == least.min()).all()
    assert set(table["setting"]) == {name for name in table["setting"] if not name.startswith(("law: ", "restitution"))}


def test_a_setting_that_shows_nothing_has_no_price():
    made = cube()
    made["mean_mass_flow"][list(made["setting_title"].values).index(SOFT)] = np.nan
    flow = flow_of(made)
    assert SOFT not in flow.index.unique(0)
    assert FIRST in flow.index.unique(0)


def test_a_study_without_ladders_says_so():
    made = cube().drop_vars(["setting_step_factor", "setting_softened_modulus", "setting_diameter"])
    with pytest.raises(BadInput, match="varies none of step_factor, softened_modulus, diameter"):
        prices(made)
