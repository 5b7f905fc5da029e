"""The front of discrete-element scenes: its choice is tried on silos that it was not measured on."""

import numpy as np

from silostudy.accuracy import fronts_dem


def test_an_unseen_silo_is_tried(monkeypatch):
    """One small silo: every error and cost comes from runs of its own; the whole trial is `silostudy fronts --trial`."""
    small = next(iter(sorted(fronts_dem.silos(1, fronts_dem.UNSEEN), key=lambda model: len(model.x))))
    measured = list(fronts_dem.silos(0, fronts_dem.MEASURED))
    assert not any(len(model.x) == len(small.x) and np.array_equal(model.x, small.x) for model in measured)
    monkeypatch.setattr(fronts_dem, "silos", lambda seed, count: [small])
    found = fronts_dem.trials(lambda text: None, 1)
    assert [trial.asked for trial in found] == list(fronts_dem.ASKED)
    for trial in found:
        assert trial.met == (trial.error <= trial.asked)
        assert trial.cheapest <= trial.cost or not trial.met
