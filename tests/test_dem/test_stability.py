"""The stability bound: its corners bound everything between, no start is blind, undamped ways are seen."""

from dataclasses import replace

import numpy as np
import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.lanes import V
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.rest import Rest
from silostudy.dem.stability import Extremes, _bounded, chosen_step, longest_step
from silostudy.packing import PACKINGS

from .scenes import RADIUS, box, contact, free, silo


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("damped", [0.05, 0.3, 1.0])
def test_what_lies_between_the_corners_is_bounded_too(integrator, damped):
    """Every oscillator with less stiffness and damping, and no less damping for its stiffness, at the largest step."""
    extremes = Extremes(stiffness=1.0, incremental=0.3, damping=3.0 * damped, least_damped=damped)
    steps = np.geomspace(1e-3, 3.0, 600)
    step = max(dt for dt in steps if _bounded(integrator, extremes.corners, dt))
    assert 0.3 * damped < step < 2.0
    for k in np.geomspace(1e-5, 1.0, 25):
        for slid in np.linspace(0.0, min(0.3, k), 4):
            for damping in np.linspace(damped * k, 3.0 * damped, 9):
                assert _bounded(integrator, [(k - slid, slid, damping)], step), (k, slid, damping)


def test_the_same_bits_at_every_call():
    model = silo(across=14, height=0.3)
    assert len({longest_step(model) for _ in range(5)}) == 1


def test_discs_that_nothing_holds():
    """Free discs without friction have a motion that stretches nothing; a search that starts from it would find no other."""
    x, y = RADIUS * 1.999 * np.mgrid[:7, :7].reshape(2, -1)
    bare = contact(laws=Laws())
    lone = longest_step(free([0.0], [0.0], pair_contact=bare, wall_contact=bare))
    assert 0.3 * lone < longest_step(free(x, y, pair_contact=bare, wall_contact=bare)) < lone


def test_every_spring_counts():
    """A stiff wall, tangential spring, rolling spring: each shortens the step of discs that do not touch yet."""
    rolls = Laws.of(tangential="spring-slider", rolling="spring-slider")
    model = free([0.0, 0.1], [0.0, 0.0])
    plain = longest_step(model)
    assert longest_step(replace(model, wall_contact=contact(40.0))) < 0.5 * plain
    stiff = contact()
    stiff = Contact(stiff.laws, stiff.coefficients | {"tangential_stiffness": 40.0 * stiff.coefficients["normal_stiffness"]})
    assert longest_step(replace(model, pair_contact=stiff)) < 0.5 * plain
    rolling = contact(laws=rolls, rolling_stiffness=1e5, rolling_friction=0.1)
    assert longest_step(replace(model, pair_contact=rolling)) < 0.5 * plain


def test_smoothed_increments_need_damping():
    """Eqs. (17), (19) feed energy into what nothing damps: the bound follows the least damped contact to zero."""
    damped = [longest_step(free([0.0, 0.02], [0.0, 0.0], integrator="17-19",
                                pair_contact=contact(damping=d), wall_contact=contact(damping=d)))
              for d in (40.0, 4.0, 0.0)]  # fmt: skip
    assert damped[0] == pytest.approx(10.0 * damped[1], rel=1e-3)
    assert damped[2] < 0.05 * damped[1]  # what rounding leaves of zero


def test_implicit_dashpots_lengthen_the_step():
    implicit = Laws.of(normal="spring-dashpot-implicit", tangential="spring-slider-implicit")
    assert implicit.normal.implicit
    assert implicit.tangential.implicit
    explicit = longest_step(silo())
    assert (
        longest_step(silo(pair_contact=contact(laws=implicit), wall_contact=contact(2.0, 0.176, laws=implicit)))
        > 1.5 * explicit
    )


@pytest.mark.parametrize("spread", [0.0, 0.3])
def test_a_loose_packing_does_not_jitter_at_the_step_that_the_engine_chooses(spread):
    """Its start has no contacts and promises a longer step than the settled packing bears."""
    x, y, radius = PACKINGS["loose"].place(width=0.2, count=60, radius=0.01, spread=spread, seed=3)
    model = silo(x=x, y=y, radius=radius, walls=box(0.2, float(y.max()) + 0.1))
    model = replace(model, dt=chosen_step(model))
    engine = Engine(model)
    engine.step_to(round(2.0 / model.dt))
    assert np.abs(engine.column(V)).mean() < Rest().below * model.dt * 9.81  # a disc may still roll on top of the others
    places = engine.places
    settled = longest_step(replace(model, x=places[:, 0], y=places[:, 1]))
    assert model.dt < 0.9 * settled
    assert longest_step(model) > 1.2 * settled
