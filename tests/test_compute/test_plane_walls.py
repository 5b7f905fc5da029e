"""What sweeps keep of the walls of a plane bin over a wedge, and how it stands beside codes: no kernel is compiled."""

import copy

import numpy as np
import pytest
import xarray as xr
import yaml

from silostudy.choice.expand import expand_file
from silostudy.compute.axes import sweep_of
from silostudy.compute.beside import beside_cube
from silostudy.compute.beside_hopper import compared_in_hopper, in_cone
from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.scenes import coordinates
from silostudy.compute.scenes_walls import contents_now, keeps_walls, wall_coordinates, wall_numbers, windows_in_flow
from silostudy.config.dem import DemScene
from silostudy.config.load import read_yaml, validated
from silostudy.cube.assemble import assemble
from silostudy.dem.walls import wall_cells
from silostudy.errors import BadInput
from tests.conftest import ROOT
from tests.test_dem.small import SMALL

STUDY = ROOT / "config/studies/hopper-of-discs.yaml"
OPENING, WINDOW = 0.05, 0.02  # s: within the third window
GAMMA, MU, K, FLOWS = 9000.0, 0.3, 0.5, 1.25  # N/m3, 1: of a made-up solid; pressure in flow over that at rest
WIDE, DEEP, SWITCH = 0.3, 0.4, 3.0  # m; pressure next to the transition in the window of the switch over that at rest


def wedge(**changes) -> DemScene:
    content = copy.deepcopy(SMALL)
    content["silo"] |= {"hopper_half_angle_deg": 30, "wall_cells": 4}
    content["packing"] = {"kind": "loose", "count": 40}
    content["record"] = {"wall_force_window_s": WINDOW}
    return validated(DemScene, content | changes, "wedge.yaml")


@pytest.fixture(scope="module")
def made():
    """(scene, run of six windows): each cell feels 1000 times the window plus its own number, and half of it as shear."""
    scene = wedge()
    task = run_of(scene, scene_model(scene, ROOT))
    cells = len(task.engine.record.window)
    for number in range(6):
        felt = 1000.0 * (number + 1) + np.arange(cells)
        task.recording.window.append(felt[:, None, None] * np.array([1.0, 0.5])[:, None] * [1.0, 0.5, 2.0])
        task.recording.window_time.append(task.window * task.engine.model.dt * (number + 1))
    return scene, task


@pytest.mark.parametrize(("stem", "names"), [("wall", ("left", "right")), ("hopper", ("hopper_left", "hopper_right"))])
def test_levels_of_both_walls_are_counted_from_below(made, stem, names):
    """The left walls run downward and the right ones upward: force over the length of a cell, at rest in the second window."""
    scene, task = made
    found, model = wall_numbers(task, scene, OPENING), task.engine.model
    for turn, name in enumerate(names):
        wall, inner = model.wall_named(name), wall_cells(model, name)[1:-1]
        cells = inner[::-1] if turn == 0 else inner
        length = np.hypot(*np.subtract(wall.end, wall.start)) / 4
        assert found[f"{stem}_pressure_at_rest"][:, turn] == pytest.approx((2000.0 + cells) / length)
        assert found[f"{stem}_shear_at_rest"][:, turn] == pytest.approx(0.5 * (2000.0 + cells) / length)
        assert found[f"{stem}_pressure_in_flow"][0, :, turn] == pytest.approx((4000.0 + cells) / length)
        low, high = sorted((wall.start[1], wall.end[1]))
        assert found[f"{stem}_level_height"] == pytest.approx(low + (high - low) * (np.arange(4) + 0.5) / 4)


def test_dimensions_are_those_of_the_numbers_and_contents_weigh_what_discs_do(made):
    scene, task = made
    sizes = tuple(len(wall_coordinates(scene)[name]) for name in ("flow_window", "wall_level", "wall_turn"))
    assert wall_numbers(task, scene, OPENING)["wall_pressure_in_flow"].shape == sizes
    found, bottom = contents_now(task, scene), task.engine.model.wall_named("left").end[1]
    weight = (task.engine.mass[task.engine.places[:, 1] > bottom] * 9.80665).sum()
    volume = found["filled_height_at_rest"] * scene.silo.width_m
    assert found["unit_weight_at_rest"] * volume == pytest.approx(weight, rel=1e-3)


def test_only_over_a_wedge_whose_walls_are_felt():
    assert keeps_walls(wedge())
    assert not keeps_walls(wedge(record={}))
    flat = {name: value for name, value in SMALL["silo"].items() if name != "hopper_half_angle_deg"}
    assert not keeps_walls(wedge(silo=flat))


def slot(**changes):
    """The study of pressures of the made-up solid."""
    properties = {"unit_weight_kN_m3": GAMMA / 1e3, "wall_friction": MU, "lateral_pressure_ratio": K,
                  "internal_friction_angle_deg": 30}  # fmt: skip
    silo = {"plan": "slot", "width_m": WIDE, "length_m": 1.0, "cylinder_depth_m": DEEP,
            "hopper": {"half_angle_deg": 15, "outlet_width_m": 0.06}}  # fmt: skip
    content = {"kind": "pressure", "title": "codes", "methods": ["janssen", "jenike_mass_flow"],
               "scene": {"silo": silo | changes, "solid": "wheat", "properties": properties}}  # fmt: skip
    return content | {"relative_depth": {"start": 0.0, "stop": 1.0, "count": 401}, "hopper_position": [0.0, 0.5, 1.0]}


def felt(scene, scatter: float) -> dict[str, np.ndarray]:
    """Numbers of a bin whose walls feel Janssen's pressures of a slot times a factor, and whose wedge feels 1000 Pa."""
    levels, windows, low = scene.silo.wall_cells, windows_in_flow(scene), 0.4
    above = scene.silo.height_m / levels * (np.arange(levels) + 0.5)
    radius, depth = WIDE / 2, np.maximum(DEEP - above, 0.0)
    rest = scatter * (GAMMA * radius / MU * -np.expm1(-K * MU * depth / radius))[:, None] * np.ones(2)
    wedge_rest = 1000.0 * np.ones((levels, 2))
    flow, wedge_flow = (values * np.ones((windows, 1, 1)) for values in (FLOWS * rest, wedge_rest))
    wedge_flow[2, -1] *= SWITCH
    found = {"filled_height_at_rest": np.array(DEEP), "unit_weight_at_rest": np.array(GAMMA),
             "flow_window_end": WINDOW * (np.arange(windows) + 1.0)}  # fmt: skip
    for stem, height, still, moving in (
        ("wall", low + above, rest, flow), ("hopper", low * (np.arange(levels) + 0.5) / levels, wedge_rest, wedge_flow)
    ):  # fmt: skip
        found |= {
            f"{stem}_level_height": height, f"{stem}_largest_pressure": moving.max(axis=0),
            f"{stem}_pressure_at_rest": still, f"{stem}_shear_at_rest": MU * still,
            f"{stem}_pressure_in_flow": moving, f"{stem}_shear_in_flow": MU * moving,
        }  # fmt: skip
    return found


def beside_of(folder, codes):
    content = copy.deepcopy(read_yaml(STUDY)) | {"outputs": [], "codes": {"study": "codes"}}
    content["sweep"] = [{"axis": "filling", "values": {"seed": [1, 2, 3]}}]
    (folder / "discs.yaml").write_text(yaml.safe_dump(content))
    (folder / "codes.yaml").write_text(yaml.safe_dump(codes))
    expansion = expand_file(folder / "discs.yaml")
    each = [felt(case.scene.config, 1.0 + 0.05 * k) for k, case in enumerate(expansion.cases)]
    data = {name: np.array([one[name] for one in each]) for name in each[0]}
    own = {name: value for name, value in coordinates(expansion.study).items() if name != "body"}
    scenes = assemble(expansion.study, "scenes", data | own, sources=[], sweep=sweep_of(expansion))
    return beside_cube(expansion, scenes, pressure_cube(expand_file(folder / "codes.yaml")))


@pytest.fixture(scope="module")
def beside(tmp_path_factory):
    return beside_of(tmp_path_factory.mktemp("plane"), slot())


def test_the_made_up_solid_is_found_again_with_a_slot_s_hydraulic_radius(beside):
    first = beside.isel(filling=0)
    assert first["mobilised_wall_friction"].values == pytest.approx(MU)
    assert first["lateral_pressure_ratio_at_rest"].item() == pytest.approx(K, rel=0.02)
    said = beside["code_over_grains_force"].sel(pressure_method="janssen", phase="filling").values
    assert said == pytest.approx(1.0 / (1.0 + 0.05 * np.arange(3)), rel=1e-3)


def test_the_switch_is_seen_where_and_when_it_was_put(beside):
    """Three times the pressure next to the transition, in the third window; elsewhere every window is the first."""
    first = beside.isel(filling=0)
    assert first["hopper_switch_factor"].values == pytest.approx([1.0] * 23 + [SWITCH])
    assert first["hopper_switch_time"].values == pytest.approx([WINDOW] * 23 + [3 * WINDOW])
    code = first.sel(pressure_method="jenike_mass_flow", phase="filling")
    at_levels = np.interp(code["hopper_level_position"], code["hopper_position"], code["code_hopper_profile"])
    assert code["code_over_grains_transition"].item() == pytest.approx(at_levels[-1] / 1000.0)
    both = (
        beside["code_hopper_profile"].sel(phase=["filling", "filling"]).assign_coords(phase=beside["phase"])
    )  # as if the method said the same of flow
    names = ("hopper_ring_pressure", "hopper_ring_largest", "hopper_level_position")
    again = compared_in_hopper({"code_hopper_profile": both, **{name: beside[name] for name in names}})
    flow = again["code_over_grains_transition"].sel(pressure_method="jenike_mass_flow", phase="discharge")
    assert flow.isel(filling=0).item() == pytest.approx(at_levels[-1] / (SWITCH * 1000.0))
    assert code["code_over_grains_hopper"].item() == pytest.approx(at_levels.mean() / 1000.0)
    assert np.isnan(first["code_over_grains_hopper"].sel(pressure_method="janssen")).all()


def test_a_level_that_hangs_free_in_a_filling_is_no_endless_rise():
    """Two fillings at 0 and 200 Pa, 300 Pa in flow: three times the usual pressure at rest in both."""
    rest, flow = np.full((2, 2, 2), 200.0), np.full((2, 3, 2, 2), 300.0)
    rest[0, 0] = 0.0
    cells = ("wall_level", "wall_turn")
    grains = xr.Dataset(
        {"hopper_level_height": (("filling", "wall_level"), [[0.1, 0.2]] * 2),
         "flow_window_end": (("filling", "flow_window"), [[0.02, 0.04, 0.06]] * 2),
         "hopper_pressure_at_rest": (("filling", *cells), rest),
         "hopper_pressure_in_flow": (("filling", "flow_window", *cells), flow),
         "hopper_shear_at_rest": (("filling", *cells), 0.1 * rest),
         "hopper_shear_in_flow": (("filling", "flow_window", *cells), 0.2 * flow)}
    )  # fmt: skip
    friction = in_cone(grains)["hopper_mobilised_friction"]
    assert friction.sel(phase="filling").values == pytest.approx(0.1)
    assert friction.sel(phase="discharge").values == pytest.approx(0.2)
    assert in_cone(grains)["hopper_switch_factor"].values == pytest.approx(np.array([[3.0, 1.5]] * 2))


def test_sides_of_areas_on_a_plane_wall_are_heights(beside):
    step = 1.2 / 24
    assert beside["averaging_side"].isel(filling=0).values == pytest.approx(np.array([1, 2, 4, 1]) * step / WIDE)


def test_a_round_silo_is_none_of_the_same(tmp_path):
    codes = slot()
    codes["scene"]["silo"] = {"plan": "circular", "diameter_m": WIDE, "cylinder_depth_m": DEEP}
    codes.pop("hopper_position")
    codes["hopper_position"] = [0.0, 1.0]
    with pytest.raises(BadInput, match=r"scene\.silo\.plan of codes = 'circular': must be slot, as of the scenes"):
        beside_of(tmp_path, codes)


def test_walls_of_a_flat_floor_cannot_be_compared(tmp_path):
    content = copy.deepcopy(read_yaml(STUDY))
    del content["scene"]["silo"]["hopper_half_angle_deg"]
    content["sweep"] = content["sweep"][1:]
    (tmp_path / "discs.yaml").write_text(yaml.safe_dump(content))
    with pytest.raises(BadInput, match="hopper_half_angle_deg of discs"):
        expand_file(tmp_path / "discs.yaml")
