"""Load cases of a silo: which are called for, which are computed, and that the table agrees with what the package holds."""

import copy
from pathlib import Path

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.load_cases import LISTED_STATES, load_cases
from silostudy.tables.load_cases import LOAD_CASES
from tests.conftest import ROOT, expanded

STUDIES = ROOT / "config/studies"


def listed(study: str, phases=("filling", "discharge"), **silo):
    content = yaml.safe_load((STUDIES / f"{study}.yaml").read_text(encoding="utf-8"))
    content = copy.deepcopy(content) | {"outputs": [], "sweep": [], "phases": list(phases)}
    content["scene"]["silo"] |= silo
    expansion = expanded(content)
    return {one.row.key: one for one in load_cases(expansion.study, expansion.cases[0].scene)}


def test_a_slender_silo_has_patches_and_no_channel():
    cases = listed("steel-wheat-checks")
    assert {one.state for one in cases.values()} <= set(LISTED_STATES)
    for key in ("filling", "filling_patch", "discharge_patch", "hopper_filling", "hopper_discharge", "wind_empty"):
        assert cases[key].state == "computed", key
    assert cases["channel_40"].state == "not called for"
    assert "class 3" in cases["channel_40"].why
    assert cases["earthquake_pressed"].why == "needs checks.earthquake"
    assert "memory only" in cases["temperature"].why


def test_the_empty_silo_needs_no_phase():
    assert listed("steel-wheat-checks", phases=["discharge"])["wind_empty"].state == "computed"


def test_a_squat_silo_has_no_patch_and_a_flat_one_no_hopper():
    cases = listed("steel-wheat-squat")
    assert cases["filling_patch"].state == cases["discharge_patch"].state == cases["hopper_filling"].state == "not called for"
    assert "C_pf = 0" in cases["filling_patch"].why
    assert cases["filling"].state == cases["bottom"].state == "computed"


@pytest.mark.parametrize(
    ("changes", "state", "why"),
    [
        ({}, "computed", ""),
        ({"outlet_eccentricity_m": 1.9}, "not called for", "e_o/d_c 0.24"),
        ({"action_assessment_class": 2}, "not called for", "class 2"),
        ({"cylinder_depth_m": 12.0}, "not asked for", "needs the method en1991_4_eccentric_squat"),
    ],
)
def test_the_channel_is_for_class_3_and_an_outlet_off_the_axis(changes, state, why):
    found = listed("eccentric-silo", **changes)
    assert found["channel_25"].state == state
    assert why in found["channel_25"].why


def test_beyond_the_code_a_case_names_the_limit():
    found = listed("steel-wheat-squat", cylinder_depth_m=9.0)
    assert found["filling"].state == "not computed"
    assert "retaining silos" in found["filling"].why
    assert found["retaining"].state == "not computed"


def test_a_plan_without_a_patch_of_its_own_has_none():
    study = yaml.safe_load((STUDIES / "mass-flow-slot.yaml").read_text(encoding="utf-8"))
    expansion = expanded(study | {"methods": ["en1991_4"], "phases": ["filling", "discharge"], "outputs": []})
    found = {one.row.key: one for one in load_cases(expansion.study, expansion.cases[0].scene)}
    assert found["filling_patch"].state == found["discharge_patch"].state == "not computed"
    assert "plan" in found["filling_patch"].why
    assert found["filling"].state == "computed"


def test_a_low_silo_asks_for_the_patch_of_one_source():
    low = {"cylinder_depth_m": 6.6}
    assert "one program only" in listed("steel-wheat-checks", **low)["discharge_patch"].why
    assert listed("steel-wheat-checks", **low, patch_of_low_silo=True)["discharge_patch"].state == "computed"


def test_the_command_lists_them(capsys):
    assert main(["list", "load-cases"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == list(LOAD_CASES)
    assert main(["compare", str(STUDIES / "steel-wheat-squat.yaml")]) == 0
    told = capsys.readouterr().out
    assert "filling, patch " in told
    assert "not called for: C_pf = 0 where h_c/d_c <= 1: 0.70" in told


def test_an_earthquake_does_not_shake_an_empty_silo(tmp_path, capsys):
    content = yaml.safe_load((STUDIES / "steel-wheat-squat.yaml").read_text(encoding="utf-8"))
    empty = {
        "combination": "EE",
        "leading": "earthquake",
        "contents": "empty",
        "side": "lifted",
        "permanent": 1,
        "earthquake": 1,
    }
    path = Path(tmp_path / "own.yaml")
    path.write_text(yaml.safe_dump(content | {"checks": {"combinations": [empty]}}))
    assert main(["check", str(path)]) == 2
    assert "an earthquake shakes the silo with its contents" in capsys.readouterr().err
