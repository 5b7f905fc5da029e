"""Which spheres went over the walls of a silo, and which through its outlet."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.dem.engine import Engine
from silostudy.dem.leaving import at_level, below, passing, spilt
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


@pytest.mark.parametrize("unequal", [False, True])
def test_what_is_below_the_outlet_goes_once_it_touches_nothing(unequal):
    chance, most = np.random.default_rng(3), 2e-3
    place = np.c_[chance.uniform(-0.02, 0.02, (300, 2)), chance.uniform(-0.02, 0.01, 300)]
    radius = chance.uniform(0.5, 1.0, 300) * most if unequal else np.full(300, most)
    x, y, z = place.T
    engine = Engine(replace(bin_of_spheres(Bin(count=300, wide=0.03)), x=x, y=y, z=z, radius=radius), sort=False)
    apart = np.linalg.norm(place[:, None] - place, axis=-1) - radius[:, None] - radius + 2.0 * np.diag(radius + 1.0)
    gone = (z < -radius) & (apart > 0.0).all(axis=1)
    assert np.array_equal(below(engine, 0.0), gone)
    assert 20 < gone.sum() < (z < -radius).sum() - 20
