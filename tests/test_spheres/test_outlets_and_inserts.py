"""Outlets by name and inserts of a bin of spheres, from the file to the cube; the same bits however it is carried out."""

import numpy as np
import pytest

from silostudy.compute.dem_cube import cube_of
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from tests.test_spheres.small import carried, check_same, resumed, scene_of

pytestmark = pytest.mark.long
TWO = {
    "silo__hopper": None,
    "silo__diameter_m": 0.08,
    "outlets": [
        {"name": "round", "width_m": 0.034, "middle_m": [0.02, 0.0]},
        {"name": "slot", "width_m": 0.03, "length_m": 0.04, "middle_m": [-0.018, 0.0]},
    ],
    "events": [
        {"when": "rest", "do": "open_outlet", "outlets": ["slot"]},
        {"when": "after", "value": 0.1, "do": "open_outlet", "outlets": ["round"]},
        {"when": "after", "value": 0.1, "do": "stop"},
    ],
    "record__snapshots_s": [0.1],
}


@pytest.fixture(scope="module")
def two():
    scene = scene_of(**TWO)
    whole = carried(scene)
    assert not whole.trouble
    return cube_of(whole, scene)


def test_outlets_open_by_name_and_each_has_its_meter(two):
    slot, later, _ = two.event_time.values
    assert two.event_action.values.tolist()[:2] == ["rest: open_outlet slot", "after: open_outlet round"]
    assert two.outlet_opened.sel(outlet=["slot", "round"]).values.tolist() == [slot, later]
    places = [two[f"outlet_{name}"].values.tolist() for name in ("x", "y", "width_x", "width_y")]
    assert places == [[0.02, -0.018], [0.0, 0.0], [0.034, 0.03], [0.034, 0.04]]
    assert np.allclose(two.outlet_outflow_mass.sum("outlet"), two.outflow_mass, rtol=1e-12)
    through = two.outlet_outflow_mass.sel(outlet="round")
    assert float(through.where(two.outflow_time < later).max()) == 0.0
    mass = float(two.grain_mass[0])
    assert float(through[-1]) > 8.0 * mass
    assert float(two.outlet_outflow_mass.sel(outlet="slot").where(two.outflow_time < later).max()) > 8.0 * mass
    assert float(two.surface_load.sel(surface="floor")[-1]) > 0.0


@pytest.mark.parametrize(("threads", "later"), [(2, -0.01), (1, 0.05)])  # before the first opens, and between both
def test_outlets_in_any_way_of_carrying_out(two, threads, later):
    scene = scene_of(**TWO)
    other, happened = resumed(scene, round((float(two.event_time[0]) + later) / two.time_step_s), threads)
    assert len(happened) == (later > 0.0)
    check_same(two, cube_of(other, scene))


SHELF = {
    "inserts": [{"kind": "disc", "name": "shelf", "radius_m": 0.03, "height_m": 0.06}],
    "filling__count": 60,
    "events": [
        {"when": "rest", "do": "take_away", "surfaces": ["shelf"]},
        {"when": "after", "value": 0.25, "do": "open_outlet"},
        {"when": "after", "value": 0.05, "do": "stop"},
    ],
    "record__snapshots_s": [0.1],
}  # fmt: skip


@pytest.fixture(scope="module")
def shelf():
    scene = scene_of(**SHELF)
    whole = carried(scene)
    assert not whole.trouble
    return cube_of(whole, scene)


def test_what_an_insert_bears_falls_when_it_is_taken_away(shelf):
    taken, opened, _ = shelf.event_time.values
    assert shelf.event_action.values[0] == "rest: take_away shelf"
    weight, load = GRAVITY * float(shelf.grain_mass.sum()), shelf.surface_load
    before = load.sel(window_time=slice(taken - 0.06, taken))
    assert float(before.sel(surface="shelf").min()) > 0.7 * weight
    assert float(np.abs(before.sel(surface=["floor", "hopper"])).max()) == 0.0
    after = load.sel(window_time=slice(opened - 0.06, opened))
    assert float(np.abs(after.sel(surface=["shelf", "shelf_back"])).max()) == 0.0
    assert after.sum("surface").values == pytest.approx(weight, rel=0.03)
    assert len(shelf.outflow_time) > 5


@pytest.mark.parametrize(("threads", "later"), [(2, -0.02), (1, 0.02)])
def test_taking_away_in_any_way_of_carrying_out(shelf, threads, later):
    scene = scene_of(**SHELF)
    other, _ = resumed(scene, round((float(shelf.event_time[0]) + later) / shelf.time_step_s), threads)
    check_same(shelf, cube_of(other, scene))


ACROSS = {
    "silo": {"plan": "rectangular", "width_m": 0.036, "length_m": 0.08, "cylinder_depth_m": 0.1},
    "outlets": [{"width_m": 0.036, "length_m": 0.04}],
    "record__fields": None,
    "record__snapshots_s": [0.55],
}


@pytest.mark.parametrize("speed", [None, 0.3])
def test_a_slot_from_wall_to_wall(speed):
    """Every sphere is in the silo, on what is left of the floor, or was counted as it passed the slot."""
    opens = {"when": "rest", "do": "open_outlet", "speed_m_s": speed}
    scene = scene_of(**ACROSS, events=[opens, {"when": "after", "value": 0.4, "do": "stop"}])
    whole = carried(scene)
    cube = cube_of(whole, scene)
    left = whole.engine.bodies.rows[: whole.engine.n, :3]
    assert not whole.trouble
    assert cube.spheres_spilt == 0
    counted = round(float(cube.outflow_mass[-1] / cube.grain_mass[0]))
    assert counted == len(cube.grain) - np.count_nonzero(left[:, 2] > 0.0) > 100
    bounds = (0.018, 0.04, 0.1)
    assert (np.abs(left)[left[:, 2] > 0.0] < bounds).all()
    resting = left[(np.abs(left[:, 1]) > 0.02) & (left[:, 2] < 0.0041)]
    assert len(resting) > 8  # on the floor beside the slot, some of them at the walls that it runs to
    assert resting[:, 2].min() > 0.0039
    assert np.abs(resting[:, 0]).max() > 0.013


HAT = {
    "inserts": [
        {"kind": "cone", "name": "hat", "radii_m": [0.016, 0.0], "heights_m": [0.03, 0.042]},
        {"kind": "polygon", "name": "plate",
         "corners_m": [[0.008, -0.012, 0.045], [0.024, -0.012, 0.06], [0.024, 0.012, 0.06], [0.008, 0.012, 0.045]]},
    ],
    "filling__count": 300,
    "filling__rate_1_s": 3000,
    "silo__cylinder_depth_m": 0.16,
    "events": [{"when": "rest", "do": "open_outlet"}, {"when": "after", "value": 0.04, "do": "stop"}],
    "record__snapshots_s": [0.13],
}  # fmt: skip


@pytest.fixture(scope="module")
def hat():
    scene = scene_of(**HAT)
    whole = carried(scene)
    assert not whole.trouble
    return cube_of(whole, scene), whole


def test_inserts_bear_their_share_of_the_weight(hat):
    """All surfaces carry the weight at rest; what presses the back of a face lifts it."""
    cube, _ = hat
    opened = float(cube.event_time[0])
    rest = cube.sel(window_time=slice(opened - 0.06, opened))
    weight = GRAVITY * float(cube.grain_mass.sum())
    assert rest.surface_load.sum("surface").values == pytest.approx(weight, rel=3e-3)
    assert {"hat", "hat_back", "plate", "plate_back"} <= set(rest.surface.values)
    load = rest.surface_load.isel(window_time=-1)
    assert float(load.sel(surface="hat")) > 0.02 * weight
    assert float(load.sel(surface="hat_back")) <= 0.0
    felt = rest.surface_normal_force_mean.isel(window_time=-1)
    assert float(felt.sel(surface="hat")) > float(felt.sel(surface="hat_back")) >= 0.0


def test_no_sphere_is_where_an_insert_is(hat):
    _, whole = hat
    engine = whole.engine
    for q, wall in enumerate(engine.model.walls):
        if wall.name in ("hat", "plate"):
            away = np.linalg.norm(engine.space.all_from_wall(engine.walls.shape, q, engine.bodies.rows[: engine.n, :3]), axis=1)
            assert 0.9 * engine.radius.min() < away.min()


@pytest.mark.parametrize(("threads", "later"), [(2, -0.02), (1, 0.02)])
def test_inserts_in_any_way_of_carrying_out(hat, threads, later):
    cube, _ = hat
    scene = scene_of(**HAT)
    other, _ = resumed(scene, round((float(cube.event_time[0]) + later) / cube.time_step_s), threads)
    check_same(cube, cube_of(other, scene))
