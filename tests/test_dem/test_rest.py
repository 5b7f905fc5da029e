"""What counts as at rest: by motions that are made up, so that nothing is compiled; in the long tier it is met by default."""

from types import SimpleNamespace

import numpy as np
import pytest

from silostudy.dem.rest import REST, STEADY, USUAL, Look, drift
from silostudy.scene.dem import rest_of
from tests.test_dem.small import carried, scene_of

DT, STEPS, GRAVITY = 1e-5, 200, 9.81
BRAKED = {"normal_stiffness_N_m2": 9.46e6, "normal_damping_N_s_m2": 3977, "sliding_friction": 0.577, "rolling_friction": 0.1}


def moved(way) -> tuple:
    """An engine of two bodies one of which has left, and how it looked earlier; way (m): of the other since then."""
    model = SimpleNamespace(dt=DT)
    places = np.array([[0.0, way], [np.nan, np.nan]])
    engine = SimpleNamespace(n=1, step=1000 + STEPS, model=model, gravity=(0.0, -GRAVITY), places=places)
    return engine, Look(1000, np.array([[0.0, 0.0], [1.0, 1.0]]))


def test_a_fall_from_rest_drifts_by_one():
    assert drift(*moved(0.5 * GRAVITY * (STEPS * DT) ** 2)) == pytest.approx(1.0, rel=1e-12)


def test_what_comes_back_has_not_drifted():
    assert drift(*moved(0.0)) == 0.0
    assert drift(moved(0.0)[0], None) == np.inf


def test_a_law_that_never_settles_is_looked_at_by_drift():
    torque = BRAKED | {"rolling": "constant-torque"}
    assert rest_of(scene_of()).criterion is USUAL
    assert rest_of(scene_of(discs=torque)).criterion is STEADY
    assert rest_of(scene_of(walls=torque)).criterion is STEADY
    asked = {"criterion": "displacement", "below": 1e-5}
    assert rest_of(scene_of(discs=torque, rest=asked)).criterion is REST["displacement"]


@pytest.mark.long
@pytest.mark.parametrize("rolling", ["none", "constant-torque"])
def test_rest_is_met_by_default(rolling):
    discs = BRAKED | {"rolling": rolling}
    run = carried(scene_of(discs=discs, walls=discs, events=[{"when": "rest", "do": "stop"}], record={}))
    assert not run.trouble
    assert run.engine.time > 0.05
    assert np.abs(run.engine.bodies.rows[: run.engine.n, 2:4]).mean() < 1e-3
