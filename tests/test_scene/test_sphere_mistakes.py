"""Mistakes in scenes of spheres that are told in one line before anything is built."""

from pathlib import Path

import pytest

from silostudy.compute.dem import run_of, scene_model
from silostudy.errors import BadInput
from tests.test_spheres.small import scene_of

STOP = {"when": "after", "value": 0.1, "do": "stop"}
TAKEN = [{"when": "rest", "do": "take_away", "surfaces": ["wall"]}, {"when": "after", "value": 0.1, "do": "stop"}]
RING = {"kind": "disc", "name": "ring", "radius_m": 0.01, "hole_radius_m": 0.02, "height_m": 0.05}
WIDE = {"silo__diameter_m": 60.0, "silo__hopper": None, "filling": {"kind": "loose", "count": 150}, "events": TAKEN[1:]}


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"events": TAKEN}, r"events\.0\.surfaces = 'wall': the scene has no inserts to take away"),
        ({"inserts": [RING]}, r"the radius of its hole must be less than its own, 0\.01 m"),
        (WIDE, r"silo = '60 m wide': a layer of spheres of 8 mm would hold 5\.1e\+07 of them, at most 2e\+07 can be"),
    ],
    ids=["no inserts", "hole wider than its ring", "metres for millimetres"],
)
def test_it_is_told(changes, told):
    scene = scene_of(**changes)
    with pytest.raises(BadInput, match=told):
        run_of(scene, scene_model(scene, Path(), "small.yaml"))


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"accuracy": {"mean_outflow": 0.1}, "events": [STOP]}, r"accuracy: mean_outflow: no event lets grains out"),
        (
            {"accuracy": {"mean_wall_force": 0.1}, "events": [{"when": "time", "value": 0.01, "do": "open_outlet"}, STOP]},
            r"accuracy: mean_wall_force: is of the last window before the first event, which comes at 0\.01 s",
        ),
        ({"accuracy": {"mean_outflow": 5}}, r"accuracy\.mean_outflow = 5: must be less than 1"),
        (
            {"march": {"limit_s": 1.0, "step_s": 1e-6, "step_factor": 0.5}},
            r"march\.step_factor = 0\.5: does nothing",
        ),
    ],
)
def test_what_cannot_be_kept_is_told_before_anything_runs(changes, told):
    with pytest.raises(BadInput, match=told):
        scene_of(**changes)


@pytest.mark.parametrize(
    ("key", "section"),
    [
        ("seed", {"seed": True}),
        ("filling.count", {"filling__count": False}),
        ("gravity_m_s2.2", {"gravity_m_s2": [0.0, 0.0, True]}),
        ("record.fields.cells.0", {"record": {"fields": {"cells": [True, 4], "every_s": 0.1}}}),
    ],
)
def test_a_switch_is_no_number(key, section):
    with pytest.raises(BadInput, match=rf"{key} = (True|False): must be a number"):
        scene_of(**section)


@pytest.mark.parametrize(("key", "section"), [("lid", {"lid": 1}), ("record.energy", {"record__energy": 0.0})])
def test_a_number_is_no_switch(key, section):
    with pytest.raises(BadInput, match=rf"{key} = [01.]+: must be true or false"):
        scene_of(**section)
