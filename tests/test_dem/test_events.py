"""Events of a scene, its shaking, and refusals in one line."""

from pathlib import Path

import numpy as np
import pytest

from silostudy.compute.dem import scene_model
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.run import Run
from silostudy.errors import BadInput
from tests.test_dem.small import carried, given, scene_of

from .scenes import silo

REFUSED = {
    "step beyond the bound": ({"march__step_s": 1e-4}, "stability bound"),
    "slit wider than the floor": ({"silo__slit_width_m": 0.2}, "smaller than the floor"),
    "zero radius": ({"radius_m": 0.0}, "radius_m"),
    "negative stiffness": ({"discs__normal_stiffness_N_m2": -1.0}, "normal_stiffness_N_m2"),
    "NaN": ({"density_kg_m3": float("nan")}, "density_kg_m3"),
    "unknown law": ({"discs__tangential": "glue"}, "unknown; known: none, spring-slider"),
    "unknown key": ({"record__colour": "red"}, "unknown key"),
    "no stop": ({"events": [{"when": "rest", "do": "open_slit"}]}, "stop"),
    "two dampings": ({"discs__damping_ratio": 0.5}, "not more than one"),
    "too many across": ({"packing__across": 9}, "do not fit"),
    "no such file": ({"packing": {"kind": "given", "file": "none.nc"}}, "none.nc"),
    "no cells of fields": ({"record": {"fields": {"cells": [0, 3], "every_s": 0.1}}}, "must be greater than or equal to 1"),
    "too many cells a way": (
        {"record": {"fields": {"cells": [3, 9999], "every_s": 0.1}}},
        "must be less than or equal to 1000",
    ),
    "too many cells": ({"record": {"fields": {"cells": [900, 900], "every_s": 0.1}}}, "must be 100000 at most together"),
    "cells in space": ({"record": {"fields": {"cells": [3, 3, 3], "every_s": 0.1}}}, "must be two, across and up"),
    "fields too late": ({"record": {"fields": {"cells": [3, 3], "every_s": 99}}}, "must not be longer than march.limit_s"),
    "rest has no value": (
        {"events": [{"when": "rest", "value": 3.0, "do": "stop"}]},
        "events.0.value = 3.0: must be left out where when is rest",
    ),
    "a disc removed twice": (
        {"events": [*[{"when": "after", "do": "remove_disc", "disc": 1}] * 2, {"when": "after", "do": "stop"}]},
        "events.1.disc = 1: is taken out twice",
    ),
    "no such record": ({"quake": {"file": "none.csv"}}, "none.csv"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refusals(case):
    changes, message = REFUSED[case]
    with pytest.raises(BadInput, match=message):
        scene_model(scene_of(**changes), Path(), "small.yaml")


def test_starts_that_cannot_be(tmp_path):
    with pytest.raises(BadInput, match=r"discs 0, 1.*overlap"):
        scene_model(given(tmp_path, [0.05, 0.06], [0.05, 0.05]), Path())
    with pytest.raises(BadInput, match=r"disc 1.*wall left"):
        scene_model(given(tmp_path, [0.05, -0.06], [0.05, 0.05]), Path())


def test_events_remove_and_change():
    events = [
        {"when": "time", "value": 0.01, "do": "remove_disc", "disc": 3},
        {"when": "after", "value": 0.0, "do": "remove_disc", "near_m": [0.16, 0.2]},
        {"when": "after", "value": 0.005, "do": "set_friction", "disc_friction": 0.1},
        {"when": "after", "value": 0.0, "do": "set_gravity", "gravity_m_s2": [0.0, 0.0]},
        {"when": "after", "value": 0.005, "do": "stop"},
    ]
    run = carried(scene_of(events=events))
    assert run.engine.n == len(run.engine.model.x) - 2
    assert 3 not in run.engine.labels
    assert run.engine.contacts[0].coefficients["sliding_friction"] == 0.1
    assert run.engine.contacts[1].coefficients["sliding_friction"] == 0.176
    assert run.engine.gravity == (0.0, 0.0)
    told = [what for _, _, what in run.recording.happened]
    (by_place,) = set(range(len(run.engine.model.x))) - {3, *run.engine.labels.tolist()}
    assert told[:2] == ["remove_disc 3", f"remove_disc {by_place}: near_m 0.16 0.2"]
    assert told[2:] == ["set_friction: disc_friction 0.1", "set_gravity: gravity_m_s2 0.0 0.0", "stop"]


def test_an_event_due_at_the_start_acts_at_once():
    """Whatever windows are recorded: the first stop of a run must not decide when a slit opens."""
    open_slit = Event("time", 0.0, "open", ("floor", "floor_left", "floor_right"))
    places = []
    for window in (0, 40, 200):
        run = Run(Engine(silo()), (open_slit, Event("time", 0.05, "stop")), limit=1.0, window=window)
        assert run.go().happened[0] == (0.0, "time", "open")
        places.append(run.engine.places)
    assert np.array_equal(places[0], places[1])
    assert np.array_equal(places[0], places[2])


def test_discharge_stops_at_a_share():
    events = [{"when": "time", "value": 0.01, "do": "open_slit"}, {"when": "discharged", "value": 0.03, "do": "stop"}]
    run = carried(scene_of(events=events))
    assert 0.03 <= run.dropped / run.full < 0.2
    assert run.recording.happened[-1][1:] == ("discharged", "stop")


@pytest.mark.long
def test_a_hopper_empties_through_its_mouth():
    """Loose discs of many sizes rain into a hopper, rest on it, and leave when its mouth opens; none passes a wall."""
    scene = scene_of(
        silo={"width_m": 0.17, "height_m": 0.4, "slit_width_m": 0.08, "hopper_half_angle_deg": 20.0, "lid": True},
        packing={"kind": "loose", "count": 60, "radius_spread": 0.3},
        radius_m=0.006,
        march={"limit_s": 3.0},
        events=[{"when": "time", "value": 0.6, "do": "open_slit"}, {"when": "discharged", "value": 1.0, "do": "stop"}],
        record={"snapshots_s": [0.5]},
    )
    run = carried(scene)
    (full,) = run.recording.snapshots
    assert len(full["label"]) == 60
    assert full["motion"][:, 1].min() > 0.0
    assert set(full["walls"][:, 1]) >= {0.0, 1.0}
    assert run.recording.happened[-1][1:] == ("discharged", "stop")
    assert run.engine.n == 0


def test_shaking(tmp_path):
    record = tmp_path / "base.csv"
    record.write_text("time_s,x_m_s2,y_m_s2\n0,2.0,0\n10,2.0,0\n")
    scene = scene_of(
        quake={"file": str(record)}, events=[{"when": "time", "value": 0.001, "do": "stop"}], gravity_m_s2=[0.0, 0.0]
    )
    run = carried(scene)
    assert np.median(run.engine.column(2)) == pytest.approx(-2.0 * run.engine.time, rel=1e-9)


def test_shaking_after_the_end_is_refused(tmp_path):
    record = tmp_path / "late.csv"
    record.write_text("time_s,x_m_s2,y_m_s2\n1.0,5,0\n1.1,5,0\n")
    scene = scene_of(quake={"file": str(record)}, march={"limit_s": 0.5})
    with pytest.raises(BadInput, match=r"quake.file = 1.0: must begin before the run ends, at 0.5 s"):
        scene_model(scene, tmp_path)
