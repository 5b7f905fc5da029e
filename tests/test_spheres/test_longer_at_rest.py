"""Steps of spheres that are longer at rest: none while they rain in, however still those are that lie."""

import numpy as np

from silostudy.dem.calm import fastest
from silostudy.dem.pace import LIVELY, TICKS
from tests.test_spheres.small import carried, scene_of

QUARTER = {"limit_s": 1.0, "step": "longer_at_rest", "step_factor": 0.25}
OPENS = [{"when": "time", "value": 0.8, "do": "open_outlet"}, {"when": "after", "value": 0.1, "do": "stop"}]


def test_steps_are_short_while_spheres_rain_in_and_flow():
    bin_ = carried(scene_of(march=QUARTER, events=OPENS, record={}))
    model = bin_.engine.model
    since, ticks = np.array(bin_.recording.steps).T
    opened = bin_.recording.happened[0][0]
    longest = since[ticks == model.pace.longest] * model.dt
    assert longest.min() > bin_.came * model.dt
    assert longest.max() < opened
    assert (ticks[-1], model.pace.longest) == (TICKS, 4 * TICKS)
    assert bin_.dropped > 0.0
    assert fastest(bin_.engine) > LIVELY
