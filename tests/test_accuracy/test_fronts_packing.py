"""The front of packing studies: how many runs a mean needs, tried on a silo that it was not measured on."""

import copy

import numpy as np
import pytest

from silostudy.accuracy import fronts_packing
from silostudy.choice.packing import friction_scatter
from silostudy.compute.packing import packing_cube
from silostudy.config.load import read_yaml
from silostudy.errors import BadInput
from tests.conftest import ROOT, expanded

ONE = {
    "kind": "packing",
    "title": "t",
    "scene": {"across": 8, "disc_count": 90, "silo": {"width_m": 0.17647, "slit_width_m": 0.05}},
}


def asking(error: float, **more) -> dict:
    return copy.deepcopy(ONE) | {"accuracy": {"rest_side_share": error}} | more


@pytest.mark.long
def test_means_of_other_silos_keep_what_was_asked(monkeypatch):
    """Of a small silo the runs and their right value are all computed here."""
    silo = next(silo for silo in fronts_packing.silos(1, fronts_packing.UNSEEN, (7, 13)) if silo.across * silo.rows < 100)
    assert silo not in fronts_packing.silos(0, fronts_packing.MEASURED, (5, 19))
    monkeypatch.setattr(fronts_packing, "ASKED", (0.03, 0.06))
    monkeypatch.setattr(fronts_packing, "silos", lambda seed, count, across: [silo])
    found = fronts_packing.trials(lambda text: None, 1, runs=96)
    assert len(found) >= 10
    assert np.mean([trial.met for trial in found]) >= 0.9  # of so few means
    assert np.median([trial.cost / trial.cheapest for trial in found]) <= 1.5


def test_errors_of_means_go_with_the_root_of_their_number():
    runs = np.random.default_rng(1).normal(1.0, 0.05, 400)
    wrong = np.quantile(fronts_packing.drawn(runs, np.random.default_rng(2)), 0.95, axis=1)
    assert wrong * np.sqrt(fronts_packing.RUNS) == pytest.approx(1.96 * runs.std() / runs.mean(), rel=0.1)


def test_a_study_gets_as_many_runs_as_its_worst_case_needs():
    few, many = (expanded(asking(error)).study.runs for error in (0.05, 0.02))
    assert 2 * few < many
    axis = {"axis": "friction", "values": {"discs.wall_friction": [0.1, 0.4]}}
    both = expanded(asking(0.03, sweep=[axis]))
    rough = copy.deepcopy(ONE["scene"]) | {"discs": {"wall_friction": 0.4}}
    assert both.study.runs == expanded(asking(0.03, scene=rough)).study.runs
    assert both.promise["accuracy_settings"] == f"runs = {both.study.runs}"
    assert friction_scatter(0.5, 0.2, 40) == pytest.approx(0.05)


def test_the_cube_records_what_was_chosen():
    cube = packing_cube(expanded(asking(0.2, discharge_s=0.6)))
    assert cube.attrs["accuracy_asked"] == "rest_side_share 0.2"
    assert cube.attrs["accuracy_settings"] == f"runs = {cube.sizes['run'] - 1}"
    assert float(cube.attrs["accuracy_expected"].split()[-1]) <= 0.2


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ({"offset_m": 5e-5}, "measured on no such scene"),
        ({"scene": {"across": 12}}, "measured on no such scene"),  # a packing of another kind
        ({"runs": 7}, "runs = 7: give either accuracy or this"),
    ],
)
def test_refusals(more, message):
    with pytest.raises(BadInput, match=message):
        expanded(asking(0.05, **more))


def test_the_source_s_own_study_may_ask():
    content = read_yaml(ROOT / "config/studies/kiyama-1983.yaml")
    content = {name: value for name, value in content.items() if name not in ("runs", "outputs", "detailed")}
    content["sweep"] = [{"axis": "packing", "values": {"across": [18]}}]
    assert 2 <= expanded(content | {"accuracy": {"rest_side_share": 0.02}}, ROOT / "config/studies").study.runs <= 60
