"""The fronts of seismic studies: trials on other tubes and motions, and studies that keep what they asked for."""

import copy

import numpy as np
import pytest
import yaml
from threadpoolctl import threadpool_limits

from silostudy.accuracy import fronts_seismic
from silostudy.choice.seismic import POWER, seismic_traits, valley_number
from silostudy.compute.seismic import seismic_cube
from silostudy.compute.shell_earthquake import of_this_study
from silostudy.config.load import read_yaml
from silostudy.errors import BadInput
from silostudy.seismic.beam import Tube
from tests.conftest import ROOT, expanded

STUDIES = ROOT / "config/studies"


def unseen(count: int) -> list[fronts_seismic.ShakenTube]:
    return list(fronts_seismic.shakings(1, count, 0.3, 0.015))


@pytest.mark.long
@threadpool_limits.wrap(limits=1)
def test_refinements_meet_what_was_asked_on_other_scenes():
    """Wherever in a step of the candidates the truth lies."""
    random = np.random.default_rng(3)
    found = [trial for shaking in unseen(8) for trial in fronts_seismic.coefficient_trials(shaking, random)]
    assert np.mean([trial.met for trial in found]) >= 0.95
    assert np.median([trial.setting / trial.least for trial in found]) <= 1.5


@pytest.mark.long
@threadpool_limits.wrap(limits=1)
def test_levels_keep_the_moment_on_other_scenes():
    random = np.random.default_rng(3)
    found = [fronts_seismic.moment_trial(shaking, random) for shaking in unseen(240)]  # 40 tell no more than 5 %
    assert np.mean([trial.met for trial in found]) >= 0.95
    assert np.median([trial.setting for trial in found]) <= fronts_seismic.LEVELS[-1] / 4


@pytest.mark.long
def test_no_scene_of_the_trial_was_measured_on():
    measured = [one.question.tube for one in fronts_seismic.shakings(0, fronts_seismic.MOVED, 0.4, 0.008)]
    assert not any(one.question.tube in measured for one in unseen(fronts_seismic.UNSEEN))


def identifying(truth: float, **more) -> dict:
    """The study of the source's model without noise and with the damping known, so that only the candidates err."""
    content = copy.deepcopy(read_yaml(STUDIES / "sasaki-1991.yaml"))
    content["scene"]["measured"]["imitation"] |= {
        "effective_mass_coefficient": truth,
        "noise_ratio": 0.0,
        "damping_ratio": 0.02,
    }
    content["identification"] |= {"coefficients": {"start": 0.5, "stop": 1.0, "count": 6}, "recovery_trials": 2} | more
    del content["identification"]["refinement"]
    return {name: value for name, value in content.items() if name not in ("sweep", "outputs", "sine", "assumed", "published")}


@pytest.mark.long
@pytest.mark.parametrize("truth", [0.61803, 0.777])
def test_a_study_finds_the_coefficient_as_well_as_it_asked(truth):
    found = {}
    for asked in (0.02, 0.001):
        expansion = expanded(identifying(truth) | {"accuracy": {"effective_mass_coefficient": asked}}, STUDIES)
        cube = seismic_cube(expansion)
        answer = float(cube["effective_mass_coefficient"].sel(identification="amplitude_error"))
        assert abs(answer / truth - 1) <= asked
        found[asked] = expansion.study.identification.refinement
        assert cube.attrs["accuracy_settings"] == f"identification.refinement = {found[asked]}"
        assert cube.attrs["accuracy_asked"] == f"effective_mass_coefficient {asked:g}"
    assert found[0.001] > found[0.02]


def test_the_valley_is_as_wide_as_the_damping_makes_it():
    tube = Tube(radius=1.0, thickness=0.01, height=4.0, fill_height=4.0, wall_density=7850.0, youngs_modulus=2e11,
                poisson_ratio=0.3, shear_factor=0.5, contents_density=800.0)  # fmt: skip
    one = valley_number(tube, 0.02, 0.05, 0.7)
    assert valley_number(tube, 0.04, 0.05, 0.7) == pytest.approx(one / 2 ** (POWER - 1.0))
    assert valley_number(tube, 0.02, 0.1, 0.7) == pytest.approx(2**POWER * one)
    expansion = expanded(identifying(0.7) | {"accuracy": {"effective_mass_coefficient": 0.01}}, STUDIES)
    scene = expansion.cases[0].scene
    (traits,) = seismic_traits(expansion.study, [scene])
    assert traits["valley_number"] == pytest.approx(valley_number(scene.tube, 0.02, 0.1, 0.7))


def test_levels_keep_the_moment_and_a_shell_study_reads_the_same_ones(tmp_path):
    content = read_yaml(STUDIES / "steel-wheat-earthquake.yaml")
    del content["relative_depth"]
    asked = content | {"accuracy": {"wall_bending_moment": 0.01}}
    (tmp_path / "steel-wheat-earthquake.yaml").write_text(yaml.safe_dump(asked))
    study = expanded(asked).study
    shell = expanded(read_yaml(STUDIES / "steel-wheat-shaken.yaml"), tmp_path)
    assert of_this_study(shell, seismic_cube(expanded(asked))).sizes["relative_depth"] == study.relative_depth.count
    with pytest.raises(BadInput, match="is of another study"):
        of_this_study(shell, seismic_cube(expanded(content | {"relative_depth": [0.0, 1.0]})))
    fine = seismic_cube(expanded(content | {"relative_depth": {"start": 0, "stop": 1, "count": 241}}))
    moment = fine["wall_bending_moment"].sel(mass_choice="all_contents")
    levels = np.linspace(0, 1, study.relative_depth.count)
    read = np.interp(moment["relative_depth"], levels, moment.sel(relative_depth=levels, method="nearest"))
    assert 0 < float(abs(read - moment).max() / moment.max()) <= 0.01


def test_a_setting_beside_an_accuracy_is_refused():
    content = identifying(0.7, refinement=4) | {"accuracy": {"effective_mass_coefficient": 0.01}}
    content["identification"]["refinement"] = 4
    with pytest.raises(BadInput, match=r"identification\.refinement = .*: give either accuracy or this"):
        expanded(content, STUDIES)
