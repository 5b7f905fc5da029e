"""Branches of runs of discs: the same bits as in one go, another outlet or friction, and ends that do not fit."""

import copy
import re

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.dem import scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.cube.io import read
from silostudy.dem.ledger import CARRIED_OUT, balance
from silostudy.dem.likeness import as_events_left
from silostudy.errors import BadInput
from tests.test_dem.branches import AT_ONCE, OPENS, PLAIN, branched, ended, of_branch, same_motion, stop
from tests.test_dem.small import SMALL, carried, scene_of
from tests.test_spheres.small import scene_of as spheres_of

pytestmark = pytest.mark.long


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


def test_what_events_changed_stays(tmp_path):
    changes = [{"when": "time", "value": 0.01, "do": "set_friction", "disc_friction": 0.3},
               {"when": "time", "value": 0.02, "do": "set_gravity", "gravity_m_s2": [1.0, -9.0]}]  # fmt: skip
    ended(tmp_path, *changes, stop(0.04))
    branch = branched(tmp_path, stop(0.08))
    model = branch.engine.model
    assert as_events_left(model, model.end) == ["sliding_friction 0.3 of grains", "gravity_m_s2 [1.0, -9.0]"]
    assert same_motion(branch, carried(scene_of(events=[*changes, stop(0.08)], **PLAIN)))


TWO = [{"name": "one", "width_m": 0.03, "middle_m": 0.04}, {"name": "two", "width_m": 0.05, "middle_m": 0.12}]
NAMED = {"silo__slit_width_m": 0.0, "outlets": TWO, "silo__width_m": 0.17}


def test_a_cube_tells_what_had_opened_before_it_began(tmp_path):
    """Under the name that it has here, with or without one; the meter begins anew, at none."""
    second = OPENS | {"outlets": ["two"]}
    ended(tmp_path, second, stop(0.1), **NAMED)
    renamed = NAMED | {"outlets": [TWO[0], TWO[1] | {"name": "wide"}]}
    scene, branch = of_branch(tmp_path, OPENS | {"value": 0.15, "outlets": ["one"]}, stop(0.2), **renamed)
    cube = cube_of(branch, scene)
    assert cube["outlet"].values.tolist() == ["one", "wide"]
    assert cube["outlet_opened"].values.tolist() == pytest.approx([0.15, 0.05])
    assert (cube["outflow_time"][0], cube["outflow_mass"][0]) == (cube.attrs["began_s"], 0.0)
    assert cube["outlet_outflow_mass"][0].values.tolist() == [0.0, 0.0]
    ended(tmp_path, OPENS, stop(0.1))
    scene, branch = of_branch(tmp_path, stop(0.12))
    assert cube_of(branch, scene).attrs["outlet_opened_s"] == pytest.approx(0.05)


def test_the_scene_that_it_goes_on_from_with_more_events(tmp_path):
    """What had happened there is not done again, and what follows counts from it, as in one run."""
    begun, then = [OPENS], [{"when": "after", "value": 0.15, "do": "stop"}]
    whole = carried(scene_of(events=[*begun, *then], **PLAIN))
    ended(tmp_path, *begun, stop(0.12))
    branch = branched(tmp_path, *begun, *then)
    assert same_motion(branch, whole)
    assert branch.engine.time == whole.engine.time
    assert [action for *_, action in branch.recording.happened] == ["stop"]


RUBS = {"when": "time", "value": 0.05, "do": "set_friction", "wall_friction": 0.3}


@pytest.mark.parametrize(
    ("events", "told"),
    [
        ([RUBS, stop(0.2)], r"events\.0\.value = 0\.05: lies at 0\.05 s, before first\.end ends: must not be before 0\.12 s"),
        ([OPENS, RUBS | {"value": 0.06}, stop(0.2)], r"events\.1\.value = 0\.06: lies at 0\.06 s"),
        ([OPENS, RUBS | {"when": "after", "value": 0.02}, stop(0.2)], r"events\.1\.value = 0\.02: lies at 0\.07 s"),
    ],
)
def test_an_event_whose_time_has_passed_is_refused(events, told, tmp_path, capsys):
    scene = copy.deepcopy(SMALL) | {"events": [OPENS, stop(0.12)], "record": {"keep_end": True}}
    (tmp_path / "first.yaml").write_text(yaml.safe_dump(scene))
    assert main(["dem", str(tmp_path / "first.yaml"), str(tmp_path / "first.nc")]) == 0
    (tmp_path / "branch.yaml").write_text(yaml.safe_dump(scene | {"start_from": "first.end", "events": events}))
    for command in ("check", "explain", "dem"):
        assert main([command, str(tmp_path / "branch.yaml"), *([str(tmp_path / "branch.nc")] if command == "dem" else [])]) == 2
        assert re.search(rf"branch\.yaml: {told}", capsys.readouterr().err)


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
        (
            {"discs__normal_stiffness_N_m2": 9e6},
            "other normal_stiffness of discs: 9.46e+06 N m-2 there, 9e+06 here (discs.normal_stiffness_N_m2 9460000.0 there",
        ),
        ({"discs__tangential": "spring-slider-total"}, "other contact laws"),
        ({"march__step_s": 2e-5}, "other march.step_s: 2.5e-05 there, 2e-05 here"),
        ({"march__step": "follow", "march__step_s": None}, "other march.step: fixed there, follow here"),
        ({"silo__height_m": 0.5}, "another wall left: the body of the silo stays as it is"),
        ({"silo__width_m": 0.171}, "another wall right: the body of the silo stays as it is"),
        ({"discs__normal_stiffness_N_m2": 9e6, "march__step_s": None}, "other normal_stiffness of discs: 9.46e+06"),
        ({"walls__normal_damping_N_s_m2": 2e5}, "walls.normal_damping_N_s_m2 7955.0 there, 200000.0 here"),
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
