"""Springs and dashpots that no step bears, or that are too soft for what lies on them, and steps beyond counting."""

from pathlib import Path

import pytest

from silostudy.compute.dem import scene_model
from silostudy.errors import BadInput
from silostudy.scene.notes import notes as all_notes
from tests.conftest import ROOT
from tests.test_dem.small import scene_of as discs_of
from tests.test_spheres.small import scene_of as spheres_of

SLIDER = {
    "spheres__rolling": "spring-dashpot-slider", "spheres__rolling_stiffness_N_m": 1e-3, "spheres__rolling_friction": 0.1,
}  # fmt: skip


def test_a_dashpot_too_strong_for_any_step_is_refused_by_its_name():
    told = r"spheres\.rolling = 'spring-dashpot-slider': its dashpot is too strong: steps are stable up to .* s only"
    with pytest.raises(BadInput, match=told):
        scene_model(spheres_of(**SLIDER, spheres__rolling_damping_N_m_s=10.0), Path())


def test_a_step_that_makes_more_steps_than_can_be_counted_is_refused():
    with pytest.raises(BadInput, match=r"march\.limit_s = 1\.0: takes more steps of 1e-300 s than can be counted"):
        scene_model(spheres_of(march__step_s=1e-300), Path())


@pytest.mark.parametrize(("stiffness", "count"), [(10.0, 1), (1e4, 1), (1e6, 0)])
def test_discs_too_soft_for_what_lies_on_them_are_noted(stiffness, count):
    """The weight of all discs over the silo's width, on the breadth of one, by its spring."""
    scene = discs_of(discs__normal_stiffness_N_m2=stiffness)
    model = scene_model(scene, ROOT)
    found = [line for line in all_notes(scene, model) if "presses the lowest" in line]
    deep = float(model.mass.sum()) * 9.81 / scene.silo.width_m * 2.0 / stiffness
    told = f"note: discs: all that is there presses the lowest {deep:.2g} of the radius into each other"
    assert [line.partition(";")[0] for line in found] == [told] * count
