"""The loads cube: every load case in equilibrium, edges that are not smeared, and the same load on a mesh."""

import subprocess
from shutil import which

import numpy as np
import pytest
import yaml
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from silostudy.__main__ import main
from silostudy.compute.calculix import deck
from silostudy.compute.finite_elements import mesh, nodal_forces
from silostudy.compute.loads import SETS, loads_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.cube.io import read, write
from silostudy.cube.load import given_cases, load_case
from silostudy.errors import BadInput
from tests.conftest import ROOT, expanded

STUDIES = ROOT / "config/studies"
LEVELS = 101


def content(study: str, **silo) -> dict:
    found = yaml.safe_load((STUDIES / f"{study}.yaml").read_text(encoding="utf-8"))
    found |= {"outputs": [], "loads": {"levels": LEVELS}}
    found["scene"]["silo"] |= silo
    found["scene"].pop("wall_friction_end", None)
    return found


def cube_of(study: str, **silo):
    return loads_cube(expanded(content(study, **silo)))


@pytest.fixture(scope="module")
def eccentric():
    expansion = expanded(content("eccentric-silo"))
    return loads_cube(expansion), pressure_cube(expansion)


@pytest.fixture(scope="module")
def hopper():
    expansion = expanded(content("steel-wheat-checks"))
    return expansion, loads_cube(expansion), pressure_cube(expansion)


@settings(max_examples=8, deadline=None, phases=[Phase.generate])
@given(
    slenderness=st.floats(0.45, 6.0),
    diameter=st.floats(2.0, 12.0),
    half_angle=st.none() | st.floats(12.0, 60.0),
)
def test_friction_and_bottom_carry_the_weight_after_filling(slenderness, diameter, half_angle):
    """On a flat floor with every set; on a hopper with the set that its load is made of; in discharge C_w more friction."""
    silo = {"diameter_m": diameter, "cylinder_depth_m": slenderness * diameter, "outlet_eccentricity_m": 0.0}
    silo["hopper"] = half_angle and {"half_angle_deg": half_angle, "outlet_width_m": 0.2 * diameter, "wall": "d1"}
    study = content("eccentric-silo", **silo) | {"hopper_position": [0.0, 1.0], "floor_position": None}
    study["methods"] = ["en1991_4"]
    one = loads_cube(expanded(study))
    filled, let_out = one.sel(load_case="filling"), one.sel(load_case="discharge")
    balanced = filled["load_imbalance"] if half_angle is None else filled["load_imbalance"].sel(value_set="vertical_load")
    assert np.all(np.abs(balanced) < 5e-4), balanced.values
    increase = 1 + 0.1 * min(max(slenderness_of(one) - 1, 0), 1)
    np.testing.assert_allclose(let_out["load_wall_force"], increase * filled["load_wall_force"], rtol=1e-12)


def slenderness_of(one) -> float:
    return float(one["load_transition_depth"] / (2 * one["load_radius"]))


@pytest.mark.parametrize("phase", ["filling", "discharge"])
def test_the_patch_sums_to_its_resultant(eccentric, phase):
    cube, pressure = eccentric
    code = pressure.sel(pressure_method="en1991_4", phase=phase)
    p, s, d, z = float(code["patch_pressure"]), float(code["patch_height"]), 8.0, float(code["patch_depth"])
    one = cube.sel(load_case=f"{phase}_patch", value_set="wall_normal")
    assert float(one["load_horizontal_force"]) == pytest.approx(np.pi / 2 * s * d * p, rel=1e-9)
    assert float(one["load_overturning_moment"]) == pytest.approx(np.pi / 2 * s * d * p * (24 - z), rel=1e-9)
    patch, plain = load_case(cube, f"{phase}_patch", "wall_normal"), load_case(cube, phase, "wall_normal")
    for theta in (0.0, 1.0, np.pi):
        inside, without = patch.stress(z, theta)[0], plain.stress(z, theta)[0]
        assert inside - without == pytest.approx(p * np.cos(theta), rel=1e-9)
    for edge, side in ((z - s / 2, -1), (z + s / 2, 1)):
        step = [patch.stress(edge + way * 1e-9, 0.0)[0] - plain.stress(edge + way * 1e-9, 0.0)[0] for way in (side, -side)]
        assert step == [0.0, pytest.approx(p, rel=1e-9)]


def test_the_band_of_a_square_silo_has_no_net_force():
    study = content("eccentric-silo") | {"methods": ["en1991_4"], "floor_position": None}
    study["scene"]["silo"] = {"plan": "square", "width_m": 8.0, "cylinder_depth_m": 24.0}
    expansion = expanded(study)
    cube, pressure = loads_cube(expansion), pressure_cube(expansion)
    one = cube.sel(load_case="discharge_patch", value_set="wall_normal")
    assert abs(float(one["load_horizontal_force"])) < 1e-9 * float(one["load_wall_force"])
    load, plain = (load_case(cube, key, "wall_normal") for key in ("discharge_patch", "discharge"))
    band = float(pressure["band_pressure"].sel(pressure_method="en1991_4", phase="discharge"))
    for theta in (0.0, 2.0):
        assert load.stress(12.0, theta)[0] - plain.stress(12.0, theta)[0] == pytest.approx(band, rel=1e-9)
    assert float(cube.sel(load_case="filling", value_set="wall_friction")["load_imbalance"]) == pytest.approx(0, abs=1e-4)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_channels_mean_is_the_static_pressure_and_its_edges_are_steps(eccentric, number):
    cube, pressure = eccentric
    key = ("channel_25", "channel_40", "channel_60")[number]
    load, still = load_case(cube, key, "wall_normal"), load_case(cube, "filling", "wall_normal")
    code = pressure.sel(pressure_method="en1991_4_eccentric", phase="discharge").isel(channel=number)
    one = cube.sel(load_case=key, value_set="wall_normal")
    assert float(one["load_horizontal_force"]) == pytest.approx(-float(code["channel_shear"]), rel=1e-4)
    assert float(one["load_overturning_moment"]) == pytest.approx(-float(code["channel_moment"]), rel=1e-4)
    for z in (3.0, 17.0):
        shares = [(piece.angle_to - piece.angle_from) / np.pi for piece in load.pieces]
        zones = [float(load.stress(z, (piece.angle_from + piece.angle_to) / 2)[0]) for piece in load.pieces]
        assert np.dot(shares, zones) == pytest.approx(float(still.stress(z, 0.0)[0]), rel=1e-12)
    edge = float(code["channel_half_width"])
    foot = code.isel(relative_depth=-1)
    for angle, names in ((edge, ("channel", "adjacent")), (2 * edge, ("adjacent", "static"))):
        sides = [float(load.stress(24.0, angle + way * 1e-9)[0]) for way in (-1, 1)]
        assert sides == [pytest.approx(float(foot[f"{name}_normal_pressure"]), rel=1e-9) for name in names]
    assert float(one["load_imbalance"]) == pytest.approx(0, abs=1e-4)


def test_the_field_is_the_methods_own_and_goes_round(hopper):
    _, cube, pressure = hopper
    for phase in ("filling", "discharge"):
        load = load_case(cube, phase, "wall_normal")
        one = pressure.sel(pressure_method="en1991_4", phase=phase)
        z = one["depth"].values[::12]  # at levels of the load
        np.testing.assert_allclose(load.stress(z, 0.3)[0], one["wall_normal_pressure"].values[::12], rtol=2e-3)
        np.testing.assert_allclose(load.stress(18.0, 0.3)[0], one["wall_normal_pressure"].values[-1], rtol=1e-12)
        friction = load_case(cube, phase, "wall_friction")
        np.testing.assert_allclose(friction.stress(18.0, 0.3)[1], one["wall_friction_traction"].values[-1], rtol=1e-12)
        below = load.stress(18.0 + 1e-12, 0.3)
        names = ("hopper_normal_pressure", "hopper_friction_traction")
        np.testing.assert_allclose(below, [float(one[name][0]) for name in names], rtol=1e-9)
    load = load_case(cube, "discharge_patch", "wall_normal")
    z = float(pressure["patch_depth"].max())
    for theta in (0.4, 2.5):
        assert (
            load.stress(z, theta)[0]
            == load.stress(z, -theta)[0]
            == pytest.approx(load.stress(z, theta + 2 * np.pi)[0], rel=1e-12)
        )
    assert load.stress(-1.0, 0.0) == (0.0, 0.0) == load.stress(40.0, 0.0)


def test_nothing_presses_above_the_contact_of_a_heap():
    cube = cube_of("steel-wheat-squat", top_cone_height_m=3.0)
    load = load_case(cube, "filling", "wall_normal")
    assert load.stress(0.999, 0.0) == (0.0, 0.0)
    assert load.stress(1.2, 0.0)[0] > 0


def test_a_written_cube_gives_the_same_load(eccentric, tmp_path):
    cube, _ = eccentric
    write(cube, tmp_path / "loads.nc")
    again = load_case(tmp_path / "loads.nc", "channel_40", "wall_normal")
    z, theta = np.meshgrid(np.linspace(0, 24, 33), np.linspace(0, 2 * np.pi, 41))
    np.testing.assert_array_equal(again.stress(z, theta), load_case(cube, "channel_40", "wall_normal").stress(z, theta))
    assert read(tmp_path / "loads.nc")["load_case_reason"].sel(load_case="hopper_filling") == "flat bottom"
    with pytest.raises(BadInput, match="known: filling, filling_patch"):
        load_case(cube, "hopper_filling", "wall_normal")
    with pytest.raises(BadInput, match="known: wall_normal"):
        load_case(cube, "channel_40", "vertical_load")
    assert set(given_cases(cube)["filling"]) == set(SETS)


@pytest.mark.parametrize("key", ["filling", "discharge_patch"])
def test_nodal_forces_sum_to_the_load(hopper, key):
    _, cube, _ = hopper
    load = load_case(cube, key, "vertical_load")
    on = mesh(load, (np.array([6.0, 18.0]), np.array([0.004, 0.007])), size=1.0)
    depths, angles = load.edges()
    assert all(np.min(np.abs(on.depths - depth)) < 1e-9 for depth in (*depths, 6.0))
    assert all(np.min(np.abs(on.angles - angle)) < 1e-9 for angle in angles)
    x, y, z = nodal_forces(load, on).sum(axis=(0, 1))
    carried = load.vertical_force(hopper=False) + load.vertical_force(hopper=True)
    assert -z == pytest.approx(carried, rel=1e-4)
    assert x == pytest.approx(load.horizontal_force(), rel=1e-6, abs=1e-6 * carried)
    assert abs(y) < 1e-9 * carried
    if key == "filling":
        assert -z + load.bottom_force == pytest.approx(load.weight, rel=1e-4)
    moment = np.einsum(
        "ra,r->", nodal_forces(load, on)[..., 0], 18.0 - on.depths * (on.depths <= 18.0) - 18.0 * (on.depths > 18)
    )
    assert moment == pytest.approx(load.overturning_moment(), rel=0.05, abs=1e-6 * carried)


def test_the_deck_holds_the_mesh_and_its_forces(hopper):
    expansion, cube, _ = hopper
    text = deck(load_case(cube, "filling", "vertical_load"), expansion.cases[0].scene, size=1.0)
    parts = {part.split("\n", 1)[0]: part.split("\n")[1:] for part in text.split("*") if part}
    count = len(parts["NODE, NSET=ALL"]) - 1
    assert {name.split("ELSET=")[1] for name in parts if name.startswith("ELEMENT")} == {"WALL", "HOPPER", "SKIRT"}
    used = {int(node) for name, lines in parts.items() if name.startswith("ELEMENT")
            for line in lines if line for node in line.split(",")[1:]}  # fmt: skip
    assert used == set(range(1, count + 1))
    assert sum(float(line.split(",")[2]) for line in parts["CLOAD"] if line.split(",")[1:2] == [" 3"]) == pytest.approx(
        -5010e3, rel=1e-3
    )
    assert {"0.004", "0.0045", "0.005", "0.006", "0.007"} == {line.split(", ")[1] for line in parts["NODAL THICKNESS"] if line}


@pytest.mark.skipif(which("ccx") is None, reason="CalculiX (ccx) is not installed")
@pytest.mark.parametrize("key", ["filling", "discharge_patch"])
def test_the_reactions_of_calculix_equal_the_load(hopper, key, tmp_path):
    """After filling the foot of the skirt bears the weight of the contents but for what the outlet's gate does."""
    expansion, cube, _ = hopper
    load = load_case(cube, key, "vertical_load")
    (tmp_path / "silo.inp").write_text(deck(load, expansion.cases[0].scene, size=1.0))
    subprocess.run(["ccx", "silo"], cwd=tmp_path, check=True, capture_output=True, timeout=300)
    x, _, z = map(float, (tmp_path / "silo.dat").read_text().split()[-3:])
    assert z == pytest.approx(load.vertical_force(hopper=False) + load.vertical_force(hopper=True), rel=1e-4)
    assert -x == pytest.approx(load.horizontal_force(), rel=1e-5, abs=1e-6 * z)
    if key == "filling":
        assert z + load.bottom_force == pytest.approx(load.weight, rel=1e-4)


def said(capsys, *arguments, status=0):
    assert main(list(map(str, arguments))) == status
    captured = capsys.readouterr()
    return captured.out if status == 0 else captured.err


def test_export(capsys, tmp_path):
    study = STUDIES / "eccentric-silo.yaml"
    told = said(capsys, "export", study, tmp_path, "--load-case", "channel_40", "discharge_patch", "--values", "wall_normal")
    assert "2 load(s)" in told
    assert read(tmp_path / "loads.nc").attrs["stage"] == "loads"
    head, *rows = (tmp_path / "channel_40-wall_normal.csv").read_text().splitlines()
    assert head == "depth_m,angle_deg,radius_m,normal_kPa,friction_kPa"
    foot = [tuple(map(float, row.split(","))) for row in rows if row.startswith("24,")]
    angles = [row[1] for row in foot]
    assert len(angles) - len(set(angles)) >= 2, "both sides of an edge"
    assert len({row[3] for row in foot}) == 3
    for flags, words in {
        ("--load-case", "hopper_filling"): "flat bottom; given: filling, ",
        ("--load-case", "nix"): "known: filling, ",
        ("--values", "mean"): "known: wall_normal, wall_friction, vertical_load",
        ("--case", "x"): "must be one of the study's cases",
        ("--deck",): "a deck is for a shell study",
        ("--element-size", "0"): "must be from 0.01 to 10 m",
        ("--load-case", "filling"): "must be a new one: it holds an earlier export",
    }.items():
        error = said(capsys, "export", study, tmp_path, *flags, status=2)
        assert words in error
        assert error.count("\n") == 1
    assert "a pressure or shell study has" in said(capsys, "export", STUDIES / "miller-1977.yaml", tmp_path, status=2)


def test_a_retaining_silo_says_why_it_has_no_loads(capsys, tmp_path):
    study = content("eccentric-silo") | {"methods": ["en1991_4"], "outputs": [], "floor_position": None}
    study["scene"]["silo"] = {"plan": "circular", "diameter_m": 20.0, "cylinder_depth_m": 5.0}
    (tmp_path / "low.yaml").write_text(yaml.safe_dump(study))
    error = said(capsys, "export", tmp_path / "low.yaml", tmp_path / "out", status=2)
    assert "no load case has a field for this silo: " in error
    assert "retaining silos" in error
    assert main(["note", str(tmp_path / "low.yaml"), "--output", str(tmp_path / "low.html")]) == 0
    assert "Nothing is computed on this wall." in (tmp_path / "low.html").read_text()


def test_too_many_silos_are_told_before_anything_is_computed(capsys, tmp_path):
    assert "100 silos at most" in said(capsys, "export", STUDIES / "hopper-load-cases.yaml", tmp_path, status=2)
    many = content("eccentric-silo") | {
        "sweep": [{"axis": "d", "values": {"silo.diameter_m": {"start": 7.0, "stop": 9.0, "count": 101}}}]
    }
    (tmp_path / "many.yaml").write_text(yaml.safe_dump(many))
    (tmp_path / "janssen.yaml").write_text(yaml.safe_dump(content("eccentric-silo") | {"methods": ["janssen"]}))
    assert "loads need one of the methods en1991_4, " in said(capsys, "check", tmp_path / "janssen.yaml", status=2)
    assert "this study has 101" in said(capsys, "check", tmp_path / "many.yaml", status=2)
