"""Faults of the shells that were found from outside: each with the small input that showed it, and the right number."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.buckling import BUCKLING
from silostudy.buckling.family import REASONS, evaluate
from silostudy.checks import CHECKS, NAMES
from silostudy.checks.family import PARAMETERS, call
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.shell_ends import ENDS
from silostudy.errors import BadInput
from silostudy.pressure.janssen import axial_wall_force, normal_pressure
from silostudy.tables.constants import STANDARD_GRAVITY
from tests.conftest import ROOT, expanded
from tests.test_buckling.shells import shell
from tests.test_buckling.test_studies import cylinder

EN = ("en1993_1_6_2007", "en1993_1_6_2025", "en1993_4_1_2007", "en1993_4_1_2025")
WHEAT = {"unit_weight": 9e3, "wall_friction": 0.38, "lateral_pressure_ratio": 0.54}
SAFETY = 1.65


def study(rules=EN, methods=("janssen",), sweep=(), levels=41, steel=None, **scene):
    """The steel wheat silo by Janssen, without the steel's own weight."""
    content = yaml.safe_load((ROOT / "config/studies/steel-wheat-strakes.yaml").read_text(encoding="utf-8"))
    content["scene"] |= scene
    content["scene"]["shell"] |= {"strakes": [], "density_kg_m3": 0.0} | (steel or {})
    content |= {"rules": list(rules), "methods": list(methods), "sweep": list(sweep), "outputs": []}
    content.pop("depth_m")
    return content | {"relative_depth": {"start": 0.0, "stop": 1.0, "count": levels}}


def cube_from(content):
    expansion = expanded(content)
    return shell_cube(expansion, pressure_cube(expansion)).squeeze("pressure_method")


def cube_of(**changes):
    return cube_from(study(**changes))


def thickness_mm(cube):
    return cube["largest_required_thickness"].values * 1e3


def strength(rule, **changes):
    return float(evaluate(BUCKLING[rule], shell(**changes))["buckling_stress"])


def reason(rule, **changes):
    return REASONS[int(evaluate(BUCKLING[rule], shell(**changes))["buckling_stress_scope"])]


def test_wires_do_not_thin_the_wall():
    rules = ("miller1977", *EN)
    bare = cube_of(rules=rules)
    wired = cube_of(rules=rules, steel={"rings": {"spacing_m": 0.05, "area_cm2": 0.01}})
    np.testing.assert_allclose(thickness_mm(wired), thickness_mm(bare), rtol=1e-9)


@pytest.mark.parametrize("rule", EN[:2])
def test_only_a_ring_that_counts_ends_a_bay(rule):
    """A long shell: C_x of 2007 falls below 1; a ring that counts restores it, half of it does not."""
    wall = {"thickness": 0.05, "total_length": 300.0, "bay_length": 5.0}
    needed = (0.06 + 2 * (0.25 / 25) ** 2 / (1 - 0.09)) * 5.0 * 0.05
    found = {
        share: evaluate(BUCKLING[rule], shell(**wall, ring_area=share * needed))["supported_length"] for share in (0.999, 1.0)
    }
    expected = 300.0 if rule == "en1993_1_6_2007" else np.nan  # too long for what is known of 2025
    np.testing.assert_equal(float(found[0.999]), expected)
    assert float(found[1.0]) == 5.0


def test_a_ring_gives_no_factor_of_a_short_shell():
    """Rings do not hold the wall against turning, so C_x stays at 1 however near they stand."""
    found = evaluate(BUCKLING["en1993_1_6_2007"], shell(bay_length=0.2, ring_area=1.0))
    assert float(found["length_factor"]) == 1.0
    assert float(evaluate(BUCKLING["en1993_1_6_2007"], shell(bay_length=0.2))["length_factor"]) > 1


@pytest.mark.parametrize("rule", EN)
def test_thick_and_thinnest_shells_are_masked(rule):
    for slender in (0.4, 3.0, 19.9, 5001.0, 1e4):
        assert reason(rule, thickness=5.0 / slender) == "radius_over_thickness_out_of_range"


def test_what_counts_of_the_rings_is_told(tmp_path, capsys):
    path = tmp_path / "rings.yaml"
    path.write_text(yaml.safe_dump(study(steel={"rings": {"spacing_m": 0.05, "area_cm2": 0.01}})))
    assert main(["check", str(path)]) == 0
    assert "rings of 0.01 cm2 every 0.05 m count at most up to a wall of 0.333 mm" in capsys.readouterr().out


@pytest.mark.parametrize("bay", [0.05, 0.1, 3.0, 20.0, 90.0])
def test_the_silo_rule_has_no_factor_for_the_length(bay):
    assert strength("en1993_4_1_2007", thickness=0.005, bay_length=bay) / 1e6 == pytest.approx(21.4, abs=0.05)


def test_hoop_tension_is_one_of_the_checks():
    """Little friction and an excellent wall: the pressure asks for more steel than the axial force."""
    properties = yaml.safe_load((ROOT / "config/studies/steel-wheat-strakes.yaml").read_text())["scene"]["properties"]
    wall = {"quality": "A", "strakes": [{"down_to": 1.0, "thickness_mm": 2.0}]}
    cube = cube_of(properties=properties | {"wall_friction": 0.02}, steel=wall, rules=("miller1977", *EN))
    pressure = float(normal_pressure(20.0, **WHEAT | {"wall_friction": 0.02}, hydraulic_radius=2.5)) * SAFETY
    expected = pressure * 5.0 / (235e6 - pressure / 2)
    assert float(cube["check_required_thickness"].sel(check="hoop_tension").max()) == pytest.approx(expected, rel=1e-12)
    assert (cube["largest_required_thickness"] >= expected * (1 - 1e-12)).all()
    foot = cube.isel(relative_depth=-1)
    governed = {NAMES[flag] for flag in np.unique(foot["required_thickness_check"])}
    assert "membrane_yield" in governed
    used = float(foot["check_utilisation"].sel(check="hoop_tension"))
    assert used == pytest.approx(pressure * 5.001 / 0.002 / 235e6, rel=1e-12)
    assert (foot["utilisation"].max("phase") >= used).where(foot["utilisation"].notnull().any("phase"), True).all()


@pytest.mark.parametrize("row", CHECKS.values(), ids=list(CHECKS))
def test_a_check_is_a_sound_row(row, capsys):
    assert not list(row.faults())
    assert main(["explain", row.key]) == 0
    assert row.formula in capsys.readouterr().out
    wall = {name: value for name, (_, _, value) in PARAMETERS.items()} | {"wall_above": 2e6, "joint_efficiency": 0.7}
    if row.needed:
        assert row.utilisation(wall | {"thickness": call(row.needed, wall)}) == pytest.approx(1, rel=1e-12)


def test_axial_compression_beside_hoop_tension_yields_the_wall_sooner():
    """Little friction, D 20, H 80: the wall that hoop tension alone asks for yields under the axial force beside it."""
    properties = yaml.safe_load((ROOT / "config/studies/steel-wheat-strakes.yaml").read_text())["scene"]["properties"]
    silo = {"plan": "circular", "diameter_m": 20.0, "slenderness": 4.0}
    little = {"wall_friction": 0.02}
    steel = {"quality": "A", "density_kg_m3": 7850.0, "strakes": [{"down_to": 1.0, "thickness_mm": 40.0}]}
    cube = cube_of(properties=properties | little, silo=silo, steel=steel, rules=("en1993_1_6_2007",))
    pressure = float(normal_pressure(80.0, **WHEAT | little, hydraulic_radius=5.0)) * SAFETY
    force = float(axial_wall_force(80.0, **WHEAT | little, hydraulic_radius=5.0)) * SAFETY
    own = 7850 * STANDARD_GRAVITY * 80.0 * SAFETY

    def yields(thickness):
        axial, hoop = force / thickness + own, pressure * (10.0 + thickness / 2) / thickness
        return np.sqrt(axial**2 + hoop**2 + axial * hoop) / 235e6

    foot = cube.isel(relative_depth=-1).sel(check="membrane_yield")
    assert yields(float(foot["check_required_thickness"])) == pytest.approx(1, rel=1e-9)
    assert float(foot["check_utilisation"]) == pytest.approx(yields(0.04), rel=1e-9)
    assert float(cube["largest_required_thickness"].squeeze()) == pytest.approx(
        float(foot["check_required_thickness"]), rel=1e-9
    )
    assert float(foot["check_required_thickness"]) > 1.05 * float(
        cube["check_required_thickness"].sel(check="hoop_tension").max()
    )


def test_no_wall_is_thick_enough_where_its_own_weight_yields_it():
    wall = {name: value for name, (_, _, value) in PARAMETERS.items()} | {"wall_above": 236e6}
    assert np.isinf(call(CHECKS["membrane_yield"].needed, wall))


def test_both_ends_of_a_strake_are_evaluated_between_the_depths():
    """20 levels, an edge between two of them: the foot of the upper strake, by Janssen's closed form."""
    strakes = [{"down_to": 0.47, "thickness_mm": 4.0}, {"down_to": 1.0, "thickness_mm": 15.0}]
    cube = cube_of(levels=20, steel={"strakes": strakes}, rules=("miller1977",)).sel(phase="filling", rule="miller1977")
    one = cube.sel(strake=1, strake_end="foot")
    force = float(axial_wall_force(9.4, **WHEAT, hydraulic_radius=2.5))
    stress = float(one["strake_wall_buckling_stress"])
    assert float(one["strake_depth"]) == pytest.approx(9.4)
    assert float(one["strake_axial_wall_force"]) == pytest.approx(force, rel=1e-5)
    assert float(one["strake_utilisation"]) == pytest.approx(SAFETY * force / 0.004 / stress, rel=1e-5)
    assert float(cube["largest_utilisation"]) == pytest.approx(float(one["strake_utilisation"]), rel=1e-12)
    assert float(cube["utilisation"].max()) < 0.97 * float(one["strake_utilisation"])
    below = cube.sel(strake=2, strake_end="top")
    assert float(below["strake_axial_wall_force"]) == float(one["strake_axial_wall_force"])
    assert float(below["strake_axial_wall_stress"]) == pytest.approx(force / 0.015, rel=1e-5)


def test_levels_that_end_above_the_foot_say_so():
    content = study(steel={"strakes": [{"down_to": 1.0, "thickness_mm": 9.0}]})
    content["relative_depth"] = {"start": 0.0, "stop": 0.9, "count": 10}
    expansion = expanded(content)
    cube = shell_cube(expansion, pressure_cube(expansion)).sel(strake=1, strake_end="foot", phase="filling")
    meanings = cube["strake_utilisation_scope"].attrs["flag_meanings"].split()
    assert {meanings[flag] for flag in np.unique(cube["strake_utilisation_scope"])} == {"load_or_pressure_masked"}


SQUAT = {"plan": "circular", "diameter_m": 30.0, "slenderness": 1.0}


def test_the_lower_end_governs_where_the_foot_yields():
    strakes = {"strakes": [{"down_to": 1.0, "thickness_mm": 15.0}]}
    cube = cube_of(silo=SQUAT, steel=strakes, wall_friction_end="both")
    assert list(cube["wall_friction_end"].values) == ["lower", "upper"]
    used = cube["strake_utilisation"].max(["phase", "strake", "strake_end"])
    for rule, end in (("en1993_1_6_2007", "upper"), ("en1993_4_1_2007", "lower")):
        one = cube.sel(rule=rule)
        assert {ENDS[flag] for flag in one["largest_utilisation_friction_end"].values} == {end}
        assert float(used.sel(rule=rule, wall_friction_end=end)) == pytest.approx(float(one["largest_utilisation"][0]))
        assert float(used.sel(rule=rule).min()) < float(one["largest_utilisation"][0])


def test_the_lower_end_is_the_largest_pressure():
    force, pressure = {}, {}
    for end in ("mean", "lower", "upper"):
        cube = cube_of(wall_friction_end=end).isel(relative_depth=-1).sel(phase="filling")
        force[end], pressure[end] = float(cube["axial_wall_force"]), float(cube["upper_internal_pressure"])
    lower = WHEAT | {"wall_friction": 0.38 / 1.16, "lateral_pressure_ratio": 0.54 * 1.11}
    assert pressure["lower"] == pytest.approx(float(normal_pressure(20.0, **lower, hydraulic_radius=2.5)), rel=1e-12)
    assert max(pressure, key=pressure.get) == "lower"
    assert max(force, key=force.get) == "upper"


def test_ends_that_are_not_known_are_refused():
    with pytest.raises(BadInput, match="wall_friction_end = 'lower': Pieper's roughness groups have no lower end"):
        expanded(study(wall="roughness_2", properties={}, wall_friction_end="lower"))
    axis = {"axis": "end", "values": {"wall_friction_end": ["mean", "both"]}}
    with pytest.raises(BadInput, match="wall_friction_end = 'both': is an axis of its own"):
        expanded(study(sweep=[axis]))


def test_the_edition_of_2025_has_no_long_branch():
    wall = {"shell_radius": 5.0, "thickness": 5.0 / 300}
    assert strength("en1993_1_6_2025", **wall, bay_length=100.0) / 1e6 == pytest.approx(121.2, abs=0.05)
    longest = 1.43 * 300 * np.sqrt(5.0 * 5.0 / 300)
    assert reason("en1993_1_6_2025", **wall, bay_length=longest * 1.001) == "length_out_of_range"
    assert "mix of editions" in BUCKLING["en1993_4_1_2025"].range


def test_own_weight_roof_and_snow_press_the_wall():
    strakes = [{"down_to": 0.5, "thickness_mm": 6.0}, {"down_to": 1.0, "thickness_mm": 9.0}]
    bare = cube_of(steel={"strakes": strakes})
    loads = {"strakes": strakes, "density_kg_m3": 7850.0, "roof_kN": 100.0, "snow_kPa": 1.0}
    cube = cube_of(steel=loads)
    roof = 100e3 / (2 * np.pi * 5.0) + 1e3 * 5.0 / 2
    weight = 7850 * STANDARD_GRAVITY * (10 * 0.006 + 10 * 0.009)
    foot = {"relative_depth": -1}
    more = (cube["axial_wall_stress"] - bare["axial_wall_stress"]).isel(foot).sel(phase="filling")
    assert float(more) * 0.009 == pytest.approx(weight + roof, rel=1e-9)
    assert float(cube["own_weight_axial_force"].isel(foot)) == pytest.approx(weight, rel=1e-12)
    assert float(cube["imposed_axial_force"]) == pytest.approx(roof, rel=1e-12)
    rule = "en1993_1_6_2007"  # the thickness carries its own weight
    one = cube.sel(rule=rule).isel(foot)
    t = float(one["required_thickness"])
    force = float(bare["axial_wall_force"].isel(foot).sel(phase="filling")) + roof + 7850 * STANDARD_GRAVITY * 20 * t
    assert SAFETY * force / t == pytest.approx(strength(rule, shell_radius=5 + t / 2, thickness=t, bay_length=20.0), rel=1e-6)


def test_the_safety_factor_multiplies_the_pressure_under_which_the_foot_yields():
    rule = "en1993_4_1_2007"
    cube = cube_of(silo=SQUAT, rules=(rule,)).isel(relative_depth=-1).sel(rule=rule, phase="filling")
    t, p = float(cube["required_thickness"]), float(cube["upper_internal_pressure"])
    wall = {"shell_radius": 15 + t / 2, "thickness": t, "lower_internal_pressure": p}
    stress = SAFETY * float(cube["axial_wall_force"]) / t
    assert strength(rule, **wall, upper_internal_pressure=SAFETY * p) == pytest.approx(stress, rel=1e-6)
    assert strength(rule, **wall, upper_internal_pressure=p) > 1.05 * stress
    assert "safety_factor multiplies" in "\n".join(_explained(rule))


def _explained(rule):
    from silostudy.commands.explain_buckling import explanation

    return explanation(BUCKLING[rule])


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"thickness_mm": 12000.0}, "thickness_mm must be below the radius, 5000 mm"),
        ({"yield_stress_MPa": 235e6}, "scene.yield_stress_MPa = 235000000.0: must be less than or equal to 3000"),
        ({"youngs_modulus_GPa": 210e9}, "scene.youngs_modulus_GPa = 210000000000.0: must be less than or equal to 2000"),
    ],
)
def test_what_no_steel_can_be_is_refused(changes, told):
    with pytest.raises(BadInput) as caught:
        expanded(cylinder(**changes))
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_strake_thicker_than_the_radius_is_refused():
    with pytest.raises(BadInput, match=r"strakes\.0\.thickness_mm = 5000\.0: must be below the silo's radius, 5000 mm"):
        expanded(study(steel={"strakes": [{"down_to": 1.0, "thickness_mm": 5000.0}]}))


@pytest.mark.parametrize("rules", ["en", ["en"]])
def test_an_unknown_rule_tells_the_known_ones(rules):
    with pytest.raises(BadInput, match="known: miller1977, classical, nasa_sp8007"):
        expanded(cylinder() | {"rules": rules})


def test_compare_takes_studies_of_steel(tmp_path, capsys):
    path = tmp_path / "shell.yaml"
    path.write_text(yaml.safe_dump(study(steel={"strakes": [{"down_to": 1.0, "thickness_mm": 9.0}]}, wall_friction_end="both")))
    assert main(["compare", str(path)]) == 0
    said = capsys.readouterr().out
    (line,) = (line for line in said.splitlines() if line.startswith("janssen, en1993_1_6_2007"))
    assert line.split()[3] == "mm"
    assert line.split()[4:6] == ["buckling", "upper"]
    path.write_text(yaml.safe_dump(copy.deepcopy(cylinder())))
    assert main(["compare", str(path)]) == 0
    assert "nasa_sp8007" in capsys.readouterr().out
    assert main(["compare", str(ROOT / "config/studies/steel-wheat-earthquake.yaml")]) == 0
    assert "eighty_percent" in capsys.readouterr().out
    assert main(["compare", str(ROOT / "config/studies/stability-map.yaml")]) == 2
    assert "compare takes studies of kind buckling, pressure, seismic, shell" in capsys.readouterr().err


def test_an_earthquake_needs_a_flat_bottom():
    content = yaml.safe_load((ROOT / "config/studies/steel-wheat-shaken.yaml").read_text(encoding="utf-8"))
    content["scene"]["silo"]["hopper"] = {"half_angle_deg": 45.0}
    from silostudy.choice.expand import expand

    with pytest.raises(BadInput, match="needs a flat bottom"):
        expand(content, "shaken", "shaken.yaml", ROOT / "config/studies")


def test_a_wall_too_thick_for_the_limit_of_length_does_not_end_the_search():
    """H/D 4: R/t 20 is beyond 1.43 for 2025, the thickness sought is not; at H/D 40 every wall that carries is beyond it."""
    cube = cube_of(rules=("en1993_1_6_2025",), silo={"plan": "circular", "diameter_m": 10.0, "slenderness": 4.0})
    foot = float(cube["required_thickness"][0, -1])
    force = axial_wall_force(40.0, hydraulic_radius=2.5, **WHEAT)
    carried = strength("en1993_1_6_2025", shell_radius=5 + foot / 2, thickness=foot, bay_length=40.0, yield_stress=235e6)
    assert SAFETY * force / foot == pytest.approx(carried, rel=1e-9)
    tall = cube_of(rules=("en1993_1_6_2025",), silo={"plan": "circular", "diameter_m": 3.0, "slenderness": 40.0})
    assert np.isnan(tall["required_thickness"][0, -1])
    assert REASONS[int(tall["required_thickness_scope"][0, -1])] == "length_out_of_range"


@pytest.mark.parametrize("where", [0, 2])
def test_a_strake_beyond_a_rule_leaves_the_whole_wall_unjudged(where, tmp_path, capsys):
    """A strake of 0.9 mm, R/t 5556, under sound ones: not .970, the most used of the rest."""
    strakes = [{"down_to": down_to, "thickness_mm": 12.0} for down_to in (0.25, 0.5, 0.75, 1.0)]
    strakes[where]["thickness_mm"] = 0.9
    content = study(rules=("miller1977", "en1993_1_6_2007"), steel={"strakes": strakes})
    cube = cube_from(content)
    assert np.isnan(cube["largest_utilisation"].sel(rule="en1993_1_6_2007"))
    assert float(cube["largest_utilisation"].sel(rule="miller1977")) > 5
    (tmp_path / "thin.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    main(["compare", str(tmp_path / "thin.yaml")])
    assert "masked: radius over thickness out of range in a part of the wall" in capsys.readouterr().out


def test_rings_further_apart_than_the_wall_is_high_are_refused():
    with pytest.raises(BadInput, match=r"spacing_m.*30.*must not exceed the height of the wall, 20 m"):
        cube_of(steel={"rings": {"spacing_m": 30.0, "area_cm2": 50.0}})


def test_compare_tells_what_of_the_wall_is_not_looked_at_and_which_rings_are_left_out(tmp_path, capsys):
    content = study(steel={"rings": {"spacing_m": 0.05, "area_cm2": 0.01}}) | {"depth_m": [10.0]}
    content.pop("relative_depth")
    (tmp_path / "short.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    main(["compare", str(tmp_path / "short.yaml")])
    told = capsys.readouterr().out
    assert "depths end at 10 m, the wall at 20 m" in told
    assert "note: rings of 0.01 cm2 every 0.05 m" in told


def test_a_density_in_other_units_is_refused():
    with pytest.raises(BadInput, match=r"density_kg_m3.*7\.85.*must be 0, or 1000 to 20000"):
        cube_of(steel={"density_kg_m3": 7.85})
