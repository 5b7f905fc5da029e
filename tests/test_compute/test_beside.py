"""Grains beside codes: pressures that are known factors of Janssen's, found again with all their ratios."""

import copy

import numpy as np
import pytest
import xarray as xr
import yaml

from silostudy.choice.expand import expand_file
from silostudy.compute.beside import _stagnant, beside_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.config.load import read_yaml
from silostudy.cube.areas import AVERAGED, largest_mean, of_profile
from silostudy.errors import BadInput
from tests.conftest import ROOT
from tests.test_compute.made_walls import FLOWS, GAMMA, MU, PATCH, K, made_walls

STUDY = ROOT / "config/studies/silo-of-spheres.yaml"
DEEP = [0.1, 0.2]  # m
SEEDS = {"axis": "run", "values": {"seed": [1, 2]}}
POINTS = [{"silo.cylinder_depth_m": 0.14}, {"silo.cylinder_depth_m": 0.24}]  # of walls that stand higher


def codes_of(depths=DEEP, **changes):
    """The study of pressures of the made-up solid."""
    scene = {
        "silo": {"plan": "circular", "diameter_m": 0.1, "cylinder_depth_m": 0.1,
                 "hopper": {"half_angle_deg": 20, "outlet_width_m": 0.05}},
        "solid": "wheat",
        "properties": {"unit_weight_kN_m3": GAMMA / 1e3, "wall_friction": MU, "lateral_pressure_ratio": K,
                       "internal_friction_angle_deg": 30},
    }  # fmt: skip
    axis = {"axis": "silo", "values": {"silo.cylinder_depth_m": list(depths)}}
    content = {"kind": "pressure", "title": "codes", "scene": scene, "sweep": [axis], "methods": ["janssen", "reimbert"]}
    content |= {"phases": ["filling", "discharge"], "relative_depth": {"start": 0.0, "stop": 1.0, "count": 401}}
    return content | {"hopper_position": [0.0, 1.0]} | changes


def swept(folder, codes=None):
    """(expansion of the sweep, its made-up cube, cube of pressures)."""
    content = copy.deepcopy(read_yaml(STUDY)) | {"outputs": [], "codes": {"study": "codes"}}
    content["sweep"] = [{"axis": "silo", "points": POINTS}, {"axis": "filling", "values": {"seed": [1, 2, 3]}}]
    (folder / "grains.yaml").write_text(yaml.safe_dump(content))
    (folder / "codes.yaml").write_text(yaml.safe_dump(codes or codes_of()))
    expansion = expand_file(folder / "grains.yaml")
    return expansion, made_walls(expansion, DEEP), pressure_cube(expand_file(folder / "codes.yaml"))


@pytest.fixture(scope="module")
def beside(tmp_path_factory):
    return beside_cube(*swept(tmp_path_factory.mktemp("beside")))


def test_the_laboratory_s_own_solid_is_found_again(beside):
    """Shear over pressure and K by the weight above: what the made-up pressures were made with."""
    first = beside.isel(filling=0)
    assert first["mobilised_wall_friction"].values == pytest.approx(MU)
    assert first["lateral_pressure_ratio_at_rest"].values == pytest.approx(K, rel=0.01)
    assert first["contents_unit_weight"].values == pytest.approx(GAMMA)


def test_ratios_are_those_that_the_pressures_were_made_with(beside):
    janssen = beside.sel(pressure_method="janssen", phase="filling")
    scatter = 1.0 + 0.05 * np.arange(3)
    assert janssen["code_over_grains_force"].values == pytest.approx(np.tile(1.0 / scatter, (2, 1)), rel=1e-4)
    assert janssen["code_profile_residual"].values[:, 0] == pytest.approx(0.0, abs=1e-4)
    assert janssen["code_profile_residual"].values[:, 2] == pytest.approx(1.0 - 1.0 / scatter[2], rel=1e-3)
    rise = beside["largest_over_rest"].sel(phase="discharge")
    assert rise.sel(averaging="1x1").values == pytest.approx(FLOWS * PATCH)
    assert rise.sel(averaging="ring").values == pytest.approx(FLOWS * (1.0 + (PATCH - 1.0) / 16))
    assert beside["largest_over_rest"].sel(phase="filling").values == pytest.approx(1.0)


def test_grains_slide_down_the_wall_above_the_effective_transition():
    """Friction of 0.1 and 0.2 below and 0.3 above, with one more low level there: the two lowest levels do not slide."""
    friction = xr.DataArray([[0.1, 0.2, 0.3, 0.1, 0.28, np.nan], [0.3] * 6], dims=("filling", "wall_level"))
    assert _stagnant(friction, xr.DataArray(0.01)).values == pytest.approx([0.02, 0.0])


def test_a_cell_that_feels_twice_its_level_is_seen_around(beside):
    """Made-up pressures are even but for one cell of one window of the second level, above half a diameter in the low silo."""
    around = beside.sel(phase="discharge")
    ring = 1.0 + (PATCH - 1.0) / 16
    assert around["largest_over_ring"].values == pytest.approx(PATCH / ring - 1.0)
    assert beside["largest_over_ring"].sel(phase="filling").values == pytest.approx(0.0, abs=1e-12)
    assert (around["deviation_around"] > 0.0).all()
    even = beside["pressure_around"].sel(phase="filling")
    assert (even.max("wall_turn") / even.min("wall_turn")).values == pytest.approx(1.0)


def test_codes_keep_their_own_depths_and_jumps(tmp_path):
    """Between two levels of cells a jump of a stepped code would be a slope: at its own depths it is a jump."""
    methods = {"methods": ["ty124_1956", "as3774_1996"], "hopper_position": [0.0, 0.5, 0.9]}
    expansion, grains, codes = swept(tmp_path, codes_of(**methods))
    cube = beside_cube(expansion, grains, codes)
    profile = cube["code_wall_profile"].sel(pressure_method="ty124_1956", phase="discharge")
    own = codes["wall_normal_pressure"].sel(pressure_method="ty124_1956", phase="discharge")
    assert np.array_equal(profile, own, equal_nan=True)
    assert np.nanmax(np.diff(profile)) > 0.3 * np.nanmax(profile)
    assert cube["code_profile_depth"].values == pytest.approx(np.outer(DEEP, codes["relative_depth"]))
    hopper = cube["code_hopper_profile"].sel(pressure_method="as3774_1996")
    assert hopper.notnull().any()
    assert np.array_equal(hopper, codes["hopper_normal_pressure"].sel(pressure_method="as3774_1996"), equal_nan=True)


def test_an_area_takes_cells_and_levels_together():
    """Loads of 16 and 8 on cells of a wall of nothing, on both sides of where turns close: means at every level they reach."""
    wall = np.zeros((6, 8))
    wall[2, 7], wall[2, 0] = 16.0, 8.0
    expected = {"1x1": [0, 0, 16, 0, 0, 0], "2x2": [0, 6, 6, 0, 0, np.nan], "4x4": [1.5, 1.5, 1.5] + 3 * [np.nan]}
    for area, levels in (expected | {"ring": [0, 0, 3, 0, 0, 0]}).items():
        assert largest_mean(wall, area) == pytest.approx(levels, nan_ok=True), area
    assert of_profile(np.arange(4.0), "2x2") == pytest.approx([0.5, 1.5, 2.5, np.nan], nan_ok=True)
    assert set(AVERAGED) == {*expected, "ring"}


def test_sides_of_areas_are_those_of_the_cells(beside):
    side = beside["averaging_side"].isel(filling=0)
    step, arc = 0.14 / 12, np.pi * 0.1 / 16
    assert side.sel(averaging="1x1").values[0] == pytest.approx(np.sqrt(step * arc) / 0.1)
    assert side.sel(averaging="ring").values[0] == pytest.approx(np.sqrt(step * 16 * arc) / 0.1)


@pytest.mark.parametrize(
    ("codes", "told"),
    [
        (codes_of(depths=(0.1, 0.2, 0.3)), "has 3 position(s) on the axis silo, where the scenes have 2"),
        (codes_of(depths=(0.1, 0.3)), "codes = 0.3: m deep, where the grains fill 0.2 m"),
        (codes_of(sweep=[{"axis": "other", "values": {"silo.cylinder_depth_m": [0.1, 0.2]}}]), "has the axis other"),
        (codes_of(phases=["filling"]), "lacks discharge"),
    ],
)
def test_codes_of_other_silos_are_refused(codes, told, tmp_path):
    with pytest.raises(BadInput) as caught:
        beside_cube(*swept(tmp_path, codes))
    assert told in str(caught.value)


@pytest.mark.parametrize(
    ("silo", "told"),
    [
        (
            {"hopper": {"half_angle_deg": 30, "outlet_width_m": 0.05}},
            "half_angle_deg of codes = 30.0: must be as scene.silo.hopper",
        ),
        ({"hopper": {"half_angle_deg": 20, "outlet_width_m": 0.03}}, "outlet_width_m of codes = 0.03: must be as"),
        ({"hopper": None}, "half_angle_deg of codes = None: must be as"),
        ({"plan": "square", "width_m": 0.1, "diameter_m": None}, "scene.silo.plan of codes = 'square': must be circular"),
    ],
)
def test_codes_of_another_hopper_or_plan_are_refused_before_any_work(silo, told, tmp_path):
    codes = codes_of()
    silos = codes["scene"]["silo"] | silo
    codes["scene"]["silo"] = {key: value for key, value in silos.items() if value is not None}
    with pytest.raises(BadInput) as caught:
        swept(tmp_path, codes)
    assert told in str(caught.value)


def test_a_hopper_that_codes_do_not_sweep_is_refused(tmp_path):
    content = copy.deepcopy(read_yaml(STUDY)) | {"outputs": [], "codes": {"study": "codes"}}
    points = [{"silo.hopper.half_angle_deg": angle} for angle in (20, 50)]
    content["sweep"] = [{"axis": "cone", "points": points}, {"axis": "filling", "values": {"seed": [1, 2]}}]
    (tmp_path / "grains.yaml").write_text(yaml.safe_dump(content))
    (tmp_path / "codes.yaml").write_text(yaml.safe_dump(codes_of(sweep=[])))
    with pytest.raises(BadInput, match=r"half_angle_deg of codes = 20.0: must be as scene.silo.hopper.half_angle_deg = 50"):
        expand_file(tmp_path / "grains.yaml")


def test_codes_that_do_not_sweep_stand_beside_every_setting(tmp_path):
    """Of two silos as deep, which only the codes' study does not tell apart: grains of two sizes, say."""
    expansion, _, codes = swept(tmp_path, codes_of(sweep=[], methods=["as3774_1996", "en1991_4"]))
    cube = beside_cube(expansion, made_walls(expansion, [0.1, 0.1]), codes)
    assert "silo" in cube["code_patch_factor"].dims
    profiles = cube["code_wall_profile"].sel(pressure_method="as3774_1996", phase="discharge")
    assert profiles.isel(silo=0).values == pytest.approx(profiles.isel(silo=1).values)
    assert cube["code_over_grains_force"].sel(pressure_method="as3774_1996").notnull().all()


def test_walls_of_another_width_are_refused(tmp_path):
    codes = codes_of()
    codes["scene"]["silo"]["diameter_m"] = 0.12
    with pytest.raises(BadInput, match=r"scene\.silo\.diameter_m of codes = 0\.12: must be as scene\.silo\.diameter_m = 0\.1"):
        beside_cube(*swept(tmp_path, codes))


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"sweep": [{"axis": "filling", "values": {"seed": [1]}}]}, "codes needs an axis of the key seed alone"),
        ({"sweep": []}, "codes needs an axis of the key seed alone"),
        ({"sweep": [{"axis": "wall_level", "values": {"seed": [1, 2]}}]}, "an axis cannot be named wall_level"),
        ({"sweep": [SEEDS, {"axis": "wide", "values": {"silo.diameter_m": [0.1, 0.2]}}]}, "codes needs one silo.diameter_m"),
        ({"sweep": [SEEDS, {"axis": "filling", "values": {"filling.count": [9000, 9900]}}]}, "name the other axis otherwise"),
    ],
)
def test_scenes_that_cannot_be_compared_are_refused(change, told, tmp_path):
    content = copy.deepcopy(read_yaml(STUDY)) | change
    (tmp_path / "grains.yaml").write_text(yaml.safe_dump(content))
    with pytest.raises(BadInput, match=told):
        expand_file(tmp_path / "grains.yaml")


def test_what_is_compared_with_makes_no_case_anew(tmp_path):
    expansion, *_ = swept(tmp_path)
    other = expansion.study.model_copy(update={"codes": None})
    assert other.settings == expansion.study.settings
