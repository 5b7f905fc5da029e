"""Moments of a scene: the snapshots that show it, and the words of its events."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.figures.flow_in_time import Flow
from silostudy.figures.moments import mark_events, snapshots, told, words


def scene(*events, shots=(0.0, 1.0, 2.0, 3.0), contacts=(1, 2, 3), held=(1, 1, 1, 1), **more):
    times, actions = zip(*events, strict=True)
    height = np.where(np.array(held, bool), 0.1, np.nan)[:, None]
    events = {"event_time": ("event", list(times)), "event_action": ("event", list(actions))}
    shown = {"snapshot_time": ("snapshot", list(shots)), "grain_z": (("snapshot", "grain"), height)}
    return xr.Dataset(events | shown | {"contact_snapshot": ("contact", list(contacts))} | more)


def flow(*times):
    mass = np.arange(1.0, len(times) + 1.0)
    return Flow(pd.DataFrame({"time_s": list(times), "outlet": "outlet", "mass_kg": mass}), "mass_kg", 10.0, "kg")


def test_a_discharge_is_shown_before_it_and_halfway():
    """At 1 s grains hang below the outlet, and none has left."""
    cube = scene((0.9, "rest: open_outlet"), (3.0, "after: stop"))
    assert snapshots(cube, np.ones(3), flow(1.5, 1.8, 1.9, 2.9)) == [0, 2]
    words = told([0, 2], cube, flow(1.5))
    assert "the last before the outlet opens, and that nearest to when half of what leaves" in words


def test_what_a_feeder_takes_is_shown_before_the_first_grain():
    cube = scene((0.9, "rest: feed"), (3.0, "after: stop"))
    assert snapshots(cube, np.ones(3), flow(1.5, 1.8, 1.9, 2.9)) == [1, 2]
    assert "the last before any grain has left" in told([1, 2], cube, flow(1.5))


def test_a_run_that_goes_on_in_flow_is_shown_from_its_first_snapshot():
    mass = {"outflow_time": [0.1, 0.2], "outflow_mass": ("outflow_time", [1.0, 2.0])}
    cube = scene((0.9, "after: set_friction"), (3.0, "after: stop"), **mass).assign_attrs(outlet_opened_s=-0.2, began_s=-0.1)
    assert snapshots(cube, np.ones(3), flow(0.1, 1.8, 1.9, 2.9)) == [0, 2]
    assert "the first, and that nearest" in told([0, 2], cube, flow(0.1))


def test_a_silo_that_holds_nothing_yet_or_any_more_is_not_shown():
    cube = scene((0.0, "time: open_outlet"), (3.0, "after: stop"), held=(0, 1, 1, 0))
    assert snapshots(cube, np.ones(3), flow(1.5, 2.8, 2.9)) == [2]
    assert snapshots(scene((3.0, "rest: stop"), held=(0, 0, 0, 0)), np.ones(3), flow()) == [3]


def test_a_scene_that_stays_shut_is_shown_before_its_first_event_and_most_loaded():
    cube = scene((0.5, "rest: lower_lid"), (3.0, "after: stop"))
    assert snapshots(cube, np.array([1.0, 9.0, 1.0]), flow()) == [0, 2]
    assert "largest forces" in told([0, 2], cube, flow())


@pytest.mark.parametrize("contacts", [(1, 2, 3), ()])
def test_a_scene_that_only_comes_to_rest_is_shown_once(contacts):
    cube = scene((3.0, "rest: stop"), contacts=contacts)
    cube = cube if contacts else cube.drop_vars("contact_snapshot")
    assert snapshots(cube, np.ones(len(contacts)), flow()) == [3]
    assert told([3], cube, flow()) == ""


def said(*events):
    figure, panel = plt.subplots(figsize=(5.0, 3.0))
    panel.set_xlim(0.0, 10.0)
    mark_events([panel], scene(*events), 4.0)
    texts = [(text.get_text(), text.xy[0]) for text in panel.texts]
    plt.close(figure)
    return texts


def test_an_event_that_comes_again_has_its_words_again():
    assert said((2.0, "rest: press_lid"), (4.0, "lid_rests: press_lid")) == [("press lid", 2.0), ("press lid", 4.0)]


def test_events_that_come_close_are_told_together():
    lid = said((2.0, "rest: lower_lid"), (2.0, "after: press_lid"), (4.0, "time: stop"))
    assert lid == [("lower lid, press lid", 2.0), ("stop", 4.0)]
    many = [(2.0 + 0.01 * k, "after: feed") for k in range(5)]
    assert said(*many) == [("feed, feed, feed, 2 more", 2.0)]


def test_words_of_events_are_what_is_done_and_on_what():
    nothing, outlets = (1.0, "time: remove_sphere nothing: the sphere was not there"), (2.0, "rest: open_outlet a_1, b")
    belt = (3.0, "after: run_belt floor: velocity_m_s 0.1 0.0 0.0")
    assert words(scene(nothing, outlets, belt)) == ["remove sphere nothing", "open outlet a_1, b", "run belt floor"]
