"""Springs against twisting shorten the stable step, to that of the fastest twisting of the network."""

from math import sqrt

import numpy as np
import pytest

from silostudy.dem.contacts import Contact
from silostudy.dem.engine import Engine
from silostudy.dem.pieces import Laws
from silostudy.dem.stability import longest_step
from tests.test_spheres.scenes import INERTIA, RADIUS, rows, spheres

STIFFNESS = 1e-3  # N m: far stiffer, for the sphere's inertia, than the softest of normal springs
SOFT = Laws.of(normal="hertz", twisting="spring-dashpot-slider")
PRESSED = 1.99 * RADIUS * np.arange(3)


def twisting(stiffness=STIFFNESS) -> Contact:
    values = {"hertz_stiffness": 1e-3, "hertz_damping": 0.0, "twisting_stiffness": stiffness, "twisting_damping": 0.0}
    return Contact(SOFT, values | {"twisting_friction": 1e12})


def chain(count, **changes):
    """Spheres in a row along x, in touch, that springs against twisting hold alone."""
    place = np.c_[PRESSED[:count], np.zeros((count, 2)) + RADIUS]
    return spheres(place, pair_contact=twisting(), wall_contact=twisting(0.0), **changes)


@pytest.mark.parametrize(("count", "factor"), [(1, 2.0), (2, 2.0), (3, 3.0)])
def test_the_bound_is_that_of_the_fastest_twisting(count, factor):
    """Two bodies twist against each other at the root of 2 k/I, three in a row at that of 3 k/I; velocity before place."""
    assert longest_step(chain(count)) == pytest.approx(2.0 / sqrt(factor * STIFFNESS / INERTIA), rel=1e-3)


def test_a_wall_twists_too():
    model = spheres([0.0, 0.0, RADIUS], pair_contact=twisting(0.0), wall_contact=twisting())
    assert longest_step(model) == pytest.approx(2.0 / sqrt(STIFFNESS / INERTIA), rel=1e-3)


@pytest.mark.long
@pytest.mark.parametrize(("share", "grows"), [(0.98, False), (1.02, True)])
def test_a_step_beyond_the_bound_lets_the_twisting_grow(share, grows):
    bound = 2.0 / sqrt(3.0 * STIFFNESS / INERTIA)
    model = chain(3, spin=[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], dt=share * bound, watched=False)
    engine = Engine(model)
    engine.step_to(300)
    spin = np.abs(rows(engine)[:, 6]).max()
    assert spin > 1e3 if grows else spin < 10.0
