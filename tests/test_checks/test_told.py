"""What the checks tell: mistakes in one line, limits, what compare and list print."""

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.config.shell import FOR_CHECKS
from silostudy.errors import BadInput
from silostudy.tables.combinations import COMBINATIONS
from tests.conftest import expanded
from tests.test_checks.studies import study

MISTAKES = {
    "free on pinned": (
        {"wind__upper_edge": "free", "wind__lower_edge": "pinned"},
        "a free upper_edge needs a clamped lower_edge",
    ),
    "no earthquake": (
        {"checks": {"earthquake": {"behaviour_factor": 1.5, "solids_factor": 0.8, "overstrength": 1.2}}},
        "checks.earthquake needs the section earthquake",
    ),
    "not of one source": ({"checks": {"one_source": ["hoop_tension"]}}, "shear_buckling_2025"),
    "empty and full": (
        {"checks": {"combinations": [{"combination": "A", "leading": "wind", "contents": "empty", "permanent": 1.0,
                                      "wind": 1.5, "solids": 1.0}]}},
        "contents empty with solids 1: empty needs solids 0",
    ),
    "leads nothing": (
        {"checks": {"combinations": [{"combination": "A", "leading": "wind", "contents": "empty", "permanent": 1.0}]}},
        "the leading action wind needs a factor above 0",
    ),
    "half a hopper": ({"hopper_position": [0.0, 0.5]}, "hopper_position must run from 0 to 1 in 21 places"),
    "no combination": ({"checks": {"combinations": []}}, "checks.combinations = []: must hold 1 or more"),
    "a name of two words": (
        {"checks": {"combinations": [{"combination": "A 1", "leading": "wind", "contents": "empty", "permanent": 1.0,
                                      "wind": 1.5}]}},
        "combination = 'A 1': must be of letters, digits, _ and -",
    ),
    "a quake without side": (
        {"checks": {"combinations": [{"combination": "A", "leading": "earthquake", "contents": "full", "permanent": 1.0,
                                      "solids": 1.0, "earthquake": 1.0}]}},
        "side none with earthquake 1: such a combination needs side pressed or lifted",
    ),
    "hopper's steel without hopper": ({"silo__hopper": None, "hopper_position": None}, "hopper_shell needs silo.hopper"),
    "joint below yield": (
        {"hopper_shell__ultimate_stress_MPa": 100.0},
        "hopper_shell.ultimate_stress_MPa = 100: must not be below shell.yield_stress_MPa, 235",
    ),
    "anchors elsewhere": (
        {"anchors__circle_diameter_m": 62.0},
        "anchors.circle_diameter_m = 62: must be 4.8 to 7.5",
    ),
    "strakes that end above": (
        {"shell__strakes": [{"down_to": 0.5, "thickness_mm": 5.0}]},
        "the strakes' down_to must increase and end at 1, the foot of the cylinder: 0.5",
    ),
    "two columns": ({"columns__count": 2}, "scene.columns.count = 2: must be greater than or equal to 3"),
    "too strong a joint": ({"shell__joint_efficiency": 1.2}, "scene.shell.joint_efficiency = 1.2: must be less than or equal"),
}  # fmt: skip


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_are_told_in_one_line(name):
    changes, expected = MISTAKES[name]
    with pytest.raises(BadInput) as caught:
        expanded(study(**changes))
    assert expected in str(caught.value)
    assert "\n" not in str(caught.value)


def test_commands(tmp_path, capsys):
    path = tmp_path / "slender.yaml"
    path.write_text(yaml.safe_dump(study(), sort_keys=False))
    assert main(["compare", str(path)]) == 0
    said = capsys.readouterr().out
    assert "en1991_4, en1993_1_6_2007, 2" in said
    assert "buckling in WF" in said
    assert "janssen, transition_ring" in said
    assert "no load of this method in D, F, WF, S" in said
    plain = study(methods=["janssen"])
    plain.pop("checks")
    path.write_text(yaml.safe_dump(plain, sort_keys=False))
    assert main(["compare", str(path)]) == 2
    assert "scene.wind is for checks of the steel: ask for them by `checks: {}`" in capsys.readouterr().err
    for part in FOR_CHECKS:
        plain["scene"].pop(part)
    path.write_text(yaml.safe_dump(plain, sort_keys=False))
    assert main(["compare", str(path)]) == 0
    assert "not checked without the section checks" in capsys.readouterr().out
    assert main(["explain", "checks"]) == 0
    assert "remembered alone, so not built" in capsys.readouterr().out
    assert main(["list", "combinations"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == list(COMBINATIONS)


def test_a_check_out_of_its_range_names_the_limit(tmp_path, capsys):
    path = tmp_path / "rough.yaml"
    path.write_text(yaml.safe_dump(study(levels=3, shell__quality="C", methods=["janssen"]), sort_keys=False))
    assert main(["compare", str(path)]) == 0
    said = capsys.readouterr().out
    assert "note: shear_buckling_2007: out of range where not t/r <= 0.05" in said
    assert "Q >= 25 (alpha 0.65 of class B" in said
    assert " nan" not in said


def test_a_strake_as_thin_as_paper_is_told(tmp_path, capsys):
    path = tmp_path / "thin.yaml"
    strakes = [{"down_to": 0.5, "thickness_mm": 0.004}, {"down_to": 1.0, "thickness_mm": 5.0}]
    path.write_text(yaml.safe_dump(study(levels=3, shell__strakes=strakes), sort_keys=False))
    assert main(["check", str(path)]) == 0
    assert "thickness_mm = 0.004 is unusual: mostly 0.5 to 60" in capsys.readouterr().out
