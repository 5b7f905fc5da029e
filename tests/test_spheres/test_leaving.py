"""Which spheres went over the walls of a silo, and which through its outlet."""

from types import SimpleNamespace

import numpy as np

from silostudy.dem.leaving import at_level, passing, spilt
from silostudy.dem.space.dimension import SPACE
from silostudy.dem.space.lanes import PASSED
from silostudy.scene.silo import Silo
from silostudy.scene.space_silo import Outlet, SpaceSilo


def test_what_drifts_beyond_a_wall_below_a_slot_went_through_it():
    """Two spheres stand at one place beyond a wall: one came there from the end of a slot, the other fell straight."""
    silo = Silo(plan="rectangular", diameter=0.04, length=0.1, wall_depth=0.2)
    walls = SpaceSilo(silo=silo, outlets=(Outlet(width=0.04, length=0.03),)).walls()
    rows = np.zeros((2, SPACE.row))
    rows[:, SPACE.place], rows[:, PASSED] = (0.022, 0.0, -0.02), 40.0
    rows[0, SPACE.velocity], rows[1, SPACE.velocity] = (0.1, 0.0, -0.5), (0.0, 0.0, -0.5)
    model = SimpleNamespace(walls=walls, dt=1e-3)
    engine = SimpleNamespace(
        n=2, bodies=SimpleNamespace(rows=rows), space=SPACE, model=model, step=100, ticks=1, mass=np.ones(2)
    )
    assert np.allclose(at_level(engine), [(0.018, 0.0, 0.0), (0.022, 0.0, 0.0)])
    assert spilt(engine).tolist() == [False, True]
    assert passing(engine, ~spilt(engine), None, 0) == [(0.06, 1.0, 0)]
