"""Scenes: plans and their hydraulic radius, the equivalent surface, what each method is handed, and the cases of a study."""

from math import pi, radians, sin, sqrt, tan

import numpy as np
import pytest

from silostudy.compute.axes import sweep_of
from silostudy.errors import BadInput
from silostudy.scene.scene import Scene, geometry_parameters, solid_parameters
from silostudy.scene.silo import Hopper, Silo
from silostudy.tables.solids import SOLIDS
from silostudy.tables.walls import WALLS
from tests.conftest import expanded


def test_hydraulic_radius_of_every_plan():
    assert Silo(plan="circular", diameter=5.0, wall_depth=1.0).hydraulic_radius == pytest.approx(1.25)
    assert Silo(plan="square", diameter=4.0, wall_depth=1.0).hydraulic_radius == pytest.approx(16 / 16)
    assert Silo(plan="rectangular", diameter=4.0, length=6.0, wall_depth=1.0).hydraulic_radius == pytest.approx(24 / 20)
    hexagon = Silo(plan="polygonal", diameter=2.0, sides=6, wall_depth=1.0)
    side = 2 / sqrt(3)
    assert hexagon.perimeter == pytest.approx(6 * side)
    assert hexagon.area == pytest.approx(1.5 * sqrt(3) * side**2)
    assert hexagon.hydraulic_radius == pytest.approx(hexagon.area / hexagon.perimeter)


def test_circle_is_the_limit_of_polygons():
    many = Silo(plan="polygonal", diameter=3.0, sides=1000, wall_depth=1.0)
    assert many.area == pytest.approx(pi * 9 / 4, rel=1e-5)


def test_equivalent_surface_and_outlet():
    silo = Silo(
        plan="circular", diameter=5.0, wall_depth=18.0, top_cone_height=1.5, hopper=Hopper(half_angle=pi / 4, outlet_width=0)
    )
    assert silo.cylinder_depth == pytest.approx(18.5)
    assert silo.outlet_depth == pytest.approx(18.5 + 2.5)
    blunt = Silo(plan="circular", diameter=5.0, wall_depth=18.0, hopper=Hopper(half_angle=pi / 4, outlet_width=1.0))
    assert blunt.outlet_depth == pytest.approx(20.0)
    assert Silo(plan="circular", diameter=5.0, wall_depth=18.0).outlet_depth == pytest.approx(18.0)


def handed(study, method="janssen", as_printed=False):
    return solid_parameters(expanded(study).cases[0].scene, method, as_printed)


def test_wall_kinds_by_ratio_of_tangents_and_of_angles(study):
    study["scene"] |= {"solid": "wheat", "wall": "as_cast_concrete"}
    phi = 26 * pi / 180
    assert handed(study)["wall_friction"] == pytest.approx(0.75 * tan(phi))
    study["scene"]["wall"] = "roughness_2"
    assert WALLS["roughness_2"].rule == "angle_ratio"
    assert handed(study)["wall_friction"] == pytest.approx(tan(0.80 * phi))


def test_own_values_of_a_method_and_the_users(study):
    assert handed(study)["wall_friction"] == 0.44
    assert handed(study, "ty124_1956")["wall_friction"] == 0.4
    study["scene"]["properties"] = {"wall_friction": 0.3, "unit_weight_kN_m3": 9.0}
    assert handed(study, "ty124_1956")["wall_friction"] == 0.3
    assert handed(study, "caquot")["unit_weight"] == 9000.0


def test_misprints_only_on_request(study):
    assert handed(study, "din1055_1964")["internal_friction_angle"] == pytest.approx(30 * pi / 180)
    assert handed(study, "din1055_1964", as_printed=True)["internal_friction_angle"] == pytest.approx(3 * pi / 180)


def test_lateral_pressure_ratio_rules(study):
    phi = 30 * pi / 180
    assert handed(study)["lateral_pressure_ratio"] == 0.45
    study["scene"]["lateral_pressure_ratio_rule"] = "rankine"
    assert handed(study)["lateral_pressure_ratio"] == pytest.approx((1 - sin(phi)) / (1 + sin(phi)))
    study["scene"]["lateral_pressure_ratio_rule"] = "one_minus_sine"
    assert handed(study)["lateral_pressure_ratio"] == pytest.approx(1 - sin(phi))


def test_friction_is_capped_at_the_solids_own(study):
    study["scene"]["properties"] = {"wall_friction": 0.9}
    assert handed(study)["wall_friction"] == pytest.approx(tan(30 * pi / 180))


def test_grid_paired_axes_and_points(study):
    study["scene"]["solid"] = "wheat"
    study["scene"]["wall"] = "as_cast_concrete"
    study["sweep"] = [
        {"axis": "solid", "values": {"solid": ["wheat", "maize"]}},
        {"axis": "size", "values": {"silo.diameter_m": [3.0, 4.0, 5.0], "silo.cylinder_depth_m": [18.0, 20.0, 22.0]}},
        {"axis": "place", "points": [{"wall": "grooved_concrete"}, {"wall": "painted_concrete"}]},
    ]
    expansion = expanded(study)
    assert expansion.shape == (2, 3, 2)
    assert len({case.id for case in expansion.cases}) == 12
    last = expansion.cases[-1]
    assert (last.scene.solid.key, last.scene.silo.diameter, last.scene.silo.wall_depth) == ("maize", 5.0, 22.0)
    assert last.scene.wall.key == "painted_concrete"


def test_a_sampled_plan_draws_once_from_each_part_of_every_range(study):
    """In 12 cases: one value in each twelfth of a range, in its logarithm too, and each choice equally often."""
    ranges = {
        "silo.diameter_m": {"start": 3.0, "stop": 6.0},
        "silo.cylinder_depth_m": {"start": 20.0, "stop": 80.0, "spacing": "log"},
        "wall": ["as_cast_concrete", "grooved_concrete", "painted_concrete"],
    }
    study["scene"]["solid"] = "wheat"
    study["sweep"] = [{"axis": "sample", "sample": {"count": 12, "seed": 3, "ranges": ranges}}]
    expansion = expanded(study)
    assert expansion.shape == (12,)
    silos = [case.scene.silo for case in expansion.cases]
    share = (np.array([silo.diameter for silo in silos]) - 3.0) / 3.0
    log_share = np.log(np.array([silo.wall_depth for silo in silos]) / 20.0) / np.log(4.0)
    for shares in (share, log_share):
        assert sorted((12 * shares).astype(int)) == list(range(12))
    assert not (np.argsort(share) == np.argsort(log_share)).all()
    walls = [case.scene.wall.key for case in expansion.cases]
    assert [walls.count(key) for key in ranges["wall"]] == [4, 4, 4]
    assert [case.id for case in expanded(study).cases] == [case.id for case in expansion.cases]
    study["sweep"][0]["sample"]["seed"] = 4
    assert not {case.id for case in expanded(study).cases} & {case.id for case in expansion.cases}


def test_a_sampled_plan_is_a_dimension_with_its_values_beside_it(study):
    ranges = {"silo.diameter_m": {"start": 3.0, "stop": 6.0}, "silo.cylinder_depth_m": {"start": 18.0, "stop": 20.0}}
    study["sweep"] = [{"axis": "sample", "sample": {"count": 5, "ranges": ranges}}]
    expansion = expanded(study)
    held = sweep_of(expansion).coordinates
    assert held["sample"][1].tolist() == [0, 1, 2, 3, 4]
    assert held["sample_diameter"][0] == "sample"
    assert held["sample_diameter"][1].tolist() == [case.scene.silo.diameter for case in expansion.cases]
    assert set(held) == {"sample", "sample_diameter", "sample_cylinder_depth"}


def test_ranges_and_slenderness(study):
    study.pop("depth_m")
    study["relative_depth"] = {"start": 0.1, "stop": 1.0, "count": 10}
    study["sweep"] = [
        {"axis": "slenderness", "values": {"silo.slenderness": {"start": 1, "stop": 4, "count": 3, "spacing": "log"}}}
    ]
    depths = [case.scene.silo.cylinder_depth for case in expanded(study).cases]
    assert depths == pytest.approx([5.0, 10.0, 20.0])


def test_case_ids_follow_the_scene_and_nothing_else(study):
    first = expanded(study).cases[0].id
    study["title"] = "another title"
    assert expanded(study).cases[0].id == first
    study["scene"]["silo"]["diameter_m"] = 5.1
    assert expanded(study).cases[0].id != first


def test_a_corrugated_wall_rubs_partly_on_the_solid_itself(study):
    study["scene"] |= {"wall": "d1", "solid": "wheat_e1", "wall_contact_share": 0.25}
    scene = expanded(study).cases[0].scene
    inside, sheet = tan(radians(30)), 0.24
    assert solid_parameters(scene, "")["wall_friction"] == pytest.approx(0.75 * inside + 0.25 * sheet)
    varied = solid_parameters(scene, "", varies={"wall_friction", "contact_share"})
    assert varied["wall_friction"] == sheet  # the method makes its own of it
    assert solid_parameters(scene, "")["hopper_wall_friction"] == sheet
    with pytest.raises(BadInput, match="uncertainty needs a flat wall"):
        expanded(study | {"uncertainty": {"log2_samples": 6}})


def test_volume_of_the_contents():
    cone = Silo(plan="circular", diameter=4.0, wall_depth=10.0, hopper=Hopper(half_angle=radians(45), outlet_width=0.4))
    assert cone.volume == pytest.approx(pi * 4 * (10 + 2 * (1 - 1e-3) / 3))
    wedge = Silo(
        plan="slot", diameter=4.0, length=3.0, wall_depth=10.0, hopper=Hopper(half_angle=radians(45), outlet_width=0.4)
    )
    assert wedge.volume == pytest.approx(12 * (10 + 2 * (1 - 1e-2) / 2))
    assert Silo(plan="rectangular", diameter=4.0, length=6.0, wall_depth=10.0).volume == pytest.approx(240)


def test_declarations_for_en_1991_4_reach_the_methods(study):
    study["scene"]["silo"] |= {"action_assessment_class": 3, "dynamic_bottom_load": True}
    scene = expanded(study).cases[0].scene
    parameters = geometry_parameters(scene)
    assert (parameters["assessment_class"], parameters["dynamic_bottom"]) == (3.0, 1.0)
    assert parameters["volume"] == pytest.approx(pi / 4 * 25 * (18 + 2.5 / 3))


def test_a_heap_at_the_angle_of_repose(study):
    study["scene"] |= {"solid": "wheat_e1", "wall": "d2"}
    study["scene"]["silo"]["heap_at_repose"] = True
    silo = expanded(study).cases[0].scene.silo
    assert silo.top_cone_height == pytest.approx(2.5 * tan(radians(34)))
    assert silo.contact_depth == pytest.approx(2.5 * tan(radians(34)) / 3)  # h_o of the codes
    study["scene"]["silo"]["top_cone_height_m"] = 1.0
    with pytest.raises(BadInput, match="either top_cone_height_m or heap_at_repose"):
        expanded(study)
    study["scene"] |= {"solid": "cement", "wall": "roughness_5"}
    study["scene"]["silo"]["top_cone_height_m"] = 0.0
    with pytest.raises(BadInput, match="no angle of repose"):
        expanded(study)


def test_special_loads_of_a_silo_reach_the_methods(study):
    study["scene"]["silo"] |= {
        "flexible_wall": {"thickness_mm": 5.0, "youngs_modulus_GPa": 200.0, "solid_modulus_factor": 70.0},
        "cooling": {"temperature_drop_K": 30.0, "expansion_per_K": 1.2e-5},
        "rapid_filling": {"rise_m_h": 12.0, "air_time_h": 0.14},
    }
    parameters = geometry_parameters(expanded(study).cases[0].scene)
    assert parameters["wall_flexibility"] == pytest.approx(1e-9)
    assert parameters["solid_modulus_factor"] == 70.0
    assert parameters["cooling_strain"] == pytest.approx(3.6e-4)
    assert parameters["fluid_depth"] == pytest.approx(1.68)


def test_only_a_rectangle_s_end_walls_are_flatter_than_its_long_ones():
    sizes = {"diameter": 4.0, "length": 6.0, "wall_depth": 10.0}
    for plan, ratio in (("rectangular", 1.5), ("slot", 1.0), ("circular", 1.0)):
        scene = Scene(silo=Silo(plan=plan, **sizes), solid=SOLIDS["wheat_e1"])
        assert geometry_parameters(scene)["end_ratio"] == ratio
