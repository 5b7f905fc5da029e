"""Means over as many fillings of a scene as an accuracy asks for, of runs that are made up."""

import numpy as np
import pytest

from silostudy.choice.means import MOST
from silostudy.compute.scenes_means import mean_numbers
from silostudy.compute.scenes_windows import OfFillings, Swept
from silostudy.errors import BadInput
from tests.test_dem.small import scene_of

SWEPT = Swept({}, None, "grains", {"mean_wall_force": OfFillings(lambda numbers: float(numbers["force"]), scatter=1.0)})
GRAINS = 100


def scene(asked=0.05, **changes):
    return scene_of(accuracy={"mean_wall_force": asked}, **changes)


def runs(scatter, bias=0.0):
    """A made-up run: normal about 10, and off by a bias that goes with the step; notes what was run."""
    ran = []

    def compute(scene):
        ran.append((scene.seed, scene.march.step_s))
        random = np.random.default_rng([scene.seed, round(1e9 * scene.march.step_s)])
        force = 10.0 * (1.0 + scatter * random.normal() + bias * scene.march.step_s / 2.5e-5)
        return {"force": np.array(force), "grains": np.array(GRAINS)}

    return compute, ran


def test_as_many_fillings_as_the_scatter_asks_for():
    for scatter, least, most in ((0.05, 4, 16), (0.2, 45, 75)):
        compute, ran = runs(scatter)
        numbers = mean_numbers(scene(), compute, SWEPT)
        assert least <= numbers["fillings_computed"] <= most
        assert numbers["error_bound"][0] <= 0.05
        assert numbers["error_met"][0] == 1.0
        assert len(ran) == len(set(ran))  # none twice
        whole = [seed for seed, step in ran if step == 2.5e-5]
        assert whole == list(range(int(numbers["fillings_computed"])))
        halved = [seed for seed, step in ran if step == 1.25e-5]
        assert halved == list(range(round(len(whole) / 8)))


def test_numbers_are_means_and_the_change_at_half_the_step_is_told():
    compute, ran = runs(0.1, bias=0.01)
    numbers = mean_numbers(scene(), compute, SWEPT)
    again, _ = runs(0.1, bias=0.01)
    forces = [again(scene(seed=seed))["force"] for seed, step in ran if step == 2.5e-5]
    assert numbers["force"] == pytest.approx(np.mean(forces), rel=1e-12)
    assert abs(numbers["step_change"][0] + 0.005) < 3.0 * numbers["step_change_deviation"][0]
    assert 0 <= numbers["cpu_time_on_step"] <= numbers["cpu_time"]


def test_a_step_that_shifts_the_mean_is_halved_until_it_does_not():
    compute, ran = runs(0.03, bias=0.4)
    numbers = mean_numbers(scene(asked=0.02), compute, SWEPT)
    assert min(step for _, step in ran) <= 2.5e-5 / 8
    assert abs(numbers["force"] / 10.0 - 1.0) < 0.15  # one pair of fillings sees no less than some 4 times what was asked
    compute, ran = runs(0.03, bias=0.0)
    mean_numbers(scene(asked=0.02), compute, SWEPT)
    assert min(step for _, step in ran) == 1.25e-5


def test_what_cannot_be_met_says_how_far_it_came():
    compute, _ = runs(0.5)
    numbers = mean_numbers(scene(asked=0.01), compute, SWEPT)
    assert numbers["fillings_computed"] == MOST
    assert numbers["error_met"][0] == 0.0
    assert 0.03 < numbers["error_bound"][0] < 0.06


def test_a_quantity_that_runs_do_not_show_is_told():
    def compute(scene):
        return {"force": np.array(np.nan), "grains": np.array(GRAINS)}

    with pytest.raises(BadInput, match="is not seen in a filling"):
        mean_numbers(scene(), compute, SWEPT)


def test_many_grains_are_expected_to_scatter_less():
    """The first filling alone: its bound is what was expected of it."""
    bounds = []
    for grains in (1_000_000, 4_000_000):
        numbers = mean_numbers(scene(), lambda scene, n=grains: {"force": np.array(1.0), "grains": np.array(n)}, SWEPT)
        assert numbers["fillings_computed"] == 1
        bounds.append(numbers["error_bound"][0])
    assert bounds[0] == pytest.approx(2.0 * bounds[1], rel=1e-12)
