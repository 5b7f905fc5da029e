"""Branches of runs of spheres: rain, spins, springs and the meter go on; one filling is opened in several ways."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.compute.branches import keep_end
from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.cube.io import read
from silostudy.errors import BadInput
from silostudy.sweep.merge import merge
from tests.test_spheres.small import carried, content, scene_of
from tests.test_sweep.sweeps import compute

pytestmark = pytest.mark.long
FLAT = {"silo": {"plan": "circular", "diameter_m": 0.06, "cylinder_depth_m": 0.1}, "outlets": [{"width_m": 0.04}]}
FLAT |= {"record__snapshots_s": [], "record__fields": None, "record__contact_statistics": None}
OPENS, AT_ONCE = {"when": "rest", "do": "open_outlet"}, {"when": "after", "value": 0.0, "do": "open_outlet"}


def stop(time):
    return {"when": "time", "value": time, "do": "stop"}


def ended(folder, *events, **changes):
    scene = scene_of(events=[*events], **copy.deepcopy(FLAT) | changes)
    run = carried(scene)
    keep_end(run, scene, folder / "first.end")
    return run, cube_of(run, scene)


def branched(folder, *events, threads=1, **changes):
    scene = scene_of(events=[*events], start_from="first.end", **copy.deepcopy(FLAT) | changes)
    run = run_of(scene, scene_model(scene, folder, "branch.yaml"), threads=threads)
    run.go()
    return run, cube_of(run, scene)


def same_motion(one, other):
    return np.array_equal(one.engine.labels, other.engine.labels) and np.array_equal(
        one.engine.bodies.rows[: one.engine.n], other.engine.bodies.rows[: other.engine.n]
    )


@pytest.fixture(scope="module")
def whole():
    scene = scene_of(events=[OPENS, stop(0.7)], **FLAT)
    run = carried(scene)
    return run, cube_of(run, scene)


@pytest.mark.parametrize("stopped", [0.0501, 0.4, 0.6])  # while they rain in, while they settle, while they flow out
def test_a_run_and_its_branch_have_the_bits_of_one_run(stopped, whole, tmp_path):
    opened = float(whole[1].event_time[0])
    assert 0.4 < opened < 0.6
    _, before = ended(tmp_path, *([OPENS] if stopped > opened else []), stop(stopped))
    branch, after = branched(tmp_path, *([] if stopped > opened else [OPENS]), stop(0.7), threads=2)
    assert same_motion(branch, whole[0])
    assert branch.come == 150
    assert np.array_equal(np.r_[before.outflow_time, after.outflow_time[1:]], whole[1].outflow_time)
    assert (after.outflow_time[0], after.outflow_mass[0]) == (after.attrs["began_s"], 0.0)


def test_one_filling_is_opened_in_several_ways(tmp_path):
    """A study of branches: as many cases, one filling; each is what it would be if filled for itself."""
    ended(tmp_path, {"when": "rest", "do": "stop"}, outlets=[])
    scene = content(events=[AT_ONCE, {"when": "after", "value": 0.1, "do": "stop"}], start_from="first.end", **FLAT)
    study = {"kind": "scenes", "title": "one filling", "scene": scene,
             "sweep": [{"axis": "outlet_width", "values": {"outlets.0.width_m": [0.03, 0.05]}}]}  # fmt: skip
    (tmp_path / "ways.yaml").write_text(yaml.safe_dump(study))
    compute(tmp_path / "ways.yaml", tmp_path / "parts")
    merge(tmp_path / "ways.yaml", tmp_path / "parts", tmp_path / "scenes.nc")
    flow = read(tmp_path / "scenes.nc")["mean_mass_flow"]
    assert 0.0 < float(flow[0]) < float(flow[1])
    alone = scene_of(events=[OPENS, {"when": "after", "value": 0.1, "do": "stop"}], **FLAT | {"outlets": [{"width_m": 0.05}]})
    assert cube_of(carried(alone), alone).attrs["mean_outflow_kg_s"] == float(flow[1])


def test_another_silo_or_another_material_is_refused(tmp_path):
    ended(tmp_path, stop(0.02))
    with pytest.raises(BadInput, match="another wall wall: the body of the silo stays as it is"):
        branched(tmp_path, stop(0.1), silo__diameter_m=0.061)
    for changes, told in (
        ({"wall__youngs_modulus_MPa": 1}, r"hertz_stiffness of walls.* \(wall\.youngs_modulus_MPa 100\.0 there, 1\.0 here\)"),
        (
            {"grain__softened_modulus_MPa": 50, "march__step_s": 3.7e-5},
            r"of spheres.* \(grain\.softened_modulus_MPa 5\.0 there",
        ),
        ({"spheres__restitution": 0.9}, r"other hertz_damping of spheres.* \(spheres\.restitution 0\.3 there, 0\.9 here\)"),
    ):
        with pytest.raises(BadInput, match=told):
            branched(tmp_path, stop(0.1), **changes)


FILLING = 0.0501
ON_THE_FLOOR = {"when": "time", "value": 0.03, "do": "set_friction", "wall_friction": 0.05, "surfaces": ["floor"]}
TURNS = {"when": "time", "value": 0.03, "do": "rotate", "spin_rad_s": 5.0, "surfaces": ["wall"]}
WIDENS = {"when": "time", "value": 0.03, "do": "open_outlet", "speed_m_s": 0.5}


@pytest.mark.parametrize(
    ("before", "then", "records"),
    [
        ([ON_THE_FLOOR], [], {}),
        ([WIDENS], [], {}),
        ([TURNS], [], {}),
        ([], [OPENS | {"when": "time", "value": 0.06, "speed_m_s": 0.5}], {}),
        ([], [], {"record__wall_force_window_s": None}),
    ],
    ids=[
        "a floor of its own friction",
        "an outlet that opens",
        "a wall that turns",
        "one that opens in the branch",
        "other records",
    ],
)
def test_a_branch_goes_on_whatever_moves_or_is_recorded(before, then, records, tmp_path):
    whole = carried(scene_of(events=[*before, *then, stop(0.08)], **copy.deepcopy(FLAT)))
    ended(tmp_path, *before, stop(FILLING))
    branch, _ = branched(tmp_path, *then, stop(0.08), **records)
    assert same_motion(branch, whole)
    assert branch.engine.n > 0


WEST, EAST = ({"name": name, "width_m": 0.018, "middle_m": [x, 0.0]} for name, x in (("west", -0.014), ("east", 0.015)))
SLOT = {"name": "slot", "width_m": 0.01, "length_m": 0.02, "middle_m": [0.014, 0.0]}


def test_other_outlets_in_place_of_shut_ones_while_one_opens(tmp_path):
    begins = {"when": "time", "value": 0.03, "do": "open_outlet", "outlets": ["west"], "speed_m_s": 0.2}
    then = {"when": "time", "value": 0.06, "do": "open_outlet", "outlets": ["slot"]}
    whole = carried(scene_of(events=[begins, then, stop(0.15)], **copy.deepcopy(FLAT) | {"outlets": [SLOT, WEST]}))
    ended(tmp_path, begins, stop(FILLING), outlets=[WEST, EAST])
    branch, _ = branched(tmp_path, then, stop(0.15), outlets=[SLOT, WEST])
    assert same_motion(branch, whole)
    assert branch.dropped == whole.dropped > 0.0
    with pytest.raises(BadInput, match="the outlet west open, which this scene has not"):
        branched(tmp_path, then, stop(0.15), outlets=[SLOT])


def test_outlets_that_are_open_stay_open(tmp_path):
    """An event with no names opens the other one, at its speed, in one run as in a branch; what opens nothing is refused."""
    first = {"when": "time", "value": 0.03, "do": "open_outlet", "outlets": ["west"]}
    rest = {"when": "time", "value": 0.06, "do": "open_outlet", "speed_m_s": 0.2}
    named = carried(scene_of(events=[first, rest | {"outlets": ["east"]}, stop(0.15)], **FLAT | {"outlets": [WEST, EAST]}))
    whole = carried(scene_of(events=[first, rest, stop(0.15)], **FLAT | {"outlets": [WEST, EAST]}))
    assert same_motion(whole, named)
    assert [action for *_, action in whole.recording.happened] == [
        "open_outlet west",
        "open_outlet east: speed_m_s 0.2",
        "stop",
    ]
    ended(tmp_path, first, stop(FILLING), outlets=[WEST, EAST])
    branch, cube = branched(tmp_path, rest, stop(0.15), outlets=[WEST, EAST])
    assert same_motion(branch, whole)
    assert branch.recording.happened == whole.recording.happened[1:]
    assert cube["outlet_opened"].values.tolist() == pytest.approx([0.03, 0.06], abs=1e-4)
    for again in (rest, first):
        told = r"events\.0\.do = 'open_outlet': opens nothing: open by then, where first\.end ends"
        with pytest.raises(BadInput, match=told):
            branched(tmp_path, again | {"value": 0.06, "outlets": ["west"]}, stop(0.15), outlets=[WEST, EAST])
