"""The silo's wall profile over the step: noise and distance of means, steps at which nothing rests, the figure."""

import copy

import numpy as np
import pytest

from silostudy.accuracy.profile import profile_cube
from silostudy.accuracy.silo_step import at_rest, error_of, filled, profile
from silostudy.contact import NORMAL, TANGENTIAL
from silostudy.errors import BadInput
from silostudy.figures.profile_over_step import draw
from silostudy.scene.plane_silo import inner_width
from tests.conftest import expanded
from tests.test_accuracy.test_stability_map import RESTING

SILO = {"steps_ms": [0.04, 0.1], "reference_step_ms": 0.025, "fillings": 2, "rest_s": 0.8, "parts": 4}


@pytest.fixture(scope="module")
def cube():
    return profile_cube(expanded(copy.deepcopy(RESTING) | {"silo": SILO}))


def test_a_step_beyond_the_bound_is_no_answer(cube):
    plain = cube.sel(marcher="17-18")
    assert np.isnan(plain["profile_error"].to_numpy()).tolist() == [False, True]
    assert float(plain["profile_error"][0]) < 0.5
    implicit = cube.sel(marcher="17-19, semi-implicit dashpots")
    assert np.isfinite(implicit["profile_error"]).all()
    assert (cube["reference_push"] > 0.0).all()


def test_the_profile_is_the_walls_share_of_a_rest():
    """Springs of resting discs against the wall: both walls push alike, and no more than the fill weighs."""
    model = filled(1, 2.5e-5, "17-18", NORMAL["spring-dashpot"], TANGENTIAL["spring-slider"])
    places = at_rest(model, 0.8)
    assert places is not None
    both = profile(places, model, 5)
    mirrored = np.c_[inner_width(model) - places[:, 0], places[:, 1]]
    assert both == pytest.approx(profile(mirrored, model, 5), rel=1e-6)
    assert 0.1 < both.sum() / (model.mass.sum() * 9.81) < 1.0
    assert (
        at_rest(filled(1, 2.5e-5, "17-18", NORMAL["spring-dashpot"], TANGENTIAL["spring-slider"]), 1e-3) is None
    )  # still falling


def test_distance_and_noise_of_means():
    random = np.random.default_rng(0)
    reference = 10.0 + random.standard_normal((400, 3))
    apart, noise = error_of(reference + [1.0, 0.0, 0.0] + 0.1 * random.standard_normal((400, 3)), reference)
    assert apart == pytest.approx(1.0 / np.linalg.norm(reference.mean(axis=0)), rel=0.05)
    assert noise == pytest.approx(0.1 * np.sqrt(3.0 / 400) / np.linalg.norm(reference.mean(axis=0)), rel=0.1)


def test_the_figure_names_its_axes(cube, tmp_path, monkeypatch):
    seen = []
    monkeypatch.setattr(
        "silostudy.figures.profile_over_step.save", lambda figure, numbers, stem: seen.append((figure, numbers))
    )
    draw(cube, tmp_path / "profile")
    figure, numbers = seen[0]
    assert [panel.get_xlabel() for panel in figure.axes] == ["time step (ms)", "normal force on both walls (N/m)"]
    assert len(figure.legends[0].get_texts()) == 2
    assert {"march_step_s", "wall_force_over_reference"} <= set(numbers.columns)


def test_mistakes():
    for steps in ([0.1, 0.04], [0.04, 0.04], [0.02, 0.04]):
        with pytest.raises(BadInput, match="steps_ms must rise, from above reference_step_ms"):
            expanded(copy.deepcopy(RESTING) | {"silo": SILO | {"steps_ms": steps}})
    with pytest.raises(BadInput, match="no such section"):
        profile_cube(expanded(copy.deepcopy(RESTING)))
