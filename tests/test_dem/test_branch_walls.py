"""Branches of runs of discs whose outlets, shut or open, feeders, lids and belts go on, or are others."""

import numpy as np
import pytest

from silostudy.errors import BadInput
from tests.test_dem.branches import AT_ONCE, OPENS, PLAIN, branched, ended, same_motion, stop
from tests.test_dem.small import SMALL, carried, scene_of
from tests.test_dem.test_seams import OUT, ROLLING, slit

pytestmark = pytest.mark.long
SHUT = {"silo": {"width_m": 0.17, "height_m": 0.4, "wall_cells": 5}}
ONE, WIDER = ([{"name": name, "width_m": wide, "middle_m": 0.09}] for name, wide in (("one", 0.05), ("other", 0.09)))
TWO = [{"name": "left", "width_m": 0.03, "middle_m": 0.04}, {"name": "right", "width_m": 0.06, "middle_m": 0.12}]


@pytest.mark.parametrize("outlets", [WIDER, TWO])
def test_other_outlets_by_names_in_place_of_shut_ones(outlets, tmp_path):
    """As if the filling had been over these all along; once one is open, it stays."""
    ended(tmp_path, stop(0.05), **SHUT, outlets=ONE)
    opened = {"do": "open_slit", "outlets": [outlets[-1]["name"]]}
    whole = carried(scene_of(events=[OPENS | opened, stop(0.2)], **PLAIN | SHUT, outlets=outlets))
    branch = branched(tmp_path, AT_ONCE | opened, stop(0.2), **SHUT, outlets=outlets)
    assert same_motion(branch, whole)
    assert branch.dropped == whole.dropped > 0.0
    ended(tmp_path, OPENS, stop(0.1), **SHUT, outlets=ONE)
    with pytest.raises(
        BadInput, match="the outlet one open, which this scene has not: only outlets that are shut there may be"
    ):
        branched(tmp_path, stop(0.2), **SHUT, outlets=outlets)


@pytest.mark.parametrize(
    ("begins", "changes"),
    [
        (OPENS | {"speed_m_s": 0.5}, {**SHUT, "outlets": ONE}),
        ({"when": "time", "value": 0.05, "do": "feed", "rate_kg_s": 20.0}, {}),
    ],
)
def test_an_outlet_that_opens_and_a_feeder_go_on(begins, changes, tmp_path):
    """Stopped while the outlet opens, or the feeder feeds, to which no event of the branch belongs."""
    whole = carried(scene_of(events=[begins, stop(0.2)], **PLAIN | changes))
    first = ended(tmp_path, begins, stop(0.1), **changes)
    branch = branched(tmp_path, stop(0.2), **changes)
    assert same_motion(branch, whole)
    assert branch.dropped > 0.0
    assert first.dropped + branch.dropped == pytest.approx(whole.dropped, rel=1e-12)


@pytest.mark.parametrize("speed", [None, 0.35])
@pytest.mark.parametrize("others", [[], [slit("b", 0.05), slit("c", 0.1)]])
def test_other_shut_outlets_while_one_is_open_or_opens(others, speed, tmp_path):
    """Discs have rolled over those that were shut, and lie on the edges of the one that stays, which may have another name."""
    begins = {"when": "time", "value": 0.1, "do": "open_slit", "outlets": ["out"], "speed_m_s": speed}
    then = [{"when": "time", "value": 0.2, "do": "open_slit", "outlets": ["c"], "speed_m_s": 0.2}] if others else []
    changes = ROLLING | SHUT
    whole = carried(scene_of(events=[begins, *then, stop(0.3)], **changes, outlets=[*others, OUT]))
    ended(tmp_path, begins, stop(0.2), **changes, outlets=[OUT, slit("a", 0.1), slit("d", 0.06, 0.02)])
    branch = branched(tmp_path, *then, stop(0.3), **changes, outlets=[OUT | {"name": "gate"}, *others])
    assert same_motion(branch, whole)
    assert branch.engine.n < 30


LID = {"silo": {**SMALL["silo"], "lid": True}, "march": {"limit_s": 1.0}}
DOWN = {"when": "time", "value": 0.02, "do": "lower_lid"}


@pytest.mark.parametrize(
    ("begins", "changes"),
    [
        ([DOWN, {"when": "after", "do": "press_lid", "stress_kPa": 5.0, "speed_m_s": 0.5, "lid_mass_kg": 0.2}], LID),
        ([DOWN, {"when": "after", "do": "move_lid", "speed_m_s": 0.02, "until_stress_kPa": 50.0}], LID),
        ([{"when": "time", "value": 0.02, "do": "run_belt", "speed_m_s": 0.3, "surfaces": ["floor"]}], {}),
    ],
)
def test_walls_in_motion_go_on(begins, changes, tmp_path):
    """Stopped while a lid is pressed or moved, or a belt runs, to which no event of the branch belongs."""
    whole = carried(scene_of(events=[*begins, stop(0.12)], **PLAIN | changes))
    first = ended(tmp_path, *begins, stop(0.05), **changes)
    branch = branched(tmp_path, stop(0.12), **changes)
    assert same_motion(branch, whole)
    assert branch.engine.dt == whole.engine.dt
    motion = [run.engine.space.motion_of(run.engine.walls.shape) for run in (first, branch, whole)]
    assert motion[0][:, 1:].any()
    assert np.array_equal(motion[1], motion[2])
    assert np.array_equal(branch.recording.motion[-1], whole.recording.motion[-1])


def test_new_pieces_of_a_floor_have_the_friction_that_an_event_gave_it(tmp_path):
    asked = {"when": "time", "value": 0.02, "do": "set_friction", "wall_friction": 0.6}
    ended(tmp_path, asked, stop(0.05), **SHUT, outlets=ONE, surfaces={"left": {"sliding_friction": 0.1}})
    branch = branched(tmp_path, stop(0.1), **SHUT, outlets=TWO, surfaces={"left": {"sliding_friction": 0.1}})
    engine = branch.engine
    numbers = [engine.model.wall_number(f"floor_{piece}") for piece in (1, 2, 3)]
    rows = [engine.contacts[1].sets[number].coefficients["sliding_friction"] for number in numbers]
    assert rows == [0.6] * 3


@pytest.mark.parametrize("outlets", [[], TWO])
def test_what_is_open_is_not_opened_again(outlets, tmp_path):
    """A slit without a name, and outlets by names: of those that an event names the others open."""
    changes, names = (SHUT, [{"outlets": ["left"]}, {"outlets": []}]) if outlets else ({}, [{}, {}])
    ended(tmp_path, OPENS | names[0], stop(0.1), **changes, outlets=outlets)
    told = r"events\.0\.do = 'open_slit': opens nothing: open by then, where first\.end ends"
    with pytest.raises(BadInput, match=told):
        branched(tmp_path, AT_ONCE | names[0], stop(0.2), **changes, outlets=outlets)
    if outlets:
        branch = branched(tmp_path, AT_ONCE | names[1], stop(0.2), **changes, outlets=outlets)
        assert [action for *_, action in branch.recording.happened] == ["open_slit right", "stop"]
