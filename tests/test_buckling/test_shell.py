"""From wall pressures to the steel wall: force, pressures, strength, required thickness, and friction at its unsafe end."""

import copy
import math

import numpy as np
import pytest

from silostudy.buckling import BUCKLING
from silostudy.buckling.thickness import required_thickness, with_thickness
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.shell_load import SOURCES, internal_pressures
from silostudy.compute.shell_places import wall_parameters
from silostudy.errors import BadInput
from silostudy.pressure.janssen import axial_wall_force, normal_pressure
from silostudy.pressure.quadrature import from_surface
from silostudy.scene.scene import solid_parameters
from tests.conftest import expanded

STUDY = {
    "kind": "shell",
    "title": "a small steel silo",
    "scene": {
        "silo": {"plan": "circular", "diameter_m": 8.0, "cylinder_depth_m": 20.0},
        "solid": "wheat_benchmark",
        "properties": {"a_mu": 1.16, "a_K": 1.11},
        "shell": {
            "yield_stress_MPa": 235.0,
            "quality": "B",
            "manufacture": "fabricated",
            "safety_factor": 1.5,
            "density_kg_m3": 0.0,
            "strakes": [{"down_to": 0.5, "thickness_mm": 6.0}, {"down_to": 1.0, "thickness_mm": 9.0}],
        },
    },
    "methods": ["janssen", "caquot", "jenike_mass_flow", "din1055_1964", "safarian_steel"],
    "rules": ["miller1977", "en1993_1_6_2025", "en1993_4_1_2007"],
    "depth_m": {"start": 0.0, "stop": 20.0, "count": 201},
}
JANSSEN = {"unit_weight": 8 * 980.665, "wall_friction": 0.44, "lateral_pressure_ratio": 0.45, "hydraulic_radius": 2.0}


@pytest.fixture
def content():
    return copy.deepcopy(STUDY)


@pytest.fixture(scope="module")
def cubes():
    expansion = expanded(copy.deepcopy(STUDY))
    pressure = pressure_cube(expansion)
    return expansion, pressure, shell_cube(expansion, pressure)


def source(cube, method, phase):
    return SOURCES[int(cube["axial_force_source"].sel(pressure_method=method, phase=phase))]


def test_force_of_each_kind(cubes):
    _, pressure, cube = cubes
    assert source(cube, "janssen", "filling") == "own_axial_force"
    assert source(cube, "janssen", "discharge") == "not_covered"
    assert source(cube, "jenike_mass_flow", "discharge") == "own_traction_integrated"
    assert source(cube, "safarian_steel", "discharge") == "friction_times_design_pressure_integrated"
    assert source(cube, "din1055_1964", "discharge") == "own_axial_force_continued_with_own_friction_times_pressure"
    z = pressure["depth"].values
    force = cube["axial_wall_force"].sel(pressure_method="janssen", phase="filling").values
    np.testing.assert_allclose(force[1:], axial_wall_force(z[1:], **JANSSEN), rtol=1e-12)


def test_stress_is_force_over_thickness_of_the_strake(cubes):
    _, _, cube = cubes
    thickness = cube["wall_thickness"].isel(depth=[0, 100, 101, 200]).values
    np.testing.assert_allclose(thickness, [0.006, 0.006, 0.009, 0.009])
    here = cube.sel(pressure_method="janssen", phase="filling", depth=20.0)
    by_hand = float(axial_wall_force(20.0, **JANSSEN)) / 0.009
    assert float(here["axial_wall_stress"]) == pytest.approx(by_hand, rel=1e-12)
    for rule in STUDY["rules"]:
        one = here.sel({"rule": rule})
        assert float(one["utilisation"]) == pytest.approx(1.5 * by_hand / float(one["wall_buckling_stress"]), rel=1e-12)


def test_din_force_goes_on_with_its_own_friction(cubes):
    """Below the relief DIN gives the pressure only; its friction tan(0.6 phi) carries the force on, without a jump."""
    _, pressure, cube = cubes
    here = {"pressure_method": "din1055_1964", "phase": "discharge"}
    force, normal = cube["axial_wall_force"].sel(here).values, pressure["wall_normal_pressure"].sel(here).values
    steps = np.diff(force)[-50:] / 0.1
    friction = math.tan(0.6 * float(pressure["internal_friction_angle"].sel(pressure_method="din1055_1964")))
    np.testing.assert_allclose(steps, friction * (normal[-50:] + normal[-51:-1]) / 2, rtol=1e-9)
    assert np.all(np.diff(force) > 0)


def test_integral_from_the_surface():
    """Trapezoids of Janssen's mu p against his closed form, from depths that do not start at the surface."""
    z = np.linspace(0.4, 20, 50)[None, :]
    traction = 0.44 * normal_pressure(z, **JANSSEN)
    np.testing.assert_allclose(from_surface(traction, z)[:, 10:], axial_wall_force(z, **JANSSEN)[:, 10:], rtol=2e-3)


def test_only_the_static_pressure_is_guaranteed(cubes):
    _, pressure, _ = cubes
    lower, upper = internal_pressures(pressure)
    place = STUDY["methods"].index("safarian_steel")
    static = normal_pressure(pressure["depth"].values, **JANSSEN)
    np.testing.assert_allclose(lower[place][1:], static[1:], rtol=1e-12)
    np.testing.assert_allclose(upper[place][-1], 1.95 * static[-1], rtol=1e-12)
    assert np.all(lower[np.isfinite(lower)] <= upper[np.isfinite(lower)])


@pytest.mark.parametrize("rule", ["miller1977", "nasa_sp8007", "en1993_1_6_2007", "en1993_4_1_2007", "en1993_4_1_2025"])
def test_required_thickness_is_used_to_the_full(cubes, rule):
    expansion, pressure, _ = cubes
    parameters = wall_parameters(expansion, *internal_pressures(pressure))
    force = np.broadcast_to(axial_wall_force(pressure["depth"].values, **JANSSEN), parameters["lower_internal_pressure"].shape)
    needed, scope = required_thickness(BUCKLING[rule], parameters, force, 1.5)
    known = np.isfinite(needed) & (scope == 0) & (force > 1e3)
    assert known.sum() > 400
    used = 1.5 * force / needed / with_thickness(BUCKLING[rule], parameters, needed)["buckling_stress"]
    np.testing.assert_allclose(used[known], 1.0, rtol=1e-6)
    for factor in (1.02, 1.5, 4.0):  # and every thicker wall carries the force too
        thicker = with_thickness(BUCKLING[rule], parameters, needed * factor)["buckling_stress"] * needed * factor
        assert np.all((thicker >= 1.5 * force)[known])


def test_range_of_a_rule_can_set_the_thickness(content):
    """NASA speaks below R/t = 1500 only: a light load gets that wall, and the scope says that it is not the strength."""
    content["rules"] = ["nasa_sp8007"]
    content["depth_m"] = [0.5]
    expansion = expanded(content)
    cube = shell_cube(expansion, pressure_cube(expansion)).sel(pressure_method="janssen", rule="nasa_sp8007")
    thickness = float(cube["required_thickness"][0])
    assert (4.0 + thickness / 2) / thickness == pytest.approx(1500, rel=1e-6)
    meanings = cube["required_thickness_scope"].attrs["flag_meanings"].split()
    assert meanings[int(cube["required_thickness_scope"][0])] == "radius_over_thickness_out_of_range"


@pytest.mark.parametrize("rule", ["miller1977", "en1993_4_1_2007"])
def test_unsafe_friction_asks_for_more_steel(content, rule):
    content["methods"] = ["janssen"]
    content["sweep"] = [{"axis": "friction", "values": {"wall_friction_end": ["mean", "upper"]}}]
    expansion = expanded(content)
    cube = shell_cube(expansion, pressure_cube(expansion)).sel(pressure_method="janssen", rule=rule)
    mean, upper = (cube["required_thickness"].isel(friction=place).max() for place in (0, 1))
    assert 1.02 < float(upper / mean) < 1.16


def test_upper_friction_by_spread_and_by_roughness(content):
    scene = content["scene"]
    mean = solid_parameters(expanded(content).cases[0].scene, "janssen")
    scene["wall_friction_end"] = "upper"
    upper = solid_parameters(expanded(content).cases[0].scene, "janssen")
    phi = mean["internal_friction_angle"]
    assert upper["wall_friction"] == pytest.approx(min(1.16 * 0.44, math.tan(phi)), rel=1e-12)
    assert upper["lateral_pressure_ratio"] == pytest.approx(1.11 * 0.45, rel=1e-12)
    scene |= {"wall": "roughness_2", "solid": "wheat", "properties": {}}
    pieper = solid_parameters(expanded(content).cases[0].scene, "janssen")
    share = {"powder": 0.90, "fine_grain": 0.80, "coarse_grain": 0.75}[expanded(content).cases[0].scene.solid.grain]
    assert pieper["wall_friction"] == pytest.approx(math.tan((share + 0.05) * pieper["internal_friction_angle"]), rel=1e-12)


def test_cube_of_another_study_is_refused(cubes, content):
    _, pressure, _ = cubes
    content["scene"]["silo"]["diameter_m"] = 9.0
    with pytest.raises(BadInput, match="pressure cube = 'a small steel silo': is of another study than small"):
        shell_cube(expanded(content), pressure)


def test_friction_of_a_design_pressure_can_exceed_the_weight(content):
    """It is computed as asked, and the cube shows that no equilibrium stands behind it."""
    content["methods"] = ["janssen", "safarian_steel"]
    content["scene"]["silo"]["cylinder_depth_m"] = 40.0
    content["depth_m"] = {"start": 0.0, "stop": 40.0, "count": 101}
    expansion = expanded(content)
    share = shell_cube(expansion, pressure_cube(expansion))["carried_share"]
    assert float(share.sel(pressure_method="janssen", phase="filling")) < 1
    assert float(share.sel(pressure_method="safarian_steel", phase="discharge")) > 1
