"""Right values where an independent check found wrong ones: wall pressures and hoppers, each from a small input."""

import copy
import os
import subprocess
import sys

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.commands.about import cautions
from silostudy.compute.pressure import pressure_cube, silent_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.shell_load import internal_pressures
from silostudy.cube.silence import silences
from silostudy.errors import BadInput
from silostudy.pressure.family import REASONS
from tests.conftest import ROOT, expanded

SLENDER = {"plan": "circular", "diameter_m": 5.0, "cylinder_depth_m": 18.0}
CONE = {"half_angle_deg": 45.0, "outlet_width_m": 0.5}


def study(silo=SLENDER, methods=("janssen", "en1991_4"), depth_m=(9.0, 18.0), hopper=None, **scene):
    silo = silo | ({"hopper": hopper} if hopper else {})
    content = {"kind": "pressure", "title": "a fault", "scene": {"silo": silo, "solid": "wheat_e1", "wall": "d2"} | scene}
    content |= {"methods": list(methods), "depth_m": list(depth_m)}
    return content | ({"hopper_position": [0.0, 0.5, 1.0]} if hopper else {})


def cube_of(*args, **kwargs):
    return pressure_cube(expanded(study(*args, **kwargs)))


def on_wall(cube, quantity="wall_normal_pressure", method="en1991_4", phase="filling", **where):
    return float(cube[quantity].sel(pressure_method=method, phase=phase, **where)) / 1e3


def why(cube, name, method="en1991_4", phase="filling"):
    return {REASONS[flag] for flag in np.unique(cube[f"{name}_scope"].sel(pressure_method=method, phase=phase).values)}


def test_an_end_of_the_wall_friction_leaves_the_sets_of_en_1991_4():
    content = study(wall_friction_end="upper")
    cube = pressure_cube(expanded(content))
    assert on_wall(cube, depth=18.0) == pytest.approx(32.31, abs=0.005)
    assert on_wall(cube, "vertical_pressure", depth=18.0) == pytest.approx(63.48, abs=0.005)
    assert float(cube["wall_friction"].sel(pressure_method="janssen")) == pytest.approx(0.38 * 1.16)  # it moves others
    assert any("wall_friction_end: upper does not move en1991_4" in line for line in cautions(expanded(content)))


def test_pieper_for_buckling_counts_its_addition_once():
    methods = ("pieper_flour", "pieper_flour_buckling")
    flour = {"solid": "flour_e1", "wall": "roughness_2"}
    mean, upper = (cube_of(methods=methods, wall_friction_end=end, **flour) for end in ("mean", "upper"))
    force = "axial_wall_force"
    buckling = {"method": "pieper_flour_buckling", "depth": 18.0}
    assert on_wall(upper, force, **buckling) == pytest.approx(on_wall(mean, force, **buckling), rel=1e-14)
    assert on_wall(upper, force, "pieper_flour", depth=18.0) == pytest.approx(on_wall(mean, force, **buckling), rel=1e-12)


@pytest.mark.parametrize(
    ("solid", "wall", "angle"), [("wheat_e1", "d1", 45.0), ("wheat_e1", "d1", 50.9), ("cement_e1", "d2", 25.0)]
)
def test_the_hopper_has_one_class_by_the_lower_k_and_mu(solid, wall, angle):
    """Between the limits with upper and lower K the hopper is steep, in discharge too."""
    cube = cube_of(hopper=CONE | {"half_angle_deg": angle}, solid=solid, wall=wall)
    assert (cube["hopper_steep"].sel(pressure_method="en1991_4") == 1).all()
    one = cube.sel(pressure_method="en1991_4", phase="discharge")
    ratio = one["hopper_normal_pressure"] / one["hopper_vertical_pressure"]
    assert ratio.values == pytest.approx(np.full(3, float(one["hopper_pressure_ratio"])))
    assert (
        float(one["hopper_pressure_ratio"])
        > 1
        > float(cube["hopper_pressure_ratio"].sel(pressure_method="en1991_4", phase="filling"))
    )


def test_a_shallow_hopper_is_shallow_in_both_phases():
    cube = cube_of(hopper=CONE | {"half_angle_deg": 51.2}, wall="d1").sel(pressure_method="en1991_4")
    assert (cube["hopper_steep"] == 0).all()
    assert float(cube["hopper_exponent"][0]) == float(cube["hopper_exponent"][1])


def test_a_level_surface_touches_the_wall_from_the_top():
    squat = {"plan": "circular", "diameter_m": 10.0, "cylinder_depth_m": 6.5}
    cube = cube_of(squat, ("en1991_4", "en1991_4_wall_friction"), (1e-3, 1.65))
    assert on_wall(cube, method="en1991_4_wall_friction", depth=1.65) == pytest.approx(12.05, abs=0.005)
    assert on_wall(cube, method="en1991_4", depth=1e-3) > 0
    assert float(cube["contact_depth"]) == 0


@pytest.mark.parametrize(
    ("silo", "share"),
    [
        (SLENDER, 1 / 3),
        ({"plan": "square", "width_m": 4.0, "cylinder_depth_m": 18.0}, 1 / 3),
        ({"plan": "slot", "width_m": 4.0, "cylinder_depth_m": 18.0}, 1 / 2),
        ({"plan": "rectangular", "width_m": 4.0, "length_m": 8.0, "cylinder_depth_m": 18.0}, 5 / 12),
    ],
)
def test_one_height_of_the_heap_moves_surface_contact_and_transition(silo, share):
    cube = cube_of(silo | {"top_cone_height_m": 0.9}, ("janssen",), (0.9 * share - 1e-9, 0.9 * share + 1e-9))
    assert float(cube["contact_depth"]) == pytest.approx(0.9 * share)
    assert float(cube["cylinder_depth"]) == pytest.approx(18 + 0.9 * share)
    flags = cube["wall_normal_pressure_scope"].sel(pressure_method="janssen", phase="filling").values
    assert [REASONS[flag] for flag in flags] == ["above_wall_contact", "in_scope"]


def test_mu_cut_to_tan_phi_is_told_and_may_stay_uncut():
    def used(**scene):
        one = cube_of(wall="d3", **scene).sel(pressure_method="en1991_4", phase="filling", used_for="wall_friction_traction")
        return tuple(float(one[f"used_wall_friction{end}"]) for end in ("", "_uncapped", "_capped"))

    assert used() == pytest.approx((0.505, 0.661, 1), abs=5e-4)
    assert used(characteristic_friction="uncapped") == pytest.approx((0.661, 0.661, 0), abs=5e-4)
    cut, uncut = (cube_of(wall="d3", characteristic_friction=how) for how in ("capped", "uncapped"))
    assert on_wall(uncut, "wall_friction_traction", depth=9.0) > on_wall(cut, "wall_friction_traction", depth=9.0)


def test_the_patch_of_a_circle_is_masked_elsewhere_and_a_band_goes_round_other_plans():
    square = cube_of({"plan": "square", "width_m": 4.0, "cylinder_depth_m": 18.0})
    for name in ("patch_resultant", "patch_pressure", "patch_depth"):
        assert why(square, name) == {"plan_not_covered"}
    one = square.sel(pressure_method="en1991_4", phase="filling")
    expected = 0.36 * float(one["patch_load_factor"]) * float(one["wall_normal_pressure"].sel(depth=9.0))
    assert float(one["band_pressure"]) == pytest.approx(expected)
    circle = cube_of()
    assert why(circle, "band_pressure") == {"plan_not_covered"}
    assert why(circle, "patch_resultant") == {"in_scope"}


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


ECCENTRIC = {"plan": "circular", "diameter_m": 6.0, "cylinder_depth_m": 18.0}


def test_large_eccentric_discharge_is_a_whole_load_case():
    cube = cube_of(ECCENTRIC | {"outlet_eccentricity_m": 2.0}, ("janssen", "en1991_4", "en1991_4_eccentric"))
    one = cube.sel(pressure_method="en1991_4_eccentric", phase="discharge")
    assert float(one["wall_normal_pressure"].sel(depth=18.0)) / 1e3 == pytest.approx(69.14, abs=0.005)
    channel, static, adjacent = (one[f"{zone}_normal_pressure"] for zone in ("channel", "static", "adjacent"))
    filling = cube["wall_normal_pressure"].sel(pressure_method="en1991_4", phase="filling")
    for size in (0.25, 0.40, 0.60):
        assert static.sel(channel=size).values == pytest.approx(filling.values)
    assert ((channel + adjacent) / 2).values == pytest.approx(static.values)  # the mean round the ring
    mu = 0.38 / 1.16
    for zone in ("channel", "static", "adjacent"):
        assert (one[f"{zone}_friction_traction"] / one[f"{zone}_normal_pressure"]).values == pytest.approx(np.full((3, 2), mu))
    assert one["channel_radius"].values == pytest.approx([0.75, 1.2, 1.8])
    assert (np.diff(one["channel_half_width"]) > 0).all()


@pytest.mark.parametrize("silo", [{"outlet_eccentricity_m": 1.5}, {"outlet_eccentricity_m": 2.0, "cylinder_depth_m": 2.4}])
def test_large_eccentric_discharge_is_masked_where_it_does_not_apply(silo):
    """Up to a quarter of the diameter, and in retaining silos."""
    cube = cube_of(ECCENTRIC | silo, ("janssen", "en1991_4_eccentric"), (1.0, 2.0))
    for name in ("wall_normal_pressure", "channel_normal_pressure", "adjacent_normal_pressure", "channel_half_width"):
        assert why(cube, name, "en1991_4_eccentric", "discharge") == {"outside_published_range"}


def test_heap_and_outlet_have_eccentricities_of_their_own():
    filling = cube_of(SLENDER | {"filling_eccentricity_m": 1.0})
    outlet = cube_of(SLENDER | {"outlet_eccentricity_m": 1.0})
    for phase, same in (("filling", False), ("discharge", True)):
        first, second = (on_wall(cube, "patch_pressure", phase=phase) for cube in (filling, outlet))
        assert (first == second) == same
    assert on_wall(outlet, "patch_pressure") == on_wall(cube_of(), "patch_pressure")


def test_the_shell_is_steadied_by_the_pressure_that_goes_with_the_force():
    content = yaml.safe_load((ROOT / "config/studies/steel-wheat-strakes.yaml").read_text(encoding="utf-8"))
    content["scene"]["properties"] |= {"a_phi": 1.12, "repose_angle_deg": 34.0, "patch_factor": 0.5}
    content |= {"sweep": [], "outputs": [], "methods": ["janssen", "en1991_4", "en1991_4_wall_friction"]}
    expansion = expanded(content)
    cube = pressure_cube(expansion)
    lower = internal_pressures(cube)[0][:, -1] / 1e3
    assert lower[1:] == pytest.approx([44.88, 44.88], abs=0.005)
    assert lower[0] == pytest.approx(float(cube["wall_normal_pressure"][0, 0, -1]) / 1e3)
    force = cube["axial_wall_force"].sel(phase="filling").values
    assert force[1] == pytest.approx(force[2])
    shell = shell_cube(expansion, cube)
    assert np.isfinite(shell["utilisation"].sel(pressure_method="en1991_4")).any()


def test_a_solid_without_lateral_pressure_is_computed_in_silence():
    """RuntimeWarnings of the package are errors in the tests."""
    content = study(hopper=CONE, properties={"lateral_pressure_ratio": 0.0, "poisson_ratio": 0.4})
    content |= {"methods": "all", "phases": ["filling", "switch", "discharge"]}
    cube = pressure_cube(expanded(content))
    assert (cube["wall_normal_pressure"].sel(pressure_method="janssen", phase="filling") == 0).all()
    assert cube["overpressure_factor"].sel(pressure_method="janssen").isnull().all()


def test_a_masked_balance_holds_no_weight():
    silo = {"plan": "polygonal", "sides": 8, "inscribed_diameter_m": 4.0, "cylinder_depth_m": 18.0}
    cube = cube_of(silo, hopper=CONE)
    for name in ("hopper_weight", "hopper_wall_force", "hopper_balance"):
        assert cube[name].sel(pressure_method="en1991_4").isnull().all()
        assert why(cube, name) == {"plan_not_covered"}


def test_the_numbers_behind_the_numbers():
    cube = cube_of(
        hopper=CONE | {"half_angle_deg": 20.0}, methods=("janssen", "en1991_4", "caquot", "din1055_1964", "as3774_1996")
    )
    one = cube.sel(pressure_method="en1991_4", phase="discharge", used_for="wall_normal_pressure")
    mu, k = 0.38 / 1.16, 0.54 * 1.11
    assert (float(one["used_wall_friction"]), float(one["used_lateral_pressure_ratio"])) == pytest.approx((mu, k))
    assert float(one["depth_constant"]) == pytest.approx(1.25 / (mu * k))
    assert (float(one["normal_pressure_increase"]), float(one["wall_friction_increase"])) == pytest.approx((1.15, 1.10))
    assert float(one["slenderness_class"]) == 2
    p_v = cube.sel(pressure_method="en1991_4", phase="filling", used_for="vertical_pressure")
    assert float(p_v["used_internal_friction_angle"]) == pytest.approx(np.radians(30) * 1.12)
    for method, phase in (
        ("janssen", "filling"),
        ("caquot", "discharge"),
        ("din1055_1964", "filling"),
        ("as3774_1996", "filling"),
    ):
        one = cube.sel(pressure_method=method, phase=phase, used_for="wall_normal_pressure")
        mu, k, weight = (float(one[f"used_{name}"]) for name in ("wall_friction", "lateral_pressure_ratio", "unit_weight"))
        janssen = weight * 1.25 / mu * -np.expm1(-k * mu * 9.0 / 1.25)
        assert float(one["wall_normal_pressure"].sel(depth=9.0)) == pytest.approx(janssen), method


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
