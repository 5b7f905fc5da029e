"""Strakes between the depths, and the ends of the wall friction: what was found from outside, with the right numbers."""

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.shell_ends import ENDS
from silostudy.errors import BadInput
from silostudy.pressure.janssen import axial_wall_force, normal_pressure
from tests.conftest import expanded
from tests.test_buckling.silos import SAFETY, SQUAT, WHEAT, cube_from, cube_of, study


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
