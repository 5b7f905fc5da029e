"""Checks beside buckling, own weight, safety and thin walls: faults found from outside, each with its right number."""

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.buckling import BUCKLING
from silostudy.buckling.family import REASONS
from silostudy.checks import CHECKS, NAMES, SOLID_CHECKS
from silostudy.checks.family import PARAMETERS, call
from silostudy.pressure.janssen import axial_wall_force, normal_pressure
from silostudy.tables.constants import STANDARD_GRAVITY
from tests.conftest import ROOT
from tests.test_buckling.silos import EN, SAFETY, SQUAT, WHEAT, cube_of, reason, strength


@pytest.mark.parametrize("rule", EN)
def test_thick_and_thinnest_shells_are_masked(rule):
    for slender in (0.4, 3.0, 19.9, 5001.0, 1e4):
        assert reason(rule, thickness=5.0 / slender) == "radius_over_thickness_out_of_range"


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


@pytest.mark.parametrize("rule", ["miller1977", "classical", "nasa_sp8007", *EN])
def test_no_rule_judges_a_wall_that_is_not_thin(rule):
    assert reason(rule, thickness=0.8 * 5.0) == "radius_over_thickness_out_of_range"
    assert reason(rule, thickness=5.0 / 20.1) == "in_scope"


def test_a_strake_that_is_no_thin_wall_is_masked_by_every_rule_and_check(capsys):
    """A strake of 0.8 r: no rule and no membrane force speaks for it."""
    strakes = [{"down_to": 0.5, "thickness_mm": 10.0}, {"down_to": 1.0, "thickness_mm": 4000.0}]
    cube = cube_of(rules=("miller1977", "classical", "en1993_1_6_2007"), steel={"strakes": strakes})
    for name in ("utilisation", "check_utilisation"):
        above, below = (cube[name].sel(relative_depth=part) for part in (slice(0.1, 0.5), slice(0.55, 1)))
        assert above.sel(phase="filling").notnull().all() if "phase" in above.dims else above.notnull().all()
        assert below.isnull().all()
        scope = cube[f"{name}_scope"].sel(relative_depth=1.0)
        assert "radius_over_thickness_out_of_range" in {REASONS[flag] for flag in np.unique(scope)}
    assert cube["largest_utilisation"].isnull().all()
    main(["explain", "hoop_tension"])
    assert "t/r <= 0.05" in capsys.readouterr().out


def test_a_thickness_that_the_checks_ask_for_beyond_a_thin_wall_is_masked():
    """Soft steel under much wheat: hoop tension asks for 1.15 of 30 m, membrane yield for more than r/20."""
    wide = {"plan": "circular", "diameter_m": 60.0, "slenderness": 4.0}
    cube = cube_of(rules=("classical",), silo=wide, steel={"yield_stress_MPa": 15.0}).isel(relative_depth=-1)
    assert cube["check_required_thickness"].isnull().values.tolist() == [check == "membrane_yield" for check in SOLID_CHECKS]
    assert cube["required_thickness"].isnull().all()
    assert REASONS[int(cube["required_thickness_scope"].squeeze())] == "radius_over_thickness_out_of_range"
