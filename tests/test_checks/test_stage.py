"""The stage of the checks: actions by hand, both sides of every edge, thickness used to the full, nothing passed silently."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
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
from silostudy.cube.governing import parts as parts_of
from silostudy.cube.unchecked import unchecked
from silostudy.errors import BadInput
from silostudy.figures import checks_over_depth, checks_summary, governing_cases
from silostudy.tables.combinations import COMBINATIONS
from silostudy.tables.constants import STANDARD_GRAVITY
from tests.conftest import ROOT, expanded
from tests.test_buckling.test_shell import STUDY
from tests.test_buckling.test_shell_earthquake import SHAKEN

SLENDER = ROOT / "config/studies/steel-wheat-checks.yaml"


def study(levels=7, **changes) -> dict:
    content = yaml.safe_load(SLENDER.read_text(encoding="utf-8"))
    content["outputs"], content["relative_depth"]["count"] = [], levels
    del content["loads"]
    content["rules"], content["methods"] = ["en1993_4_1_2007", "en1993_1_6_2007"], ["en1991_4", "janssen"]
    for key, value in changes.items():
        place, *inner = key.split("__")
        held = content["scene"] if place in content["scene"] or place not in content else content
        if inner:
            held[place][inner[0]] = value
        else:
            held[place] = value
    return content


def cube_of(content):
    expansion = expanded(content)
    return checks_cube(expansion, pressure_cube(expansion))


@pytest.fixture(scope="module")
def parts():
    expansion = expanded(study())
    pressure = pressure_cube(expansion)
    return expansion, pressure, checks_cube(expansion, pressure)


@pytest.fixture(scope="module")
def cube(parts):
    return parts[2]


def words(one, name):
    return one[name].attrs["flag_meanings"].split()[int(one[name])]


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


def test_hopper_hangs_in_equilibrium_in_the_cube(parts):
    """EN 1991-4 after filling: the meridional force at the transition carries load and contents, less what the outlet bears."""
    _, pressure, cube = parts
    here = {"pressure_method": "en1991_4", "wall_friction_end": "upper"}
    forces, solid = cube.sel(here | {"combination": "F"}), pressure.sel(here | {"phase": "filling"})
    hanging = float(solid["hopper_weight"] + solid["transition_force"] - solid["outlet_force"])
    plate = 7850 * STANDARD_GRAVITY * 0.007 * np.pi * (3.0**2 - 0.3**2) / np.sin(np.pi / 6)
    found = float(forces["hopper_meridional_force"][0]) * 2 * np.pi * 3.0 * np.cos(np.pi / 6)
    assert found == pytest.approx(1.5 * hanging + 1.35 * plate, rel=2e-3)
    thin = study(hopper_shell__thickness_mm=float(cube["hopper_required_thickness"].max()) * 1e3, methods=["en1991_4"])
    assert float(cube_of(thin)["hopper_check_utilisation"].max()) == pytest.approx(1, rel=0.02)
    ring = float(forces["transition_ring_force"])
    assert ring == pytest.approx(float(forces["hopper_meridional_force"][0]) * 3.0 * 0.5, rel=1e-12)


@pytest.mark.parametrize("phase", ["filling", "discharge"])
def test_every_method_s_hopper_hangs_in_equilibrium(phase):
    """Contents and load less the outlet's force, the ring force of Jenike's switch included, for every method in balance."""
    own = [{"combination": "A", "leading": "solids", "contents": "full", "permanent": 0.0, "solids": 1.0}]
    content = study(checks={"combinations": own}, methods=["jenike_mass_flow", "en1991_4", "jenike_1969"])
    content["scene"] |= {"wall_friction_end": "mean", "properties": {"effective_friction_angle_deg": 45.0}}
    content["scene"]["silo"]["hopper"]["half_angle_deg"] = 15.0
    content["hopper_position"]["count"], content["phases"] = 201, [phase]
    expansion = expanded(content)
    pressure = pressure_cube(expansion)
    solid = pressure.isel(phase=0)
    hanging = (solid["hopper_weight"] + solid["transition_force"] - solid["outlet_force"]).values
    top = checks_cube(expansion, pressure)["hopper_meridional_force"].isel(combination=0, hopper_position=0).values
    found = top * 2 * np.pi * 3.0 * np.cos(np.radians(15.0))
    balanced = np.isfinite(hanging) & (np.abs(solid["hopper_balance"].values) < 1e-6)
    assert balanced.sum() >= 2
    np.testing.assert_allclose(found[balanced], hanging[balanced], rtol=2e-3)


def test_anchors_by_hand(cube):
    """4 M/(n d) - W/n with the roof and the steel alone, and the wind's higher harmonics with a held top."""
    one = cube.sel(combination="WE", pressure_method="janssen", wall_friction_end="upper")
    weight = 7850 * STANDARD_GRAVITY * 18 * (0.33 * 4 + 0.33 * 5 + 0.34 * 7) * 1e-3 * 6 * np.pi + 30e3
    moment = 1.5 * 0.7 * 900 * 6 * 18**2 / 2
    higher = 1.5 * 900 * 18**2 / 6 / 4 * (4 * 0.8 + 9 * 0.3 - 16 * 0.1 - 25 * 0.05)
    by_hand = moment * 4 / (24 * 6.2) - weight / 24 + higher * np.pi * 6.0 / 24  # 6.2 m, the circle of the anchors
    assert float(one["anchor_tension"]) == pytest.approx(by_hand, rel=1e-9)


def test_few_anchors_are_no_elastic_ring():
    content = study(anchors__count=7, methods=["janssen"])
    scope = cube_of(content)["support_check_utilisation_scope"].sel(support_check="anchors", combination="WE")
    assert {scope.attrs["flag_meanings"].split()[flag] for flag in np.unique(scope)} == {"out_of_range"}


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


def test_a_check_out_of_its_range_names_the_limit(tmp_path, capsys):
    path = tmp_path / "rough.yaml"
    path.write_text(yaml.safe_dump(study(levels=3, shell__quality="C", methods=["janssen"]), sort_keys=False))
    assert main(["compare", str(path)]) == 0
    said = capsys.readouterr().out
    assert "note: shear_buckling_2007: out of range where not t/r <= 0.05" in said
    assert "Q >= 25 (alpha 0.65 of class B" in said
    assert " nan" not in said


def test_a_strake_that_a_check_cannot_judge_has_no_utilisation_and_no_thickness():
    """Class C: wind and shear cannot be checked, and what the other checks ask for is no answer."""
    cube = cube_of(study(levels=3, shell__quality="C", methods=["janssen"]))
    for name in ("design_thickness", "design_utilisation", "design_strake_thickness", "design_strake_utilisation"):
        assert cube[name].isnull().all()
    assert cube["design_check_utilisation"].sel(steel_check="hoop_tension", combination="D").notnull().any()


def test_a_strake_as_thin_as_paper_is_told(tmp_path, capsys):
    path = tmp_path / "thin.yaml"
    strakes = [{"down_to": 0.5, "thickness_mm": 0.004}, {"down_to": 1.0, "thickness_mm": 5.0}]
    path.write_text(yaml.safe_dump(study(levels=3, shell__strakes=strakes), sort_keys=False))
    assert main(["check", str(path)]) == 0
    assert "thickness_mm = 0.004 is unusual: mostly 0.5 to 60" in capsys.readouterr().out


def test_pressures_that_differ_round_the_wall_are_not_checked_as_even_ones():
    silo = {"silo__outlet_eccentricity_m": 2.0, "silo__action_assessment_class": 3}
    cube = cube_of(study(levels=3, methods=["en1991_4", "en1991_4_eccentric"], **silo))
    one = cube.sel(pressure_method="en1991_4_eccentric")
    assert one["design_utilisation"].where(one["place_depth"] > 0).isnull().all()
    assert cube["design_utilisation"].sel(pressure_method="en1991_4").notnull().any()
    assert any(line.startswith("en1991_4_eccentric: not checked: pressures differ") for line in unchecked(cube))


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
