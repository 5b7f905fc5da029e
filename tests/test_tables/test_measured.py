"""Measurements: each has a kind, a unit and either what answers it or why nothing does."""

import re

import pytest

from silostudy.cube.contract import VARIABLES
from silostudy.cube.measured import FORMULAS
from silostudy.tables.measured import KINDS, SWELLING_OVER_FILLING, measured_pressures, measurements
from silostudy.tables.references import cite
from silostudy.tables.solids import SOLIDS
from silostudy.tables.walls import WALLS
from tests.conftest import ROOT


@pytest.mark.parametrize("one", measurements(), ids=lambda one: one.measurement)
def test_a_measurement_says_what_answers_it_or_why_none_does(one):
    assert one.kind in KINDS
    assert bool(one.answer) != bool(one.why_none)
    assert bool(one.formula) != (one.shown == one.shown)  # a formula stands in place of a number
    if one.answer:
        assert one.answer == SWELLING_OVER_FILLING or one.answer in VARIABLES
        assert one.taken_solid in SOLIDS
        assert one.taken_wall in ("", *WALLS)
    if one.formula:
        assert one.formula in FORMULAS
    if one.locator == "abstract":
        assert "Only the abstract was read" in cite(one.source)


def test_measurements_are_in_si_and_told_in_their_own_unit():
    found = {one.measurement: one for one in measurements()}
    assert len(found) == len(measurements())
    assert (found["thompson_12_8"].value, found["thompson_12_8"].told) == (28200, "28.2 kPa")
    assert (found["zhao_jofriet_1987"].value, found["zhao_jofriet_1987"].told) == (5300, "5.3 kPa/m")
    assert found["sunday_pile"].value == pytest.approx(0.4398, abs=5e-5)
    assert found["sunday_pile"].told == "25.2 +- 0.8 deg"
    assert found["atewologun_ratio"].told == "1 - sin(phi)"
    assert [one.measurement for one in measured_pressures()] == ["thompson_12_8", "thompson_11_0"]


def test_studies_that_answer_in_a_method_s_place_exist():
    """Piles and drums are told by scenes of grains: the row names the study that holds them against what was measured."""
    said = [one.why_none for one in measurements() if re.search("pile|drum", one.why_none)]
    assert len(said) == 3
    studies = [re.search(r"the study ([\w-]+)", why)[1] for why in said]
    assert all((ROOT / f"config/studies/{study}.yaml").is_file() for study in studies)
