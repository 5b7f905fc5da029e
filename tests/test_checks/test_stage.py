"""The stage of the checks: actions by hand, both sides of every edge, thickness used to the full, nothing passed silently."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.buckling import BUCKLING
from silostudy.buckling.thickness import with_thickness
from silostudy.checks import CHECKS, SOLID_CHECKS
from silostudy.checks.stepped_wall import critical_pressure
from silostudy.choice.expand import expand
from silostudy.compute.checks import checks_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.seismic import seismic_cube
from silostudy.compute.shell import shell_cube
from silostudy.config.shell import FOR_CHECKS
from silostudy.cube.unchecked import unchecked
from silostudy.tables.constants import STANDARD_GRAVITY
from tests.conftest import expanded
from tests.test_buckling.test_shell import STUDY
from tests.test_buckling.test_shell_earthquake import SHAKEN
from tests.test_checks.studies import cube_of, study, words


def test_both_sides_of_every_edge_are_looked_at(cube):
    z, t = (cube[name].isel(wall_friction_end=0).values for name in ("place_depth", "place_thickness"))
    edges = [place for place in range(len(z) - 1) if t[place + 1] != t[place]]
    np.testing.assert_allclose(z[edges], [0.33 * 18, 0.66 * 18], rtol=1e-12)
    np.testing.assert_allclose(z[[place + 1 for place in edges]], z[edges], rtol=1e-12)
    assert np.all(np.diff(z) >= 0)
    assert (z[0], z[-1]) == (0, pytest.approx(18.0))


def test_actions_at_the_foot_by_hand(parts):
    """D: 1.5 times the solid and the patch, 1.35 steel and roof, 0.75 snow, 0.9 wind; the pressure that steadies unfactored."""
    _, pressure, cube = parts
    here = {"pressure_method": "en1991_4", "wall_friction_end": "upper"}
    foot = cube.sel(here | {"combination": "D"}).isel(place=-1)
    solid = pressure.sel(here).isel(relative_depth=-1)
    weight = 7850 * STANDARD_GRAVITY * 18 * (0.33 * 0.004 + 0.33 * 0.005 + 0.34 * 0.007)
    wind = 0.7 * 900 * 6 * 18**2 / 2 / (np.pi * 9)
    lever = 18 - solid["patch_depth"].max()
    patch = float(solid["patch_resultant"].max() * lever / (np.pi * 9))
    n = 1.5 * (float(solid["axial_wall_force"].max()) + patch) + 1.35 * (weight + 30e3 / (6 * np.pi)) + 0.75 * 800 * 1.5
    assert float(foot["design_axial_wall_force"]) == pytest.approx(n + 0.9 * wind, rel=1e-9)
    assert float(foot["design_upper_pressure"]) == pytest.approx(1.5 * float(solid["wall_normal_pressure"].max()), rel=1e-12)
    assert float(foot["design_lower_pressure"]) == pytest.approx(float(solid["accompanying_wall_pressure"].min()), rel=1e-12)
    shear = (1.5 * float(solid["patch_resultant"].max()) + 0.9 * 0.7 * 900 * 6 * 18) / (np.pi * 3)
    assert float(foot["design_shear_wall_force"]) == pytest.approx(shear, rel=1e-9)
    filled = cube.sel(here | {"combination": "F"}).isel(place=-1)
    assert float(filled["design_axial_wall_force"]) < float(foot["design_axial_wall_force"])


def test_an_empty_silo_has_no_solid_and_the_wind_outside(cube):
    empty = cube.sel(combination="WE", pressure_method="janssen", wall_friction_end="upper")
    assert float(empty["design_upper_pressure"].max()) == 0.0
    steel = {"radius": 3.0 + (0.33 * 4 + 0.33 * 5 + 0.34 * 7) / 2e3, "youngs_modulus": 210e9, "shell_poisson_ratio": 0.3}
    courses = [0.33 * 18, 0.33 * 18, 0.34 * 18]
    by_ritz = critical_pressure([0.004, 0.005, 0.007], courses, edges=("pinned", "clamped"), **steel)
    assert float(cube["critical_external_pressure"][0]) == pytest.approx(by_ritz[0], rel=1e-7)
    used = empty["design_check_utilisation"].sel(steel_check="external_pressure")
    assert float(used.max() / used.min()) == pytest.approx(1, abs=1e-9)  # all elastic: the wall buckles as one
    full = cube["design_check_utilisation_scope"].sel(steel_check="external_pressure", combination="D")
    assert {full.attrs["flag_meanings"].split()[flag] for flag in np.unique(full)} == {"not_in_this_combination"}


def test_utilisation_is_the_largest_and_names_what_governs(cube):
    one = cube.sel({"rule": "en1993_1_6_2007", "pressure_method": "en1991_4", "wall_friction_end": "upper"})
    each = [one["design_buckling_utilisation"].max("combination"), *one["design_check_utilisation"].max("combination")]
    np.testing.assert_allclose(one["design_utilisation"], np.max(each, axis=0), rtol=1e-15)
    foot = one.sel(strake=2)
    assert (words(foot, "design_strake_utilisation_check"), words(foot, "design_strake_utilisation_combination")) == (
        "buckling",
        "WF",
    )
    inside = one["place_strake"] == 2
    assert float(foot["design_strake_utilisation"]) == float(one["design_utilisation"].where(inside).max())


@pytest.mark.parametrize("rule", ["en1993_4_1_2007", "en1993_1_6_2007"])
def test_the_needed_thickness_is_used_to_the_full(cube, rule):
    """A wall built with the largest thickness that any depth asks for is used to 1, not more and not less."""
    needed = float(cube["design_thickness"].sel({"rule": rule, "pressure_method": "en1991_4"}).max())
    content = study(shell__strakes=[{"down_to": 1.0, "thickness_mm": needed * 1e3}], rules=[rule], methods=["en1991_4"])
    built = cube_of(content)
    largest = float(built["design_utilisation"].max())
    assert largest == pytest.approx(1, abs=0.01)
    if (
        words(built.isel(rule=0, pressure_method=0, wall_friction_end=1, strake=0), "design_strake_utilisation_check")
        == "buckling"
    ):
        assert largest == pytest.approx(1, rel=1e-6)


def test_courses_built_as_needed_carry_each_other(cube):
    """Each as thick as a wall of one thickness needs there: none is used beyond 1, and the lowest nearly to it."""
    needed = cube["design_strake_thickness"].sel(rule="en1993_4_1_2007", pressure_method="en1991_4").max("wall_friction_end")
    strakes = [
        {"down_to": share, "thickness_mm": float(t) * 1e3} for share, t in zip((0.33, 0.66, 1.0), needed.values, strict=True)
    ]
    built = cube_of(study(shell__strakes=strakes, rules=["en1993_4_1_2007"], methods=["en1991_4"]))
    used = built["design_strake_utilisation"].max(["wall_friction_end", "rule", "pressure_method"])
    assert float(used.max()) <= 1
    assert float(used[-1]) > 0.95


def test_axial_buckling_by_the_rule(parts):
    expansion, _, cube = parts
    one = cube.sel(rule="en1993_4_1_2007", combination="D", pressure_method="en1991_4", wall_friction_end="lower").isel(
        place=-1
    )
    wall = expansion.cases[0].scene.shell
    parameters = {**wall.steel, "bay_length": 18.0, "total_length": 18.0, "ring_area": 0.0, "inner_radius": np.array(3.0)}
    parameters |= {f"{end}_internal_pressure": np.array(float(one[f"design_{end}_pressure"])) for end in ("lower", "upper")}
    strength = with_thickness(BUCKLING["en1993_4_1_2007"], parameters, np.array(0.007))["buckling_stress"] / 1.1
    assert float(one["design_buckling_stress"]) == pytest.approx(float(strength), rel=1e-12)
    expected = float(one["design_axial_wall_force"]) / 0.007 / strength
    assert float(one["design_buckling_utilisation"]) == pytest.approx(float(expected), rel=1e-12)


def test_what_is_not_given_is_not_checked_and_never_passed():
    bare = study()
    for key in FOR_CHECKS:
        bare["scene"].pop(key)
    cube = cube_of(bare)
    told = "\n".join(unchecked(cube))
    for expected in (
        "WE, V: needs scene.wind",
        "EP, EL: needs earthquake and checks.earthquake",
        "needs scene.hopper_shell",
        "ring_beam: not checked in D, F, S: needs scene.columns",
        "interaction_2025: not checked: one source alone",
        "not given, so in no combination: wind, suction, earthquake",
    ):
        assert expected in told
    for name in ("hopper_check_utilisation", "support_check_utilisation"):
        assert cube[name].isnull().all()
    assert cube["design_check_utilisation"].sel(combination=["WE", "V", "EP"]).isnull().all()
    assert float(cube["design_utilisation"].max()) > 0.5  # what is given is checked all the same


def test_a_method_without_load_is_not_judged_by_the_wind_alone():
    content = study(methods=["janssen", "en1991_4"])
    content["scene"] |= {"solid": "wheat", "wall": None, "wall_friction_end": "mean"}
    content["scene"]["properties"] = {"unit_weight_kN_m3": 9.0, "wall_friction": 0.38, "lateral_pressure_ratio": 0.54}
    content["scene"]["silo"]["hopper"].pop("wall")
    cube = cube_of(content)
    assert cube["design_strake_utilisation"].sel(pressure_method="en1991_4").isnull().all()
    assert cube["design_strake_thickness"].sel(pressure_method="en1991_4").isnull().all()
    assert cube["design_utilisation"].sel(pressure_method="en1991_4").isel(place=slice(2, None)).isnull().all()
    assert cube["design_strake_utilisation"].sel(pressure_method="janssen").notnull().all()


def test_class_c_is_masked_where_its_factor_is_only_remembered():
    cube = cube_of(study(shell__quality="C"))
    scope = cube["design_check_utilisation_scope"].sel(steel_check="external_pressure", combination="WE")
    assert {scope.attrs["flag_meanings"].split()[flag] for flag in np.unique(scope)} == {"out_of_range"}


def test_one_source_checks_run_only_where_they_are_named():
    assert {row.key for row in CHECKS.values() if row.one_source} == {"shear_buckling_2025", "interaction_2025"}
    cube = cube_of(study(checks={"one_source": ["shear_buckling_2025"]}))
    assert "shear_buckling_2025" in cube["steel_check"]
    assert "interaction_2025" not in cube["steel_check"]


def test_weak_welds_govern_in_hoop_and_the_shell_stage_counts_them_too(parts):
    content = study(shell__joint_efficiency=0.1, methods=["janssen"])
    expansion = expanded(content)
    pressure = pressure_cube(expansion)
    cube = shell_cube(expansion, pressure)
    strong = shell_cube(parts[0], parts[1]).sel(pressure_method=["janssen"])
    for one, other in ((cube, strong),):
        hoop = one["check_utilisation"].sel(check="hoop_tension").values
        np.testing.assert_allclose(hoop, 8.5 * other["check_utilisation"].sel(check="hoop_tension").values, rtol=1e-12)
    assert list(cube["check"].values) == list(SOLID_CHECKS)
    wall = checks_cube(expansion, pressure)
    assert words(wall.isel(rule=0, pressure_method=0, wall_friction_end=0, strake=2), "design_strake_thickness_check") == (
        "hoop_tension"
    )


@pytest.fixture(scope="module")
def shaken(tmp_path_factory):
    folder = tmp_path_factory.mktemp("studies")
    (folder / "shaken.yaml").write_text(yaml.safe_dump(SHAKEN, sort_keys=False))
    content = copy.deepcopy(STUDY) | {"earthquake": {"study": "shaken"}, "methods": ["janssen"]}
    content["checks"] = {"earthquake": {"behaviour_factor": 1.5, "solids_factor": 0.8, "overstrength": 1.2}}
    content["scene"]["anchors"] = {"count": 20, "circle_diameter_m": 8.0, "resistance_kN": 100.0}
    expansion = expanded(content, folder)
    seismic = seismic_cube(expand(SHAKEN, "shaken", "shaken.yaml", folder))
    return seismic, checks_cube(expansion, pressure_cube(expansion), seismic)


def test_earthquake_by_its_factors(shaken):
    """Pressed: 0.8 solid + demand / q; lifted: less of both; shear V/(q pi r); anchors with the overstrength, no solid."""
    seismic, cube = shaken
    one_all = seismic.sel(mass_choice="eighty_percent")
    one, foot = one_all.isel(relative_depth=-1), cube.isel(pressure_method=0, place=-1)
    pressed, lifted, plain = (foot.sel(combination=key) for key in ("EP", "EL", "F"))
    solid, demand = float(plain["design_axial_wall_force"]) / 1.5, float(one["seismic_axial_wall_force"]) / 1.5
    assert float(pressed["design_axial_wall_force"]) == pytest.approx(0.8 * solid + demand, rel=1e-9)
    assert float(lifted["design_axial_wall_force"]) == pytest.approx(0.8 * solid - demand, rel=1e-9)
    added = float(one["seismic_wall_pressure"]) / 1.5
    static = float(plain["design_upper_pressure"]) / 1.5
    assert float(pressed["design_upper_pressure"]) == pytest.approx(0.8 * static + added, rel=1e-9, abs=1.0)
    wall = cube.isel(pressure_method=0, place=cube.sizes["place"] // 2)  # 10 m down, where strakes meet
    added = float(np.interp(wall["place_depth"], one_all["depth"], one_all["seismic_wall_pressure"])) / 1.5
    steady = float(wall["design_lower_pressure"].sel(combination="F"))
    assert added > 1e3
    assert float(wall["design_lower_pressure"].sel(combination="EP")) == pytest.approx(0.8 * steady, rel=1e-12)
    assert float(wall["design_lower_pressure"].sel(combination="EL")) == pytest.approx(0.8 * steady - added, rel=1e-9)
    shear = float(one["wall_shear_force"]) / 1.5 / (np.pi * 4.0)
    assert float(pressed["design_shear_wall_force"]) == pytest.approx(shear, rel=1e-9)
    assert float(pressed["anchor_tension"]) == pytest.approx(1.2 * demand * np.pi * 8.0 / 20, rel=1e-9)
    assert "not checked in EP" not in "\n".join(unchecked(cube))


def test_a_strake_that_a_check_cannot_judge_has_no_utilisation_and_no_thickness():
    """Class C: wind and shear cannot be checked, and what the other checks ask for is no answer."""
    cube = cube_of(study(levels=3, shell__quality="C", methods=["janssen"]))
    for name in ("design_thickness", "design_utilisation", "design_strake_thickness", "design_strake_utilisation"):
        assert cube[name].isnull().all()
    assert cube["design_check_utilisation"].sel(steel_check="hoop_tension", combination="D").notnull().any()


def test_pressures_that_differ_round_the_wall_are_not_checked_as_even_ones():
    silo = {"silo__outlet_eccentricity_m": 2.0, "silo__action_assessment_class": 3}
    cube = cube_of(study(levels=3, methods=["en1991_4", "en1991_4_eccentric"], **silo))
    one = cube.sel(pressure_method="en1991_4_eccentric")
    assert one["design_utilisation"].where(one["place_depth"] > 0).isnull().all()
    assert cube["design_utilisation"].sel(pressure_method="en1991_4").notnull().any()
    assert any(line.startswith("en1991_4_eccentric: not checked: pressures differ") for line in unchecked(cube))
