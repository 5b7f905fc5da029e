"""What governs each part: figure and tables, load cases, a study's own combinations."""

import numpy as np
import pytest
import yaml

from silostudy.cube.governing import parts as parts_of
from silostudy.figures import checks_over_depth, checks_summary, governing_cases
from silostudy.tables.combinations import COMBINATIONS
from tests.conftest import ROOT
from tests.test_checks.studies import cube_of, study, words


def test_figure_and_table(cube, tmp_path):
    checks_over_depth.draw(cube, tmp_path / "figure")
    head, *rows = (tmp_path / "figure.csv").read_text().splitlines()
    assert head.startswith("rule,place,depth_m,built_mm,force_D_kN_m,force_F_kN_m,")
    assert len(rows) == 2 * cube.sizes["place"]
    checks_summary.draw(cube, tmp_path / "table")
    table = (tmp_path / "table.csv").read_text()
    assert table.count("\nstrake,") == 2 * 2 * 3 * 2
    assert "not checked" in table
    assert "hopper_hoop" in table


def test_what_governs_each_part(cube, tmp_path):
    """The worst over combinations of each strake is the cube's own, with the same check; each names its load case."""
    found = [one for one in parts_of(cube, "en1991_4", "en1993_1_6_2007") if one["state"] == "checked"]
    of_part = {
        one["part"]: max((x for x in found if x["part"] == one["part"]), key=lambda x: x["utilisation"]) for one in found
    }
    wall = cube.sel({"pressure_method": "en1991_4", "rule": "en1993_1_6_2007"})
    for strake in (1, 2, 3):
        worst = wall.sel(strake=strake)["design_strake_utilisation"]
        assert of_part[f"strake {strake}"]["utilisation"] == float(worst.max())
        here = wall.sel(strake=strake).isel(wall_friction_end=int(worst.values.argmax()))
        assert of_part[f"strake {strake}"]["governed_by"] == words(here, "design_strake_utilisation_check")
        assert of_part[f"strake {strake}"]["combination"] == words(here, "design_strake_utilisation_combination")
    assert (of_part["strake 2"]["combination"], of_part["strake 2"]["load_case"]) == ("WF", "discharge with patch")
    assert of_part["hopper"]["load_case"] == "discharge"
    assert of_part["anchors"]["load_case"] == "empty"
    assert not any(one["combination"] in ("EP", "EL") for one in found)
    governing_cases.draw(cube, tmp_path / "figure")
    rows = (tmp_path / "figure.csv").read_text().splitlines()
    assert len(rows) == 1 + 2 * 2 * len(COMBINATIONS) * len(set(of_part))


def test_the_load_case_is_of_the_phase_with_the_largest_force(parts):
    """Janssen's filling and discharge are alike, EN's discharge presses more; the patch pulls below its own depth alone."""
    _, pressure, cube = parts
    one = cube.sel(pressure_method="en1991_4", wall_friction_end="upper")
    meanings = np.array(cube["axial_wall_force_load_case"].attrs["flag_meanings"].split())
    told = meanings[one["axial_wall_force_load_case"].values]
    begins = float((pressure["patch_depth"] - pressure["patch_height"] / 2).min())
    z = one["place_depth"].values
    assert set(told[(z > 0) & (z < begins)]) == {"discharge"}
    assert set(told[z > begins + 2.0]) == {"discharge_with_patch"}
    assert set(meanings[one["wall_pressure_load_case"].values][z > 0]) == {"discharge"}


def test_in_a_squat_silo_every_phase_is_alike():
    content = yaml.safe_load((ROOT / "config/studies/steel-wheat-squat.yaml").read_text(encoding="utf-8"))
    content["outputs"], content["methods"], content["relative_depth"]["count"] = [], ["en1991_4"], 7
    checked = [one for one in parts_of(cube_of(content), "en1991_4", "en1993_4_1_2007") if one["state"] == "checked"]
    governing = {one["part"]: one for one in sorted(checked, key=lambda one: one["utilisation"])}
    assert governing["strake 3"]["governed_by"] == "hoop_tension"
    assert governing["strake 3"]["load_case"] == "every phase alike"
    assert governing["strake 1"]["load_case"] == "empty"


def test_own_partial_factors_move_what_governs():
    """From the study's file to the table: twice the factor on the solid is twice its share, and the combination's own name."""
    own = {"combination": "HEAVY", "title": "only the solid", "leading": "solids", "contents": "full", "permanent": 0}
    used = {}
    for factor in (1.0, 2.0):
        cube = cube_of(study(checks={"combinations": [own | {"solids": factor}]}, methods=["en1991_4"]))
        used[factor] = {one["part"]: one for one in parts_of(cube, "en1991_4", "en1993_1_6_2007")}
    for part in ("hopper", "transition ring"):
        assert used[1.0][part]["combination"] == "HEAVY"
        assert used[2.0][part]["utilisation"] == pytest.approx(2 * used[1.0][part]["utilisation"], rel=1e-9)


def test_a_study_s_own_combinations_replace_the_package_s():
    """Twice the factor, twice the force; an empty one that wind leads; nothing else is left."""
    own = [
        {"combination": "A", "leading": "solids", "contents": "filling", "permanent": 0.0, "solids": 1.0},
        {"combination": "B", "leading": "solids", "contents": "filling", "permanent": 0.0, "solids": 2.0},
    ]
    cube = cube_of(study(checks={"combinations": own}))
    assert cube["combination"].values.tolist() == ["A", "B"]
    single, double = (cube["design_axial_wall_force"].sel(combination=key) for key in "AB")
    np.testing.assert_allclose(double, 2 * single, rtol=1e-12)
    np.testing.assert_allclose(*(cube["design_lower_pressure"].sel(combination=key) for key in "AB"), rtol=1e-12)
