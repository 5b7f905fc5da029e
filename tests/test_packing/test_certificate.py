"""Runs of a packing study that asks for an accuracy: as many as their own scatter calls for, and what they keep is told."""

import numpy as np
import pytest

from silostudy.choice.expand import expand_file
from silostudy.compute import packing
from tests.test_accuracy.test_fronts_packing import ONE


@pytest.fixture
def asking(tmp_path):
    import json

    path = tmp_path / "asking.yaml"
    path.write_text(json.dumps(ONE | {"discharge_s": 0.6, "accuracy": {"rest_side_share": 0.03}}))
    return expand_file(path)


@pytest.mark.parametrize(("scatter", "least", "most"), [(0.005, 2, 10), (0.1, 30, 60)])
def test_runs_are_added_until_their_scatter_allows_it(asking, monkeypatch, scatter, least, most):
    """Runs that are made up, of which the front alone takes 16; none is computed twice."""
    ran = []

    def made_up(expansion, task):
        members, run = task
        ran.append(run)
        share = 0.5 * (1.0 + scatter * np.random.default_rng(run).normal())
        return {(case, run): {packing.SHARE: share} for case in members}

    monkeypatch.setattr(packing, "_of_one_filling", made_up)
    monkeypatch.setattr(packing, "_cube", lambda expansion, runs: (runs, packing._certificate(expansion, runs)["certificate"]))
    runs, told = packing.packing_cube(asking)
    assert sorted(ran) == list(range(len(runs[0])))
    assert least <= len(runs[0]) - 1 <= most
    assert told.startswith(f"rest_side_share: asked 0.03, {len(runs[0]) - 1} runs keep 0.0")
    assert "NOT MET" not in told
