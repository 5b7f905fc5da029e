"""What no steel can be is refused in one line, and compare tells what it shows of a wall and what not."""

import copy

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.errors import BadInput
from tests.conftest import ROOT, expanded
from tests.test_buckling.silos import cube_of, study
from tests.test_buckling.test_studies import cylinder


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
