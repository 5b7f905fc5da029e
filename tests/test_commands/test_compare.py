"""`silostudy compare` as a user types it."""

import yaml

from tests.conftest import ROOT
from tests.test_commands.said import WHEAT, said


def test_compare_says_what_was_measured_in_a_silo_of_its_size(capsys):
    flags = ("--solid", "maize_e1", "--wall", "d3", "--methods", "caquot", "as3774_1996")
    told = said(capsys, "compare", "--diameter", 11, "--depth", 14, *flags)
    assert "26.9 kPa at 11.9 m, filling, maize: next below as3774_1996 (-5%); next above caquot (+2%)" in told
    assert "measured" not in said(capsys, "compare", "--diameter", 11.5, "--depth", 14, *flags)


def test_compare_by_flags(capsys, tmp_path):
    stem = tmp_path / "picture"
    out = said(capsys, "compare", "--diameter", 5, "--depth", 18, "--solid", "wheat_benchmark", "--hopper-half-angle", 45,
               "--figure", stem)  # fmt: skip
    janssen = next(line for line in out.splitlines() if line.startswith("janssen, filling"))
    assert janssen.split()[2:6] == ["11.36", "16.93", "19.66", "21.00"]
    assert "67.0%" in janssen  # 1 - exp-type share of the weight on the wall
    assert stem.with_suffix(".png").is_file()


def test_compare_by_file_and_its_refusals(capsys):
    assert "deutsch, discharge" in said(capsys, "compare", WHEAT)
    assert "without sweep" in said(capsys, "compare", ROOT / "config/studies/wheat-family.yaml", status=2)
    for flag, value, told in (("--diameter", 3, "3.0"), ("--methods", "janssen", "['janssen']"), ("--wall", "d1", "'d1'")):
        wrong = said(capsys, "compare", WHEAT, flag, value, status=2)
        assert f"{flag} = {told}: write it into {WHEAT}" in wrong
    assert "--solid = None: is missing" in said(capsys, "compare", "--diameter", 5, "--depth", 18, status=2)
    wrong = said(capsys, "compare", "--diameter", -5, "--depth", 18, "--solid", "wheat_benchmark", status=2)
    assert "scene.silo.diameter_m = -5.0: must be greater than 0" in wrong


def test_compare_says_that_friction_was_capped(capsys):
    flags = ["--diameter", 5, "--depth", 18, "--solid", "maize", "--methods", "janssen"]
    assert "capped" not in said(capsys, "compare", *flags, "--wall", "grooved_concrete")
    assert "note: maize on its own wall friction: wall friction 2 capped" in said(
        capsys, "compare", *flags, "--wall-friction", 2
    )


def test_compare_tells_the_load_cases_beside_the_symmetric_ones(capsys, tmp_path):
    silo = {"plan": "circular", "diameter_m": 6.0, "cylinder_depth_m": 18.0, "outlet_eccentricity_m": 2.0}
    study = {
        "kind": "pressure",
        "title": "eccentric",
        "scene": {"silo": silo, "solid": "wheat_e1", "wall": "d2"},
        "methods": ["en1991_4", "en1991_4_eccentric", "as3774_1996"],
        "relative_depth": [0.5, 1.0],
    }
    (tmp_path / "study.yaml").write_text(yaml.safe_dump(study))
    out = said(capsys, "compare", tmp_path / "study.yaml")
    for part in ("patch load", "C_b 1.00", "k_c 0.60, within", "far side up to +23.3%", "near side -35.0% within 55 deg"):
        assert part in out
    assert "action assessment class of EN 1991-4: 2 or higher" in out
    study["scene"]["silo"] = {"plan": "square", "width_m": 5.0, "cylinder_depth_m": 18.0}
    (tmp_path / "study.yaml").write_text(yaml.safe_dump(study | {"phases": ["filling"]}))
    assert "band of pressure all round" in said(capsys, "compare", tmp_path / "study.yaml")
