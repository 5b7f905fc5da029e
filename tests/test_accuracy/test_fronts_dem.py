"""The front of discrete-element scenes: its choice is tried on fillings of silos that it was not measured on."""

from itertools import pairwise

import numpy as np
import pytest

from silostudy.accuracy import fronts_dem
from silostudy.choice.dem import scene_traits
from silostudy.choice.fronts import FRONTS
from silostudy.config.dem import DemScene

ROWS = [row for row in FRONTS if row.kind == "dem"]


def test_silos_lie_where_the_shipped_rows_hold_and_no_trial_repeats_one():
    measured, unseen = (list(fronts_dem.silos(seed, 16)) for seed in (0, 1))
    assert not any(one in measured for one in unseen)
    for content in measured + unseen:
        traits = scene_traits(DemScene.model_validate(content))
        assert all(row.holds(traits) for row in ROWS)


def test_shipped_errors_fall_with_the_step():
    steps = {row.settings: row.error for row in ROWS}
    assert len(steps) >= 8
    assert max(steps.values()) > 10 * min(steps.values())


def test_a_step_one_rung_too_short_costs_less_than_half_as_much_again():
    """Else the cheapest that would do is missed by the ladder alone, however well its error is known."""
    for factors in fronts_dem.COARSE.values():
        assert all(1.0 < long / short < 1.5 for long, short in pairwise(factors))


@pytest.fixture
def small(monkeypatch):
    """One unseen silo on few rungs."""
    content = min(fronts_dem.silos(1, fronts_dem.UNSEEN), key=lambda one: one["packing"]["fill_height_m"])
    monkeypatch.setattr(fronts_dem, "silos", lambda seed, count: [content])
    monkeypatch.setattr(fronts_dem, "COARSE", {"17-18": fronts_dem.STEPS[:5:2], "velocity-verlet": (1.0,)})
    return content


@pytest.mark.long
def test_errors_come_from_fillings_and_fall_with_the_step(small):
    found = fronts_dem.measured(small, fronts_dem.COARSE, 1 / 16, range(4))
    assert set(found.error) == {("17-18", 1.0), ("17-18", 0.5), ("17-18", 0.25), ("velocity-verlet", 1.0)}
    assert all(len(set(errors)) == 4 for errors in found.error.values())
    means = [found.error["17-18", factor].mean() for factor in (1.0, 0.25)]
    assert means[1] < 0.6 * means[0]
    assert found.error_kept(("17-18", 1.0)) <= found.error["17-18", 1.0].max()


@pytest.mark.long
def test_steps_that_are_longer_at_rest_err_as_short_ones_do(monkeypatch):
    """In a silo whose small gaps let no disc fall far; so may a reference's steps be longer at rest."""
    content, short, fine = next(fronts_dem.silos(0, 1)), ("17-19", 1 / 16), ("velocity-verlet", fronts_dem.FINEST["trial"])
    longer = [[fronts_dem.forces(content, one, seed)[0] for seed in range(5)] for one in (short, fine)]
    plain = fronts_dem.march_of
    monkeypatch.setattr(fronts_dem, "march_of", lambda setting: plain(setting) | {"step": "fixed"})
    fixed = [[fronts_dem.forces(content, one, seed)[0] for seed in range(5)] for one in (short, fine)]
    error, error_fixed, of_reference = (
        np.mean([np.abs(a - b).max() / b.max() for a, b in zip(forces, fixed[1], strict=True)])
        for forces in (longer[0], fixed[0], longer[1])
    )
    assert error < 1.5 * error_fixed
    assert of_reference < 0.002


@pytest.mark.long
def test_why_a_slider_that_drops_its_dashpot_may_not_ask():
    """In this silo an eighth of the step leaves a tenth of the error with the measured laws, and most of it with that one."""
    content = next(fronts_dem.silos(1, 1))
    dropping = content | {body: content[body] | {"tangential": "spring-slider"} for body in ("discs", "walls")}
    left = []
    for one in (content, dropping):
        error = fronts_dem.measured(one, {"17-18": (1.0, 0.125)}, 1 / 32, range(6)).error
        left.append(error["17-18", 0.125].mean() / error["17-18", 1.0].mean())
    assert left[0] < 0.2
    assert left[1] > 0.4


@pytest.mark.long
def test_an_unseen_silo_is_tried(small):
    """Every error and cost comes from runs of its own; the whole trial is `silostudy fronts --trial`."""
    found = fronts_dem.trials(lambda text: None, 1, 4)
    assert len(found) == 4 * fronts_dem.ASKS
    for trial in found:
        assert trial.met == (trial.error <= trial.asked)
    errors_by_asked = {trial.asked: {one.error for one in found if one.asked == trial.asked} for trial in found}
    assert len(errors_by_asked) == fronts_dem.ASKS
    assert {len(errors) for errors in errors_by_asked.values()} == {4}
    for asked, errors in errors_by_asked.items():
        cheapest, cost = next((one.cheapest, one.cost) for one in found if one.asked == asked)
        assert cheapest <= cost or max(errors) > asked
