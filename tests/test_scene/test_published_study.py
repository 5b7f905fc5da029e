"""Published cases: the table and the scenes say the same, misses are told in tolerances, verdicts in plain words."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.choice.expand import expand_file
from silostudy.compute.expected import Verdict
from silostudy.compute.published import misses
from silostudy.config.load import read_yaml, study_of
from silostudy.dem.outcomes import OUTCOMES
from silostudy.errors import BadInput
from silostudy.figures.published_cases import draw, message, verdict, verdicts
from silostudy.scene.published import check_numbers
from silostudy.scene.scenes import scene_in
from silostudy.sweep.merge import merge
from silostudy.tables.published_cases import published_numbers, published_of
from tests.conftest import ROOT
from tests.test_figures.made_scenes import published_cube
from tests.test_sweep.sweeps import compute

STUDY = ROOT / "config/studies/published-cases.yaml"


@pytest.mark.parametrize("case", dict.fromkeys(number.case for number in published_numbers()))
def test_scenes_expect_what_the_table_says(case):
    check_numbers(scene_in(ROOT / f"config/scenes/{case}.yaml").expected, case, "")


def test_units_are_those_of_the_quantities():
    assert [number.unit for number in published_numbers()] == [OUTCOMES[number.quantity].unit for number in published_numbers()]


def test_another_number_and_an_unknown_case_are_refused(tmp_path):
    scene = scene_in(ROOT / "config/scenes/pile.yaml")
    with pytest.raises(BadInput, match="expects other numbers"):
        check_numbers(scene.expected[:0], "pile", "")
    with pytest.raises(BadInput, match=r"file = 'heap': no published numbers of it; known: pile, drum"):
        check_numbers(scene.expected, "heap", "")


def test_every_filling_has_its_seed_and_watches_its_scene_file():
    expansion = expand_file(STUDY)
    first, second = expansion.cases[:2]
    assert (first.scene.config.seed, second.scene.config.seed) == (0, 1)
    assert first.id != second.id
    assert expansion.cases[0].scene.files[0].name == "pile.yaml"
    assert expansion.study.cases == ("pile", "drum", "anand-hopper", "draw-down")


@pytest.mark.parametrize(
    ("name", "outputs", "told"),
    [("published-cases", [], "sweep"), ("slot-of-discs", ["jams_over_outlet"], "output jams_over_outlet")],
)
def test_one_filling_is_refused_where_its_scatter_is_shown(name, outputs, told):
    path = ROOT / f"config/studies/{name}.yaml"
    content = read_yaml(path) | {"outputs": outputs}
    filling = next(axis for axis in content["sweep"] if axis["axis"] == "filling")
    filling["values"]["seed"] = [1]
    with pytest.raises(BadInput) as caught:
        study_of(content, "s.yaml", path.parent)
    assert str(caught.value).startswith(f"s.yaml: {told} needs two values at least on the axis filling")


def test_misses_are_in_tolerances():
    number = Verdict(OUTCOMES["heap-height"], 0.26, 0.02, 0.23, "a source")
    assert misses([number])["off_published"] == pytest.approx([-1.5, np.nan], nan_ok=True)


def test_fillings_are_merged_into_one_cube(tmp_path, monkeypatch):
    off = {"off_published": np.array([0.5, np.nan]), "end_time": np.array(1.0)}
    monkeypatch.setattr("silostudy.compute.published.measure", lambda study, case: off)
    compute(STUDY, tmp_path)
    assert merge(STUDY, tmp_path, tmp_path / "published.nc") == (12, 0)
    with xr.open_dataset(tmp_path / "published.nc") as cube:
        assert (cube.off_published.sel(expectation=0) == 0.5).all()


@pytest.mark.parametrize(
    ("off", "told"),
    [([0.5, -0.9], "met"), ([0.0, 1.4], "mean met, not every filling"), ([1.2, 1.4], "not met"), ([], "not seen")],
)
def test_verdicts_in_plain_words(off, told):
    assert verdict(np.array(off)) == told


def test_the_table_gives_numbers_back_in_their_units():
    """Of fillings that are 0.5 and 1.5 tolerances off: the pile's mean is one tolerance above 0.26 m, just met."""
    table, fillings = verdicts(published_cube("published-cases", off=(0.5, 1.5, 1.0)))
    pile = table.iloc[0]
    assert (pile["case"], pile["fillings"], pile["fillings_met"]) == ("pile", 3, 2)
    assert pile["mean"] == pytest.approx(0.28)
    assert pile["missed_by"] == pytest.approx(0.0)
    assert len(table) == len(published_numbers())
    assert [len(values) for values in fillings] == [3] * len(table)
    assert table["locator"].tolist()[-2:] == [number.locator for number in published_of("draw-down")]


def test_the_figure_says_how_many_numbers_are_met_and_keeps_every_filling(tmp_path):
    cube = published_cube("published-cases", off=(0.5, 1.3, 0.9))
    assert message(verdicts(cube)[0]) == "Of 5 published numbers, 5 are met by the mean of the fillings and 0 by every filling"
    draw(cube, tmp_path / "cases")
    shown = pd.read_csv(tmp_path / "cases.csv")
    drum = shown[(shown["case"] == "drum") & (shown["of"] == "filling")]
    assert drum["off_tolerances"].tolist() == [0.5, 1.3, 0.9]
