"""Discs share what moves: a lid that is pressed and moved, a feeder under the slit; the ledger closes over both."""

import numpy as np
import pytest

from silostudy.compute.dem_cube import cube_of
from silostudy.dem.feeder import shortfall
from silostudy.dem.ledger import TURNOVER, WALLS, balance
from silostudy.errors import BadInput
from tests.test_dem.small import carried, scene_of

RATE = 20.0
EVENTS = [
    {"when": "time", "value": 0.05, "do": "lower_lid"},
    {"when": "after", "do": "press_lid", "stress_kPa": 5.0, "speed_m_s": 0.5},
    {"when": "lid_rests", "do": "move_lid", "speed_m_s": 0.02, "until_stress_kPa": 10.0},
    {"when": "lid_rests", "do": "feed", "rate_kg_s": RATE},
    {"when": "after", "value": 0.2, "do": "stop"},
]


def test_a_lid_that_the_silo_does_not_have():
    with pytest.raises(BadInput, match=r"events\.0\.do = 'lower_lid': needs silo\.lid: true"):
        scene_of(events=EVENTS)
    with pytest.raises(BadInput, match=r"events\.3\.do = 'feed': needs a silo\.slit_width_m above 0"):
        scene_of(events=EVENTS, silo__lid=True, silo__slit_width_m=0.0)


@pytest.mark.long
def test_discs_are_pressed_and_fed_from_the_file_to_the_cube():
    scene = scene_of(events=EVENTS, silo__lid=True, record={"wall_force_window_s": 0.005, "energy": True})
    whole = carried(scene)
    assert not whole.trouble
    times = {action.partition(":")[0]: time for time, _, action in whole.recording.happened}
    cube = cube_of(whole, scene)
    assert float(cube.lid_stress.sel(window_time=times["move_lid"], method="nearest")) == pytest.approx(5e3, rel=0.05)
    assert float(cube.lid_height[-1]) < float(cube.lid_height[0]) == pytest.approx(0.4)
    mass = float(cube.disc_mass[0])
    assert whole.recording.lost["discharged"] == pytest.approx(RATE * 0.2, abs=2.0 * mass)
    assert whole.recording.left["discharged"] > 2
    account = whole.engine.ledger.account
    started = carried(scene_of(events=[{"when": "time", "do": "stop"}], silo__lid=True)).engine
    start = -float(started.mass @ started.bodies.rows[: started.n, :2] @ started.gravity)
    assert account[WALLS] > 0.0
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]


@pytest.mark.long
def test_how_many_cells_a_wall_has_changes_no_bit_of_what_a_lid_does():
    runs = [carried(scene_of(events=EVENTS, silo__lid=True, silo__wall_cells=cells)) for cells in (3, 8)]
    assert np.array_equal(*(run.engine.bodies.rows[: run.engine.n] for run in runs))
    assert np.array_equal(*(np.array(run.recording.whole) for run in runs))


@pytest.mark.parametrize(("rate", "told"), [(RATE / 2.0, False), (40.0 * RATE, True)])
def test_a_feeder_that_cannot_keep_its_rate_is_told(rate, told):
    feed = [{"when": "time", "value": 0.05, "do": "feed", "rate_kg_s": rate}, {"when": "after", "value": 0.2, "do": "stop"}]
    run = carried(scene_of(events=feed, record={}))
    missed = 1.0 - run.dropped / (rate * 0.2)
    assert bool(shortfall(run)) == told == (missed > 0.5)
    if told:
        assert shortfall(run).startswith(f"the feeder took {100.0 * run.feeder.missed / run.feeder.asked:.2g} % less than the")
        assert run.feeder.missed / run.feeder.asked == pytest.approx(missed, abs=0.02)
