"""Right values where an independent check found wrong ones: wall pressures and hoppers, each from a small input."""

import numpy as np
import pytest
import yaml

from silostudy.commands.about import cautions
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.shell_load import internal_pressures
from silostudy.pressure.family import REASONS
from tests.conftest import ROOT, expanded
from tests.test_pressure.silos import CONE, SLENDER, cube_of, on_wall, study, why


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


def test_a_mean_mu_cut_to_tan_phi_is_told_in_every_set():
    """A mean of 0.9 is cut to tan 30 before a_mu: the sets of cylinder and hopper come from that, and say so."""
    rough = {"wall_friction": 0.9, "hopper_wall_friction": 0.9}
    one = cube_of(hopper=CONE, properties=rough).sel(pressure_method="en1991_4", phase="filling")
    for place in ("wall_normal_pressure", "hopper"):
        values = one.sel(used_for=place)
        found = [float(values[f"used_wall_friction{end}"]) for end in ("", "_uncapped", "_capped")]
        assert found == pytest.approx([np.tan(np.pi / 6) / 1.16, 0.9 / 1.16, 1])


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


def test_what_one_source_has_of_low_silos_is_given_where_it_is_asked_for():
    low = ECCENTRIC | {"cylinder_depth_m": 6.6, "outlet_eccentricity_m": 2.0}
    both = ("en1991_4", "en1991_4_eccentric", "en1991_4_eccentric_squat")
    for asked in (False, True):
        cube = cube_of(low | {"patch_of_low_silo": asked}, both, (3.0, 6.0))
        reasons = {"in_scope"} if asked else {"outside_published_range"}
        assert why(cube, "patch_resultant", "en1991_4", "discharge") == reasons
        assert why(cube, "patch_resultant", "en1991_4", "filling") == {"in_scope"}
    factor = cube["patch_load_factor"].sel(pressure_method="en1991_4", phase="discharge")
    assert float(factor) == pytest.approx(0.272 * 0.5 * (0.1 + 4 / 6))
    assert cube["channel_normal_pressure"].sel(pressure_method=both[1]).isnull().all()
    assert cube["channel_normal_pressure"].sel(pressure_method=both[2], phase="discharge").notnull().all()


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
