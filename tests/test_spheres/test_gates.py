"""Gates of hoppers that open at a speed: what they do to a sphere, and the same bits however a bin is carried out."""

import copy
from math import radians, sqrt

import numpy as np
import pytest

from silostudy.compute.branches import keep_end
from silostudy.compute.dem import run_of, scene_model
from silostudy.dem.engine import Engine
from silostudy.dem.space.rows import MORE, RIM
from silostudy.dem.space.walls import walls_of
from silostudy.errors import BadInput
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import OUTLET, SpaceSilo
from tests.test_spheres.scenes import GRAVITY, RADIUS, contact, rows, spheres
from tests.test_spheres.small import carried, resumed, scene_of

pytestmark = pytest.mark.long
SPEED, NARROW = 0.04, 0.8  # m/s; half the outlet over the sphere's radius
HOPPER = {"half_angle_deg": 30, "outlet_width_m": 0.04}
HEXAGON = {"plan": "polygonal", "sides": 6, "inscribed_diameter_m": 0.06, "cylinder_depth_m": 0.1, "hopper": HOPPER,
           "outlet_eccentricity_m": 0.005}  # fmt: skip
CONE = {"plan": "circular", "diameter_m": 0.06, "cylinder_depth_m": 0.1, "hopper": HOPPER}
ECCENTRIC = CONE | {"outlet_eccentricity_m": 0.005}
SILOS = {"hexagon": HEXAGON, "cone": CONE, "eccentric cone": ECCENTRIC}
OPENS = {"when": "time", "value": 0.25, "do": "open_outlet", "speed_m_s": 0.2}
BARE = {"record__snapshots_s": [], "record__fields": None, "record__contact_statistics": None}
END, HALF_OPEN = 0.5, 0.35  # s


def stop(time):
    return {"when": "time", "value": time, "do": "stop"}


def opening(silo, *events, **changes):
    return scene_of(silo=copy.deepcopy(silo), events=[*events, stop(END)], **BARE | changes)


def same_motion(one, other):
    return np.array_equal(one.engine.labels, other.engine.labels) and np.array_equal(
        one.engine.bodies.rows[: one.engine.n], other.engine.bodies.rows[: other.engine.n]
    )


def over_gate(sides, place, width=2.0 * NARROW, speed=SPEED, **changes):
    """The engine of a sphere over the closed gate of a pyramid, or a cone, that begins to open; widths in radii."""
    hopper = Hopper(half_angle=radians(60.0), outlet_width=width * RADIUS)
    plan = {"plan": "polygonal", "sides": sides} if sides else {"plan": "circular"}
    silo = Silo(diameter=8.0 * RADIUS, wall_depth=6.0 * RADIUS, hopper=hopper, **plan)
    walls = SpaceSilo(silo=silo, gated=True).walls()
    settings = {"gravity": (0.0, 0.0, -GRAVITY), "dt": 5e-6, "moving": True, "wall_contact": contact(0.3, 0.3)}
    engine = Engine(spheres([place], walls=walls, **(settings | changes)))
    walls[0].opened(engine.walls.shape[0], (OUTLET,), speed)
    return engine


@pytest.mark.parametrize("sides", [0, 3, 6])
def test_it_sinks_with_the_gate_onto_the_hopper_s_edges(sides):
    """sqrt(r2 - w2) over the outlet, w the half width of the hole, then of the outlet; the floor bears its weight till then."""
    engine = over_gate(sides, (0.0, 0.0, 0.9995 * RADIUS))
    opened = round(NARROW * RADIUS / (0.5 * SPEED) / 5e-6)
    for share in (0.4, 0.99, 1.0, 1.5):
        engine.step_to(round(share * opened) - 2 if share <= 1.0 else 2 * opened)
        wide = min(share, 1.0) * NARROW
        assert rows(engine)[0, 2] == pytest.approx(sqrt(1.0 - wide**2) * RADIUS, abs=0.01 * RADIUS)
        assert engine.walls.live[0] == (share <= 1.0)
    upward = engine.bodies.rows[0, 2]
    engine.step_to(3 * opened)
    # at rest, but for what it rattles in the middle of a round rim, where every side is as near as the other
    assert engine.bodies.rows[0, 2] == pytest.approx(upward, abs=1e-3 * RADIUS)


@pytest.mark.parametrize("sides", [0, 6])
def test_a_rim_that_touches_nothing_does_nothing(sides):
    """A sphere in the hole falls as if there were no gate; one beside the rim, without gravity, stays where it is."""
    falls = over_gate(sides, (0.0, 0.0, 0.0), width=6.0)
    falls.walls.shape[0, MORE + RIM + 3] = 1.001 * RADIUS
    falls.step_to(300)
    assert rows(falls)[0, 5] == pytest.approx(-GRAVITY * 300 * 5e-6, rel=1e-12)
    stays = over_gate(sides, (0.3 * RADIUS, 0.0, 0.0), width=6.0, gravity=(0.0, 0.0, 0.0), watched=True)
    stays.walls.shape[0, MORE + RIM + 3] = 1.3001 * RADIUS
    stays.step_to(40000)
    assert not stays.walls.live[0]
    assert rows(stays)[0].tolist() == [0.3 * RADIUS, *[0.0] * 8]
    assert not stays.record.window.any()


@pytest.fixture(scope="module")
def whole():
    runs = {name: carried(opening(silo, OPENS)) for name, silo in SILOS.items()}
    for run in runs.values():
        assert not run.trouble
        assert run.recording.left["discharged"] > 20
    return runs


def test_what_leaves_is_what_is_no_more_there(whole):
    run = whole["hexagon"]
    left, mass = len(run.engine.model.mass) - run.engine.n, run.engine.model.mass[0]
    assert run.recording.left == {"discharged": left, "spilt": 0, "removed": 0}
    assert run.recording.lost["discharged"] == pytest.approx(left * mass, rel=1e-12)
    assert min(time for time, *_ in run.recording.passed) - OPENS["value"] > 0.008 / OPENS["speed_m_s"]  # a diameter


@pytest.mark.parametrize(("name", "threads"), [("hexagon", 1), ("hexagon", 2), ("eccentric cone", 2)])
def test_a_restart_while_it_opens(name, threads, whole):
    run = whole[name]
    other, _ = resumed(opening(SILOS[name], OPENS), round(HALF_OPEN / run.engine.model.dt), threads)
    assert same_motion(other, run)
    assert other.recording.passed == run.recording.passed
    assert np.array_equal(other.recording.window, run.recording.window)


def test_observers_change_nothing(whole):
    watched = carried(opening(HEXAGON, OPENS, record__snapshots_every_s=0.01, record__wall_force_window_s=0.005))
    assert same_motion(watched, whole["hexagon"])


def branch_of(silo, folder, *events):
    """A run that goes on from one that ended while the gate was half open."""
    scene = scene_of(silo=copy.deepcopy(silo), events=[OPENS, stop(HALF_OPEN)], **BARE)
    keep_end(carried(scene), scene, folder / "half.end")
    scene = opening(silo, *events, start_from="half.end")
    run = run_of(scene, scene_model(scene, folder, "branch.yaml"))
    run.go()
    return run


@pytest.mark.parametrize("name", SILOS)
def test_a_branch_goes_on_while_it_opens(name, whole, tmp_path):
    assert same_motion(branch_of(SILOS[name], tmp_path), whole[name])


def test_a_branch_opens_the_rest_at_once(whole, tmp_path):
    run = branch_of(HEXAGON, tmp_path, {"when": "time", "value": 0.36, "do": "open_outlet"})
    assert not run.engine.walls.live[0]
    assert np.array_equal(run.engine.walls.shape[1:], walls_of(run.engine.model.walls).shape[1:])  # its edges push again
    assert run.recording.left["discharged"] > whole["hexagon"].recording.left["discharged"] - 20


@pytest.mark.parametrize("speed", [None, 0.2])
def test_a_branch_does_not_open_what_is_open(speed, tmp_path):
    """A hopper opened at once is not shut to be opened again, at a speed or not."""
    at_once = {name: told for name, told in OPENS.items() if name != "speed_m_s"}
    scene = scene_of(silo=copy.deepcopy(CONE), events=[at_once, stop(HALF_OPEN)], **BARE)
    keep_end(carried(scene), scene, tmp_path / "open.end")
    scene = opening(CONE, at_once | {"value": 0.4, "speed_m_s": speed}, start_from="open.end")
    with pytest.raises(BadInput, match=r"events\.0\.do = 'open_outlet': opens nothing: open by then, where open\.end ends"):
        run_of(scene, scene_model(scene, tmp_path, "branch.yaml"))
