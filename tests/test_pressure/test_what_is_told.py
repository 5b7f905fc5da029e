"""What cannot be is refused, what hardly is is told, what lies beyond a method is masked with its reason."""

import copy
import os
import subprocess
import sys

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.commands.about import cautions
from silostudy.compute.pressure import pressure_cube, silent_cube
from silostudy.cube.silence import silences
from silostudy.errors import BadInput
from tests.conftest import ROOT, expanded
from tests.test_pressure.silos import CONE, SLENDER, cube_of, study, why


@pytest.mark.parametrize(
    ("silo", "properties", "told"),
    [
        ({"outlet_eccentricity_m": 10.0}, {}, "scene.silo.outlet_eccentricity_m = 10.0: must not be above half"),
        ({"filling_eccentricity_m": 2.51}, {}, "scene.silo.filling_eccentricity_m = 2.51"),
        ({"top_cone_height_m": 60.0}, {}, "scene.silo.top_cone_height_m = 60.0: must not be above 9.33 m"),
        ({}, {"internal_friction_angle_deg": 85.0}, "scene.properties.a_phi = 1.12: must be below 1.059"),
        ({}, {"lateral_pressure_ratio": 45.0}, "lateral_pressure_ratio = 45.0: must be less than or equal to 5"),
        ({}, {"unit_weight_kN_m3": 667.0}, "unit_weight_kN_m3 = 667.0: must be less than 200"),
        ({}, {"unit_weight_lower_kN_m3": 9.5}, "unit_weight_lower_kN_m3 = 9.5: must not be above the unit weight, 9 kN m-3"),
    ],
)
def test_what_cannot_be_is_refused(silo, properties, told):
    with pytest.raises(BadInput) as caught:
        expanded(study(SLENDER | silo, properties=properties))
    assert told in str(caught.value)


@pytest.mark.parametrize(
    ("silo", "properties", "told"),
    [
        ({}, {"unit_weight_kN_m3": 0.8, "unit_weight_lower_kN_m3": 0.7}, "unit_weight_kN_m3 = 0.8 is unusual: mostly 2 to 40"),
        ({}, {"lateral_pressure_ratio": 1.2}, "lateral_pressure_ratio = 1.2 is unusual: mostly 0.2 to 1"),
        ({"diameter_m": 200.0}, {}, "diameter_m = 200 is unusual: mostly 0.05 to 60"),
        ({"cylinder_depth_m": 900.0}, {}, "slenderness = 180 is unusual"),
        ({"top_cone_height_m": 2.5}, {}, "a slope of 45.0 degrees, the solid's angle of repose is 34.0"),
    ],
)
def test_what_hardly_is_is_told(silo, properties, told):
    notes = cautions(expanded(study(SLENDER | silo, properties=properties)))
    assert any(told in note for note in notes), notes
    assert not any(told in note for note in cautions(expanded(study())))


def test_what_hardly_is_is_told_before_computing(tmp_path, capsys):
    path = tmp_path / "light.yaml"
    path.write_text(yaml.safe_dump(study(properties={"unit_weight_kN_m3": 0.8, "unit_weight_lower_kN_m3": 0.7})))
    assert main(["pressure", str(path), str(tmp_path / "pressure.nc")]) == 0
    assert capsys.readouterr().out.startswith("note: unit_weight_kN_m3 = 0.8 is unusual: mostly 2 to 40")


@pytest.mark.parametrize(
    ("silo", "words"),
    [
        ({"diameter_m": 200.0, "cylinder_depth_m": 90.0}, "d_c < 60 m"),
        ({"cylinder_depth_m": 55.0}, "h_b/d_c < 10"),
        ({"diameter_m": 12.0, "cylinder_depth_m": 101.0}, "h_b < 100 m"),
        ({"diameter_m": 10.0, "cylinder_depth_m": 3.5}, "h_c/d_c > 0.4"),
    ],
)
def test_what_lies_beyond_the_code_is_masked_and_told_before_and_after_computing(silo, words):
    expansion = expanded(study(SLENDER | silo, depth_m=(1.0, 3.0)))
    cube = pressure_cube(expansion)
    assert cube["wall_normal_pressure"].sel(pressure_method="en1991_4").isnull().all()
    for lines in (silences(cube), silences(silent_cube(expansion))):
        assert [line.split(":")[0] for line in lines] == ["en1991_4, filling", "en1991_4, discharge"]
        assert all(words in line for line in lines)


def test_a_lateral_ratio_above_one_gives_no_negative_friction_in_the_hopper():
    cube = cube_of(hopper=CONE | {"half_angle_deg": 60.0}, properties={"lateral_pressure_ratio": 1.2})
    assert why(cube, "hopper_friction_traction") == {"outside_published_range"}
    assert why(cube, "wall_normal_pressure") == {"in_scope"}


def test_a_method_without_its_property_or_phase_says_so():
    content = study(SLENDER, ("janssen", "deutsch"), solid="wheat", wall="as_cast_concrete") | {"phases": ["filling"]}
    assert silences(pressure_cube(expanded(content))) == ["deutsch: gives nothing: filling not covered by its source"]
    content = study(SLENDER, ("janssen", "en1991_4"), solid="wheat", wall="as_cast_concrete")
    assert silences(pressure_cube(expanded(content)))[0] == "en1991_4, filling: gives nothing: solid property missing"


def test_a_solid_without_lateral_pressure_is_computed_in_silence():
    """RuntimeWarnings of the package are errors in the tests."""
    content = study(hopper=CONE, properties={"lateral_pressure_ratio": 0.0, "poisson_ratio": 0.4})
    content |= {"methods": "all", "phases": ["filling", "switch", "discharge"]}
    cube = pressure_cube(expanded(content))
    assert (cube["wall_normal_pressure"].sel(pressure_method="janssen", phase="filling") == 0).all()
    assert cube["overpressure_factor"].sel(pressure_method="janssen").isnull().all()


def test_a_masked_balance_holds_no_weight():
    silo = {"plan": "square", "width_m": 4.0, "cylinder_depth_m": 18.0}
    cube = cube_of(silo, hopper=CONE)
    for name in ("hopper_weight", "hopper_wall_force", "hopper_balance"):
        assert cube[name].sel(pressure_method="en1991_4").isnull().all()
        assert why(cube, name) == {"plan_not_covered"}


def test_output_may_be_piped_to_a_reader_that_stops():
    reading, writing = os.pipe()
    os.close(reading)
    found = subprocess.run(
        [sys.executable, "-m", "silostudy", "list", "methods"],
        stdout=writing,
        stderr=subprocess.PIPE,
        text=True,
        cwd=ROOT,
        check=False,
    )
    os.close(writing)
    assert found.stderr == ""


def test_a_typo_among_methods_is_one_line():
    content = copy.deepcopy(study(methods=("janssn", "en1991_4")))
    with pytest.raises(BadInput) as caught:
        expanded(content)
    assert str(caught.value).count("\n") == 0
    assert "methods.0 = 'janssn': unknown; known: janssen" in str(caught.value)
