"""How many fillings a mean needs: the error told is kept, and no more are asked for than the scatter calls for."""

import numpy as np
import pytest

from silostudy.accuracy.certificates import WAYS, made_up, trials_of_means
from silostudy.choice.means import MOST, enough, mean_bound


def test_the_bound_of_many_values_is_that_of_a_normal_mean():
    values = 5.0 + 0.5 * np.random.default_rng(0).normal(size=10_000)
    assert mean_bound(values, 0.1) == pytest.approx(1.96 * 0.1 / 100.0, rel=0.02)


def test_few_values_lean_on_the_scatter_expected():
    values = np.array([1.0, 1.0, 1.0])
    assert mean_bound(values, 0.2) == pytest.approx(2.0 * mean_bound(values, 0.1), rel=1e-12)
    assert mean_bound(values, 0.2) > 0.1
    assert mean_bound(np.ones(100), 0.2) < 0.01


def test_95_percent_of_means_keep_their_bound():
    random = np.random.default_rng(1)
    kept = []
    for scatter in np.exp(random.uniform(np.log(0.01), np.log(0.3), 2000)):
        values = 1.0 + scatter * random.normal(size=random.integers(2, 12))
        kept.append(abs(values.mean() - 1.0) / abs(values.mean()) <= mean_bound(values, scatter))
    assert 0.94 < np.mean(kept) < 0.985


def test_a_tenth_more_at_a_time_and_none_where_it_is_met():
    values = np.array([0.8, 1.2, 0.9, 1.1])
    assert enough(values, 1e-3, 0.2) == 5
    assert enough(values, 0.9, 0.2) == 4
    assert enough(np.tile(values, 10), 1e-3, 0.2) == 44
    assert enough(np.tile(values, 10), 0.98 * mean_bound(np.tile(values, 10), 0.2), 0.2) == 42  # by 1 / 0.98^2
    assert enough(np.tile(values, MOST // 4), 1e-6, 0.2) == MOST


def test_front_then_certificate_is_the_cheapest_way_that_keeps_what_is_asked():
    """Of 1000 scenes made up: the shipped way keeps as much as runs that know nothing beforehand, and costs the least."""
    tried = trials_of_means(made_up(seed=2, count=1000))
    met, cost = {}, {}
    for way in WAYS:
        trials = [trial for name, trial in tried if name == way]
        met[way] = np.mean([trial.met for trial in trials])
        cost[way] = np.mean([trial.cost / trial.cheapest <= 1.5 for trial in trials])
    assert min(met.values()) > 0.93
    assert cost["front then certificate"] > max(0.87, cost["certificate"] + 0.05, cost["front"] + 0.3)
