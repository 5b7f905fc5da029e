"""Lids, turning surfaces and feeders as a user writes them: what is refused, what the cube holds, restart in the middle."""

import copy

import numpy as np
import pytest

from silostudy.compute.dem_cube import cube_of
from silostudy.config.load import validated
from silostudy.config.spheres import SphereScene
from silostudy.dem.ledger import TURNOVER, balance
from silostudy.dem.space.rows import MORE, OPEN, RIM
from silostudy.errors import BadInput
from silostudy.scene.spheres_about import sphere_effects
from tests.test_spheres.small import carried, content, run

STOP = {"when": "after", "value": 0.02, "do": "stop"}
FLAT = {"plan": "circular", "diameter_m": 0.06, "cylinder_depth_m": 0.1}
SQUARE = {"plan": "square", "width_m": 0.06, "cylinder_depth_m": 0.1}
PRESS = [
    {"when": "rest", "do": "lower_lid"},
    {"when": "after", "do": "press_lid", "stress_kPa": 4.0, "lid_mass_kg": 0.3},
    {"when": "lid_rests", "do": "rotate", "spin_rad_s": 5.0, "surfaces": ["lid"]},
    {"when": "after", "value": 0.03, "do": "move_lid", "speed_m_s": 0.02, "until_stress_kPa": 8.0},
    {"when": "lid_stress", "value": 7.0, "do": "set_friction", "wall_friction": 0.2},
    {"when": "lid_rests", "do": "stop"},
]


def pressing(**changes):
    return validated(SphereScene, content(**({"silo": FLAT, "lid": True, "events": PRESS} | changes)), "press.yaml")


@pytest.mark.parametrize(
    ("events", "changes", "said"),
    [
        ([{"when": "rest", "do": "press_lid"}, STOP], {}, "events.0.stress_kPa: must be given where do is press_lid"),
        ([{"when": "rest", "do": "press_lid", "stress_kPa": 1, "speed_m_s": 0}, STOP], {}, "speed_m_s = 0: must be above 0"),
        ([{"when": "rest", "do": "lower_lid", "stress_kPa": 1}, STOP], {}, "lower_lid takes no stress_kPa; it takes nothing"),
        (
            [{"when": "rest", "do": "press_lid", "stress_kPa": 1, "until_height_m": 0.1}, STOP], {},
            "press_lid takes no until_height_m; it takes stress_kPa, speed_m_s, lid_mass_kg",
        ),
        (PRESS, {"lid": False}, "events.0.do = 'lower_lid': needs lid: true"),
        ([{"when": "lid_stress", "value": 3, "do": "stop"}], {"lid": False}, "events.0.when = 'lid_stress': needs lid: true"),
        ([{"when": "rest", "do": "rotate", "spin_rad_s": 1}, STOP], {}, "events.0.surfaces: must be given where do is rotate"),
        ([{"when": "rest", "do": "feed", "rate_kg_s": 1}, STOP], {}, "events.0.do = 'feed': needs an outlet"),
    ],
)  # fmt: skip
def test_events_that_lack_or_have_too_much(events, changes, said):
    with pytest.raises(BadInput, match=said):
        pressing(events=events, **changes)


PIN = {"kind": "cylinder", "name": "pin", "radius_m": 0.004, "heights_m": [0.01, 0.02], "axis_m": [0.01, 0.0]}


@pytest.mark.parametrize(
    ("event", "changes", "said"),
    [
        (
            {"do": "move_lid", "speed_m_s": 0.1, "until_height_m": 0.2}, {},
            "events.0.until_height_m = 0.2: must be from 0 to 0.1 m",
        ),
        (
            {"do": "rotate", "spin_rad_s": 1.0, "surfaces": ["hopper"]}, {},
            "events.0.surfaces = 'hopper': unknown; known: floor, wall, lid",
        ),
        (
            {"do": "rotate", "spin_rad_s": 1.0, "surfaces": ["wall"]}, {"silo": SQUARE, "record": {}},
            "turn about the axis of a circular silo alone",
        ),
        (
            {"do": "rotate", "spin_rad_s": 1.0, "surfaces": ["pin"]},
            {"inserts": [PIN]},
            "turn about the axis of a circular silo alone",
        ),
    ],
)  # fmt: skip
def test_moves_that_the_silo_has_no_room_for(event, changes, said):
    scene = pressing(**({"events": [{"when": "rest", **event}, STOP]} | changes))
    with pytest.raises(BadInput, match=said):
        run(scene)


def test_a_light_lid_shortens_the_step():
    light = copy.deepcopy(PRESS)
    light[1]["lid_mass_kg"] = 1e-3
    steps = [run(pressing(events=events)).engine.model.dt for events in (light, PRESS)]
    assert steps[0] < 0.5 * steps[1]
    effect = next(effect for effect in sphere_effects(pressing()) if effect.name == "walls that move")
    assert effect.on


@pytest.mark.long
def test_a_press_from_the_file_to_the_cube(tmp_path):
    scene = pressing()
    whole = carried(scene)
    assert not whole.trouble
    said = [action.partition(":")[0] for _, _, action in whole.recording.happened]
    assert said == ["lower_lid", "press_lid", "rotate lid", "move_lid", "set_friction", "stop"]
    cube = cube_of(whole, scene)
    times = dict(zip(said, cube.event_time.values, strict=True))
    borne = cube.lid_stress.sel(window_time=slice(times["rotate lid"], times["move_lid"]))
    assert borne.mean() == pytest.approx(4e3, rel=0.02)
    assert float(cube.lid_height[-1]) < float(cube.lid_height[0]) == pytest.approx(0.1)
    turned = cube.sel(surface="lid", window_time=slice(times["rotate lid"] + 0.02, None))
    assert (turned.surface_spin == 5.0).all()
    assert (turned.surface_torque < 0.0).all()  # the grains hold the lid back
    assert (cube.surface_torque.sel(surface=["floor", "wall"]).isel(window_time=-1) > 0.0).all()
    halved, again = run(scene), run(scene)
    halved.go(until=int(times["rotate lid"] / whole.engine.model.dt) - 333)  # while the lid comes down
    again.restore(copy.deepcopy(halved.checkpoint()))
    again.go()
    assert np.array_equal(again.engine.walls.shape, whole.engine.walls.shape)
    assert np.array_equal(again.recording.window, whole.recording.window)
    assert np.array_equal(again.recording.motion, whole.recording.motion)


@pytest.mark.long
def test_a_feeder_draws_at_its_rate():
    rate = 0.09
    feed = {"do": "feed", "rate_kg_s": rate}
    events = [{"when": "rest", **feed}, {"when": "after", "value": 0.5, **feed, "rate_kg_s": 0.0}, STOP]
    fed = carried(validated(SphereScene, content(events=events, record__energy=True, record__snapshots_s=[]), "feed.yaml"))
    start, end = (time for time, _, action in fed.recording.happened if action.startswith("feed: "))
    mass = fed.engine.model.mass[0]
    assert fed.recording.lost["discharged"] == pytest.approx(rate * (end - start), abs=2.0 * mass)
    assert fed.recording.left["discharged"] > 50
    time = np.array([time for time, *_ in fed.recording.passed])
    drawn = mass * np.arange(1, len(time) + 1)
    assert np.abs(drawn - rate * (time - start)).max() < 2.0 * mass
    assert fed.engine.walls.live[fed.engine.model.wall_number("floor")]  # the plug stays
    account = fed.engine.ledger.account
    assert abs(balance(account)) < 1e-9 * account[TURNOVER]


@pytest.mark.long
@pytest.mark.parametrize(
    "changes", [{}, {"silo": FLAT, "outlets": [{"width_m": 0.03, "length_m": 0.04}]}], ids=["cone", "slot"]
)
def test_an_outlet_opens_at_a_speed(changes):
    speed, width = 0.2, 0.03 if changes else 0.04
    events = [{"when": "rest", "do": "open_outlet", "speed_m_s": speed}, {"when": "after", "value": 0.25, "do": "stop"}]
    scene = validated(SphereScene, content(events=events, **changes), "gate.yaml")
    whole, halved, again = run(scene), run(scene), run(scene)
    widths = []

    def tell(step):
        hole = whole.engine.walls.shape[whole.engine.model.wall_number("floor"), MORE:]
        widths.append((whole.engine.time, hole[OPEN], 2.0 * hole[RIM + 3]))

    whole.go(tell=tell)
    opened = whole.recording.happened[0][0]
    time, is_open, wide = np.array([row for row in widths if row[0] > opened]).T
    assert (is_open == 1.0).all()
    assert wide == pytest.approx(np.minimum(speed * (time - opened), width), rel=1e-9)
    assert whole.engine.walls.live[whole.engine.model.wall_number("floor")] == bool(changes)  # a plug goes when it is all hole
    first = min(when for when, *_ in whole.recording.passed)
    assert first - opened > 0.008 / speed  # a diameter
    assert whole.recording.left["discharged"] > 20
    halved.go(until=round((opened + 0.06) / whole.engine.model.dt))
    again.restore(copy.deepcopy(halved.checkpoint()))
    again.go()
    assert np.array_equal(again.recording.window, whole.recording.window)
    assert again.recording.passed == whole.recording.passed
