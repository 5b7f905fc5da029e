"""Flat surfaces whose faces run along them, and spheres that are taken out: motion, work, the same bits, what may be asked."""

import copy
import re

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.ledger import SLIDING, TURNOVER, WALLS, balance
from silostudy.dem.moves import run_belts
from silostudy.dem.space.felt import belt_at
from silostudy.dem.space.surfaces import run as run_faces
from silostudy.dem.space.walls import FlatPiece, walls_of
from silostudy.errors import BadInput
from silostudy.scene.cautions import LETS_OUT
from tests.test_spheres.scenes import GRAVITY, MASS, RADIUS, contact, rows, spheres
from tests.test_spheres.small import carried, resumed, run, scene_of

VELOCITY = np.array([0.24, -0.18, 0.0])  # m/s, of a belt
FRICTION = 0.2
BOX = {"plan": "square", "width_m": 0.06, "cylinder_depth_m": 0.1}
BELT = {"do": "run_belt", "velocity_m_s": [0.3, 0.1, 0.0], "surfaces": ["floor"]}
STOP = {"when": "after", "value": 0.1, "do": "stop"}


def belted(*events, **changes):
    """A small box of spheres whose events come one after the other, 0.2 s from the start."""
    timed = [{"when": "time", "value": 0.2, **events[0]}, *({"when": "after", "value": 0.0, **event} for event in events[1:])]
    return scene_of(silo=BOX, events=[*timed, STOP], **({"record": {"wall_force_window_s": 0.02}} | changes))


@pytest.mark.long
def test_a_sphere_slides_on_a_belt_until_it_rolls_along_at_two_sevenths_of_its_speed():
    corners = tuple((x * 60.0 * RADIUS, y * 60.0 * RADIUS, 0.0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    touch = contact(0.5, FRICTION)
    model = spheres(np.array([[0.0, 0.0, RADIUS]]), walls=(FlatPiece(name="belt", corners=corners),), dt=2e-6,
                    gravity=(0.0, 0.0, -GRAVITY), pair_contact=touch, wall_contact=touch, moving=True)  # fmt: skip
    engine, speed = Engine(model), float(np.linalg.norm(VELOCITY))
    engine.step_to(round(0.05 / model.dt))  # it comes to rest on its own weight
    run_belts(engine, tuple(VELOCITY), "belt")
    grip, begun = 2.0 * speed / (7.0 * FRICTION * GRAVITY), engine.time
    engine.step_to(engine.step + int(0.5 * grip / model.dt))
    found = rows(engine)[0]
    assert found[3:6] == pytest.approx(FRICTION * GRAVITY * (engine.time - begun) * VELOCITY / speed, rel=5e-3, abs=1e-6)
    turning = 2.5 * FRICTION * GRAVITY * (engine.time - begun) / RADIUS  # about the axis across, so that the foot goes along
    assert found[6:9] == pytest.approx(turning * np.array([VELOCITY[1], -VELOCITY[0], 0.0]) / speed, rel=5e-3, abs=1e-3)
    engine.step_to(engine.step + int(2.0 * grip / model.dt))
    assert rows(engine)[0][3:6] == pytest.approx(2.0 / 7.0 * VELOCITY, rel=0.01, abs=1e-6)
    assert engine.record.now[:, 0].sum() == pytest.approx(MASS * GRAVITY, rel=1e-3)


@pytest.mark.parametrize(
    ("normal", "drags"),
    [((0.0, 0.0, 1.0), VELOCITY), ((-1.0, 0.0, 0.0), (0.0, -0.18, 0.0)), ((0.8, -0.6, 0.0), (0.0, 0.0, 0.0))],
)
def test_a_rim_that_faces_along_its_belt_stands_still(normal, drags):
    corners = ((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.1, 0.1, 0.0), (0.0, 0.1, 0.0))
    shape = walls_of((FlatPiece(name="plate", corners=corners),)).shape
    run_faces(shape, [0], tuple(VELOCITY))
    assert belt_at(shape, 0, normal) == pytest.approx(drags, abs=1e-15)


@pytest.mark.long
def test_a_belt_in_a_scene_drags_the_grains_closes_the_ledger_and_keeps_its_bits():
    scene = belted(BELT, record={"wall_force_window_s": 0.02, "energy": True})
    whole = carried(scene)
    account = whole.engine.ledger.account
    assert account[WALLS] > 0.1 * account[SLIDING] > 0.0
    assert abs(balance(account)) < 1e-9 * account[TURNOVER]
    unbooked = belted(BELT)
    for other in (carried(unbooked, threads=2), resumed(scene, whole.engine.step - 777)[0]):
        assert np.array_equal(rows(whole.engine), rows(other.engine))
        assert np.array_equal(whole.recording.motion, other.recording.motion)
    assert (np.array(whole.recording.motion)[-1, 0, 3:] == BELT["velocity_m_s"]).all()
    still = carried(belted(BELT | {"velocity_m_s": [0.0, 0.0, 0.0]}, record={"wall_force_window_s": 0.02, "energy": True}))
    assert abs(still.engine.ledger.account[WALLS]) < 1e-3 * account[WALLS]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"velocity_m_s": None}, "events.0.velocity_m_s: must be given where do is run_belt"),
        ({"surfaces": ["lid"]}, "events.0.surfaces"),
        ({"surfaces": []}, "events.0.surfaces = []: must be given where do is run_belt"),
        ({"speed_m_s": 1.0}, "run_belt takes no speed_m_s; it takes velocity_m_s, surfaces"),
        ({"velocity_m_s": [0.0, 0.1, 0.1]}, "must run along floor, which faces 0, 0, 1"),
    ],
)
def test_belts_that_lack_or_have_too_much(changes, told):
    with pytest.raises(BadInput, match=re.escape(told)):
        run(belted({name: value for name, value in (BELT | changes).items() if value is not None}))


def test_round_walls_are_no_belts_and_level_floors_of_round_silos_are():
    events = [{"when": "time", "value": 0.1, **BELT}, STOP]
    round_silo = {"plan": "circular", "diameter_m": 0.06, "cylinder_depth_m": 0.1}
    assert run(scene_of(silo=round_silo, events=events)).events[0].what == ((0.3, 0.1, 0.0), "floor")
    events[0] = events[0] | {"surfaces": ["wall"]}
    with pytest.raises(BadInput, match=r"events.0.surfaces = 'wall': is not one flat piece, as belts are; round ones rotate"):
        run(scene_of(silo=round_silo, events=events))


@pytest.mark.parametrize(
    ("event", "told"),
    [
        ({}, "events.0.do = 'remove_sphere': needs either sphere or near_m"),
        ({"sphere": 1, "near_m": [0, 0, 0]}, "needs either sphere or near_m"),
        ({"sphere": 150}, "events.0.sphere = 150: must be below 150, the number of spheres"),
    ],
)
def test_spheres_that_cannot_be_taken_out(event, told):
    with pytest.raises(BadInput, match=re.escape(told)):
        run(belted({"do": "remove_sphere", **event}))


def test_a_sphere_is_taken_out_once():
    twice = [{"do": "remove_sphere", "sphere": 3}] * 2
    with pytest.raises(BadInput, match=r"events.1.sphere = 3: is taken out twice"):
        run(belted(*copy.deepcopy(twice)))
    assert "remove_sphere" in LETS_OUT


@pytest.mark.long
def test_spheres_are_taken_out_by_number_and_by_place():
    low = {"do": "remove_sphere", "near_m": [0.0, 0.0, 0.0]}
    taken = carried(belted({"do": "remove_sphere", "sphere": 7}, low, record={}))
    first = run(belted(low, record={}))
    first.go(until=int(0.2 / first.engine.model.dt) - 1)
    lowest = np.argmin(np.linalg.norm(rows(first.engine)[:, :3], axis=1))
    assert set(range(150)) - set(taken.engine.labels.tolist()) == {7, int(lowest)}
    assert taken.recording.left["removed"] == 2
    said = ["remove_sphere 7", f"remove_sphere {lowest}: near_m 0.0 0.0 0.0", "stop"]
    assert [action for _, _, action in taken.recording.happened] == said
