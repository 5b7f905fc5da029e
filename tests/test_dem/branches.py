"""Runs of the small silo of discs whose end is kept, and runs that go on from there."""

import numpy as np

from silostudy.compute.branches import keep_end
from silostudy.compute.dem import run_of, scene_model
from tests.test_dem.small import carried, scene_of

OPENS = {"when": "time", "value": 0.05, "do": "open_slit"}
AT_ONCE = {"when": "after", "value": 0.0, "do": "open_slit"}
PLAIN = {"record__fields": None, "record__snapshots_s": []}


def stop(time):
    return {"when": "time", "value": time, "do": "stop"}


def ended(folder, *events, name="first.end", **changes):
    """A run whose end is kept, and its scene."""
    scene = scene_of(events=[*events], **PLAIN | changes)
    run = carried(scene)
    keep_end(run, scene, folder / name)
    return run


def branched(folder, *events, **changes):
    """A run that goes on from that end."""
    return of_branch(folder, *events, **changes)[1]


def of_branch(folder, *events, **changes):
    """The scene of such a run, and the run."""
    scene = scene_of(events=[*events], start_from="first.end", **PLAIN | changes)
    run = run_of(scene, scene_model(scene, folder, "branch.yaml"))
    run.go()
    return scene, run


def same_motion(one, other):
    return np.array_equal(one.engine.labels, other.engine.labels) and np.array_equal(
        one.engine.bodies.rows[: one.engine.n], other.engine.bodies.rows[: other.engine.n]
    )
