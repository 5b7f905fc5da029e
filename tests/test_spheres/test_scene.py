"""From a scene file of spheres to a cube: fill, rest, discharge; the same bits however it is carried out."""

import meshio
import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.dem import scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.paraview import export
from silostudy.compute.sphere_cube import sphere_notes
from silostudy.cube.io import read, write
from silostudy.dem.engine import Engine
from silostudy.dem.rain import delay, pour
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from tests.test_spheres.small import carried, check_same, content, resumed, run, scene_of

pytestmark = pytest.mark.long


@pytest.fixture(scope="module")
def small():
    scene = scene_of()
    return scene, carried(scene)


@pytest.fixture(scope="module")
def cube(small):
    return cube_of(small[1], small[0])


def test_floor_and_walls_carry_the_weight_at_rest(cube, small):
    opened = float(cube.event_time[0])
    rest = cube.sel(window_time=slice(opened - 0.06, opened))
    assert rest.window_time.size >= 2
    weight = GRAVITY * float(cube.grain_mass.sum())
    assert rest.surface_load.sum("surface").values == pytest.approx(weight, rel=2e-3)
    assert float(rest.surface_load.sel(surface="hopper").min()) > 0.2 * weight
    assert float(rest.surface_shear_force_mean.sel(surface="hopper").min()) > 0.0


def test_cells_add_up_to_surfaces_and_pressures_are_forces_over_areas(cube):
    force = (cube.wall_pressure_mean * cube.wall_cell_area).groupby("wall_name").sum()
    total = cube.surface_normal_force_mean.rename(surface="wall_name").sel(wall_name=force.wall_name)
    assert np.allclose(force.transpose("window_time", "wall_name"), total, rtol=1e-12, atol=0.0)
    assert (cube.wall_pressure_max >= cube.wall_pressure_mean).all()
    highest = cube.wall_normal_force_max.groupby("wall_name").sum().rename(wall_name="surface").sel(surface=cube.surface)
    assert (cube.surface_normal_force_max <= highest.transpose("window_time", "surface") * (1.0 + 1e-12)).all()
    assert (cube.surface_normal_force_min <= cube.surface_normal_force_mean * (1.0 + 1e-12)).all()
    assert (cube.surface_shear_force_max >= cube.surface_shear_force_mean - 1e-12).all()
    assert float((cube.surface_normal_force_max - cube.surface_normal_force_mean).max()) > 0.0
    assert float(cube.wall_pressure_min.min()) == 0.0


def test_fields_hold_the_mass_and_balance_in_every_slice(cube):
    """At rest the stress across a slice is the weight above it less what walls and floor bear."""
    rest = cube.sel(field_time=float(cube.event_time[0]), method="ffill").set_index(field_cell=["field_z", "field_r"])
    rest = rest.unstack("field_cell")
    volume, weight = rest.field_cell_volume, GRAVITY * float(cube.grain_mass.sum())
    assert float((rest.field_density * volume).sum()) == pytest.approx(float(cube.grain_mass.sum()), rel=1e-12)
    load = ((rest.field_density * GRAVITY - rest.field_wall_force.sel(field_way="z")) * volume).sum("field_r")
    assert abs(float(load.sum())) < 3e-3 * weight
    above = load[::-1].cumsum("field_z")[::-1] - 0.5 * load
    high = float(rest.field_z[1] - rest.field_z[0])
    stress = rest.field_contact_stress + rest.field_kinetic_stress
    carried = (stress.sel(field_way="z", field_of="z") * volume).sum("field_r") / high
    assert float(np.abs(carried - above).max()) < 0.02 * weight
    assert float(carried.max()) > 0.3 * weight


def test_statistics_of_contacts(cube):
    assert np.allclose(np.trace(cube.contact_fabric, axis1=1, axis2=2)[1:], 1.0)
    rest = cube.sel(statistics_time=float(cube.event_time[0]), method="ffill")
    assert 3.5 < float(rest.contact_coordination) < 6.5
    assert float(rest.contact_held_coordination) > float(rest.contact_coordination) - 1e-12
    assert float(rest.contact_sliding) < 0.1 < float(cube.contact_sliding[-1])
    assert 0.0 < float(rest.contact_mean_overlap) < float(rest.contact_deepest_overlap) < 0.05


def test_gravity_stands_whole_in_the_cube():
    scene = scene_of(gravity_m_s2=[-1.0, 0.5, -9.0])
    notes = sphere_notes(scene, run(scene))
    assert [notes[f"gravity_{way}_m_s2"] for way in "xyz"] == [-1.0, 0.5, -9.0]


def test_the_meter_counts_spheres_at_the_outlet(cube, small):
    """As many as stand below the outlet, or have been dropped, at the end and on the way there."""
    scene, whole = small
    mass = float(cube.grain_mass[0])
    below = int((whole.engine.bodies.rows[: whole.engine.n, 2] < 0.0).sum())
    assert round(float(cube.outflow_mass[-1]) / mass) == whole.recording.left["discharged"] + below
    span = float(cube.outflow_time[-1] - cube.outflow_time[1])
    assert cube.attrs["mean_outflow_kg_s"] == pytest.approx(float(cube.outflow_mass[-1]) / span, rel=0.05)
    part, time = run(scene), float(cube.event_time[0]) + 0.07003
    part.go(until=round(time / part.engine.model.dt))
    below = int((part.engine.bodies.rows[: part.engine.n, 2] < 0.0).sum())
    counted = int((cube.outflow_time[1:] <= part.engine.time).sum())
    assert counted == part.recording.left["discharged"] + below > 10


def test_snapshots_and_events(cube):
    assert cube.event_action.values.tolist() == ["rest: open_outlet", "after: stop"]
    there = np.isfinite(cube.grain_x.values).sum(axis=1)
    assert 60 < there[0] < 90  # 1500 a second, after 0.05 s
    assert there[1] == 150
    assert 0.0 < float(cube.deepest_overlap[1]) < 0.05


def test_rain_touches_nothing(small):
    scene, _ = small
    begun = run(scene)
    for until in (1, 700, 1900):
        begun.go(until=until)
        engine = begun.engine
        before = engine.n
        came = pour(engine, begun.rain, begun.come, min(begun.come + 20, engine.most))
        begun.come += came
        place, radius = engine.bodies.rows[: engine.n, :3], engine.radius
        gaps = np.linalg.norm(place[before:, None] - place, axis=2) - radius[before:, None] - radius
        gaps[np.arange(came), np.arange(before, before + came)] = 1.0
        assert came > 0
        assert gaps.min() >= 0.0
        assert (np.hypot(*place[before:, :2].T) <= 0.03 - radius[before:]).all()


def test_rain_that_finds_no_room_in_time_says_how_late_it_is(small):
    assert delay(small[1]) == ""
    dense = carried(scene_of(filling__rate_1_s=100_000))
    when, late = (float(word.split(" s")[0]) for word in delay(dense).removeprefix("sphere 150 came in at ").split(", "))
    assert late == pytest.approx(when - 149 / 100_000, rel=0.01)
    assert late > dense.rain.fall(dense.engine)


def test_any_number_of_threads(cube):
    scene = scene_of()
    check_same(cube, cube_of(carried(scene, threads=2), scene))


def test_any_skin_and_chunk(cube):
    scene = scene_of()
    other = run(scene)
    other.engine = Engine(other.engine.model, skin=0.001)
    while not other.done:
        other.go(until=other.engine.step + 1237)
    check_same(cube, cube_of(other, scene))


@pytest.mark.parametrize("stop", [1237, 14001])  # while they rain in, and while they flow out
def test_restart(cube, stop):
    scene = scene_of()
    other, _ = resumed(scene, stop, threads=2)
    check_same(cube, cube_of(other, scene))


def test_observers_change_no_bit(small):
    plain = carried(scene_of(record={}))
    seen = small[1]
    assert plain.engine.n == seen.engine.n
    assert np.array_equal(plain.engine.bodies.rows[: plain.engine.n], seen.engine.bodies.rows[: seen.engine.n])
    assert plain.recording.passed == seen.recording.passed


def test_the_command_and_what_it_tells(tmp_path, capsys):
    path = tmp_path / "bin.yaml"
    path.write_text(yaml.safe_dump(content(events=[{"when": "time", "value": 0.03, "do": "stop"}], record__snapshots_s=[0.02])))
    assert main(["dem", str(path), str(tmp_path / "bin.nc")]) == 0
    told = capsys.readouterr()
    assert "45 of 150 spheres still there (105 not in yet)" in told.out
    assert "a ratio of 20: steps 4.5 times as long, overlaps 7.37 times as deep" in told.err
    assert read(tmp_path / "bin.nc").attrs["spheres_spilt"] == 0


def test_a_silo_that_fills_up_ends_the_run_in_one_line(tmp_path, capsys):
    path = tmp_path / "bin.yaml"
    lower = content(filling__count=330, filling__height_m=0.05, silo__cylinder_depth_m=0.2, filling__rate_1_s=20000)
    path.write_text(yaml.safe_dump(lower | {"events": [{"when": "rest", "do": "stop"}]}))
    assert main(["dem", str(path), str(tmp_path / "bin.nc")]) == 2
    assert "no room for" in capsys.readouterr().err


def test_a_cube_is_a_filling(small, tmp_path):
    scene, whole = small
    write(cube_of(whole, scene), tmp_path / "small.nc")
    again = scene_of(filling={"kind": "given", "file": "small.nc"}, sizes=None)
    model = scene_model(again, tmp_path)
    assert np.array_equal(model.z, read(tmp_path / "small.nc")["grain_z"].to_numpy()[-1])
    assert model.waiting == 0


def test_cube_speaks_of_spheres(cube):
    named = {str(name): array.attrs["long_name"] for name, array in cube.variables.items()}
    assert named["contact_y"] == "place of the contact along y, from the axis"
    assert named["wall_cell_y"] == "middle of the wall cell along y, from the axis"
    plane = {name for name, told in named.items() if "disc " in told or "two ends" in told or "across;" in told}
    assert not plane


def test_paraview(small, tmp_path):
    names = [file.name for file in export(small[1], tmp_path)]
    assert names == ["000-spheres.vtu", "000-forces.vtu", "001-spheres.vtu", "001-forces.vtu"]
    points, lines = (meshio.read(tmp_path / name) for name in names[2:])
    assert points.point_data["spin"].shape == (150, 3)
    assert lines.cell_data["force"][0].shape == (len(small[1].recording.snapshots[1]["pairs"]), 3)


@pytest.mark.parametrize(
    "sizes",
    [
        {"kind": "lognormal", "median_mm": 7, "spread": 1.2, "least_mm": 5, "largest_mm": 9},
        {"kind": "sieve", "openings_mm": [5, 7, 9], "passing": [0, 0.4, 1]},
    ],
)
def test_spheres_of_many_sizes_come_to_rest_and_carry_their_weight(sizes):
    scene = scene_of(sizes=sizes, events=[{"when": "rest", "do": "stop"}], record__snapshots_s=[])
    whole = carried(scene)
    assert not whole.trouble
    load = cube_of(whole, scene).surface_load.sum("surface")
    assert float(load[-1]) == pytest.approx(GRAVITY * whole.engine.mass.sum(), rel=5e-3)
