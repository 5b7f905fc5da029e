"""Branches of runs of discs: the same bits as in one go, another outlet or friction, and ends that do not fit."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.branches import keep_end
from silostudy.compute.dem import run_of, scene_model
from silostudy.cube.io import read
from silostudy.dem.branch import as_events_left
from silostudy.dem.ledger import CARRIED_OUT, balance
from silostudy.errors import BadInput
from tests.test_dem.small import SMALL, carried, scene_of
from tests.test_dem.test_seams import OUT, ROLLING, slit
from tests.test_spheres.small import scene_of as spheres_of

pytestmark = pytest.mark.long
OPENS = {"when": "time", "value": 0.05, "do": "open_slit"}
AT_ONCE = {"when": "after", "value": 0.0, "do": "open_slit"}
PLAIN = {"record__fields": None, "record__snapshots_s": []}


def stop(time):
    return {"when": "time", "value": time, "do": "stop"}


def ended(folder, *events, name="first.end", **changes):
    """A run whose end is kept, and its scene."""
    run = carried(scene_of(events=[*events], **PLAIN | changes))
    keep_end(run, folder / name)
    return run


def branched(folder, *events, **changes):
    """A run that goes on from that end."""
    scene = scene_of(events=[*events], start_from="first.end", **PLAIN | changes)
    run = run_of(scene, scene_model(scene, folder, "branch.yaml"))
    run.go()
    return run


def same_motion(one, other):
    return np.array_equal(one.engine.labels, other.engine.labels) and np.array_equal(
        one.engine.bodies.rows[: one.engine.n], other.engine.bodies.rows[: other.engine.n]
    )


@pytest.mark.parametrize("stopped", [0.0301, 0.12])  # while it rests, and while it flows
def test_a_run_and_its_branch_have_the_bits_of_one_run(stopped, tmp_path):
    whole = carried(scene_of(events=[OPENS, stop(0.2)], **PLAIN))
    events = [event for event in (OPENS, stop(stopped)) if event["value"] <= stopped]
    first = ended(tmp_path, *events)
    branch = branched(tmp_path, *([OPENS] if stopped < 0.05 else []), stop(0.2))
    assert same_motion(branch, whole)
    assert branch.engine.time == whole.engine.time
    assert first.dropped + branch.dropped == pytest.approx(whole.dropped, rel=1e-12)
    assert branch.recording.window_time[-1] == whole.recording.window_time[-1]
    assert np.array_equal(branch.recording.window[-1], whole.recording.window[-1])


def test_another_outlet_and_another_friction(tmp_path):
    """As if the filling had been of the wider slit all along; a friction of its own holds from the branch on."""
    ended(tmp_path, stop(0.05))
    wide = {"silo__slit_width_m": 0.1}
    whole, branch = carried(scene_of(events=[OPENS, stop(0.2)], **PLAIN | wide)), branched(tmp_path, AT_ONCE, stop(0.2), **wide)
    assert same_motion(branch, whole)
    rubbing = branched(tmp_path, AT_ONCE, stop(0.2), walls__sliding_friction=0.5)
    asked = {"when": "time", "value": 0.05, "do": "set_friction", "wall_friction": 0.5}
    assert same_motion(rubbing, carried(scene_of(events=[asked, OPENS, stop(0.2)], **PLAIN)))


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


def test_what_events_changed_stays(tmp_path):
    changes = [{"when": "time", "value": 0.01, "do": "set_friction", "disc_friction": 0.3},
               {"when": "time", "value": 0.02, "do": "set_gravity", "gravity_m_s2": [1.0, -9.0]}]  # fmt: skip
    ended(tmp_path, *changes, stop(0.04))
    branch = branched(tmp_path, stop(0.08))
    model = branch.engine.model
    assert as_events_left(model, model.end) == ["sliding_friction 0.3 of grains", "gravity_m_s2 [1.0, -9.0]"]
    assert same_motion(branch, carried(scene_of(events=[*changes, stop(0.08)], **PLAIN)))


def test_what_has_left_before_counts_towards_a_share(tmp_path):
    first = ended(tmp_path, OPENS, stop(0.25), silo__slit_width_m=0.1)
    branch = branched(tmp_path, {"when": "discharged", "value": 0.2, "do": "stop"}, silo__slit_width_m=0.1)
    assert 0.1 * first.full < first.dropped < 0.2 * first.full <= first.dropped + branch.dropped < 0.3 * first.full
    assert branch.recording.left["discharged"] == first.engine.n - branch.engine.n


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"radius_m": 0.009}, "is the end of a run with"),
        ({"density_kg_m3": 2000}, "other grains"),
        ({"discs__normal_stiffness_N_m2": 9e6}, "other normal_stiffness: 9.46e+06 N m-2 there, 9e+06 here"),
        ({"discs__tangential": "spring-slider-total"}, "other contact laws"),
        ({"march__step_s": 2e-5}, "other march.step_s: 2.5e-05 there, 2e-05 here"),
        ({"march__step": "follow", "march__step_s": None}, "other march.step: fixed there, follow here"),
        ({"silo__height_m": 0.5}, "another wall left: the body of the silo stays as it is"),
        ({"silo__width_m": 0.171}, "another wall right: the body of the silo stays as it is"),
        ({"discs__normal_stiffness_N_m2": 9e6, "march__step_s": None}, "other normal_stiffness: 9.46e+06"),
        ({"silo__lid": True}, "no wall lid, which stands here"),
        ({"march__limit_s": 0.03}, "march.limit_s = 0.03: must be above 0.05 s, where first.end ends"),
    ],
)
def test_an_end_of_another_scene_is_refused(changes, told, tmp_path):
    ended(tmp_path, stop(0.05))
    with pytest.raises(BadInput, match=r"branch\.yaml") as caught:
        branched(tmp_path, stop(0.02), record__wall_force_window_s=None, **changes)
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("stopped", [0.1, 0.13])  # at a look at the contacts, by which steps change, and between two
def test_steps_that_follow_go_on(stopped, tmp_path):
    following = {"march__step": "follow", "march__step_s": None}
    whole = carried(scene_of(events=[stop(0.2)], **PLAIN | following))
    ended(tmp_path, stop(stopped), **following)
    branch = branched(tmp_path, stop(0.2), **following)
    assert same_motion(branch, whole)
    assert branch.recording.steps[-1][1] == whole.recording.steps[-1][1] > whole.recording.steps[0][1]


def test_spheres_do_not_go_on_from_discs(tmp_path):
    ended(tmp_path, stop(0.05))
    scene = spheres_of(start_from="first.end")
    with pytest.raises(BadInput, match="is the end of a run with discs, and the scene is of spheres"):
        scene_model(scene, tmp_path, "branch.yaml")


def test_a_surface_of_its_own_friction_from_the_branch_on(tmp_path):
    asked = {"when": "time", "value": 0.05, "do": "set_friction", "wall_friction": 0.5, "surfaces": ["left"]}
    whole = carried(scene_of(events=[asked, stop(0.1)], **PLAIN))
    ended(tmp_path, stop(0.05))
    event = branched(tmp_path, asked | {"when": "after", "value": 0.0}, stop(0.1))
    stated = branched(tmp_path, stop(0.1), surfaces={"left": {"sliding_friction": 0.5}})
    assert same_motion(event, whole)
    assert same_motion(stated, whole)


def test_an_open_outlet_stays_as_it_is(tmp_path):
    ended(tmp_path, OPENS, stop(0.1))
    with pytest.raises(BadInput, match="another wall floor_left: an outlet that is open"):
        branched(tmp_path, stop(0.2), silo__slit_width_m=0.08)


@pytest.mark.parametrize("content", [b"", b"CDF", None])
def test_a_file_that_is_no_end_is_refused(content, tmp_path):
    if content is not None:
        (tmp_path / "first.end").write_bytes(content)
    with pytest.raises(BadInput, match=r"start_from = 'first\.end'"):
        branched(tmp_path, stop(0.2))


def test_the_command_keeps_an_end_and_says_what_it_goes_on_from(tmp_path, capsys):
    first = copy.deepcopy(SMALL) | {"events": [stop(0.05)], "record": {"keep_end": True}}
    (tmp_path / "first.yaml").write_text(yaml.safe_dump(first))
    again = copy.deepcopy(SMALL) | {
        "start_from": "first.end",
        "events": [AT_ONCE, stop(0.1)],
        "record": {"snapshots_s": [0, 0.1]},
    }
    (tmp_path / "again.yaml").write_text(yaml.safe_dump(again))
    assert main(["dem", str(tmp_path / "first.yaml"), str(tmp_path / "first.nc")]) == 0
    assert main(["check", str(tmp_path / "again.yaml")]) == 0
    assert "goes on from first.end at 0.05 s" in capsys.readouterr().out
    assert main(["dem", str(tmp_path / "again.yaml"), str(tmp_path / "again.nc")]) == 0
    said = capsys.readouterr()
    assert "2000 steps of 2.5e-05 s" in said.out
    assert "no snapshots at 0 s: the run goes on from 0.05 s" in said.err
    assert read(tmp_path / "again.nc")["event_time"].values.tolist() == pytest.approx([0.05, 0.1])
    first["start_from"] = "first.end"
    (tmp_path / "first.yaml").write_text(yaml.safe_dump(first))
    assert main(["dem", str(tmp_path / "first.yaml"), str(tmp_path / "first.nc")]) == 2  # it would write over what it reads
    capsys.readouterr()


def test_a_pace_of_another_factor_is_told_by_its_key(tmp_path):
    following = {"march__step": "follow", "march__step_s": None}
    ended(tmp_path, stop(0.05), **following)
    with pytest.raises(BadInput, match=r"other march\.step_factor: 1\.0 there, 0\.7 here"):
        branched(tmp_path, stop(0.1), march__step_factor=0.7, **following)


@pytest.mark.parametrize(
    ("events", "told"),
    [
        (
            [stop(0.03)],
            r"events\.0\.value = 0\.03: the run would stop where it begins: must come after 0\.05 s, where first\.end",
        ),
        ([OPENS, {"when": "after", "value": 0.0, "do": "stop"}], r"events\.1\.value = 0\.0: .*must come after 0\.05 s"),
    ],
)
def test_a_stop_before_the_branch_is_refused(events, told, tmp_path):
    ended(tmp_path, stop(0.05))
    with pytest.raises(BadInput, match=rf"branch\.yaml: {told}") as caught:
        branched(tmp_path, *events)
    assert "\n" not in str(caught.value)


def test_an_energy_balance_that_begins_with_the_branch_closes_from_there(tmp_path):
    ended(tmp_path, OPENS, stop(0.12))
    branch = branched(tmp_path, stop(0.2), record__energy=True)
    entries = np.array(branch.recording.energy)
    held = [balance(account) for account in entries]
    turnover = np.abs(np.diff(entries[:, :2], axis=0)).sum()
    np.testing.assert_allclose(held, held[0], atol=1e-9 * turnover, rtol=0.0)
    out = entries[:, CARRIED_OUT]
    assert branch.dropped > 0.0
    assert out[0] == pytest.approx(0.0, abs=0.1 * abs(out[-1]))  # what had left before is no part of it


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
        assert [action for *_, action in branch.recording.happened] == ["open right", "stop"]
