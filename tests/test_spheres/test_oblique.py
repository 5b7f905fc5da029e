"""Oblique elastic impacts on a plane against the curve of Maw, Barber & Fawcett (1976), computed ring by ring."""

from math import sqrt

import pytest

from silostudy.contact import elastic
from silostudy.dem.engine import Engine
from tests.test_spheres.maw import Foundation, rebound
from tests.test_spheres.scenes import MASS, MODULUS, POISSON, RADIUS, contact, rows, spheres

MODULI = (MODULUS, POISSON, MODULUS, POISSON)
E_STAR, G_STAR = elastic.contact_modulus(*MODULI), elastic.contact_shear_modulus(*MODULI)
FRICTION, DOWN = 0.3, 0.5
UNIT = FRICTION * DOWN  # m/s: speeds along the plane are shown in it
ROLLS = 7.0 * UNIT  # m/s that gross slip takes from the surface


def test_the_springs_are_those_of_hertz_and_mindlin():
    overlap = 1e-5
    foundation = Foundation(RADIUS, E_STAR, G_STAR, 1e9, 2.0 * sqrt(RADIUS * overlap))
    assert foundation.normal(overlap) == pytest.approx(4.0 / 3.0 * E_STAR * sqrt(RADIUS * overlap) * overlap, rel=1e-3)
    stiffness = -foundation.tangential(overlap, 1e-9) / 1e-9
    assert stiffness == pytest.approx(8.0 * G_STAR * sqrt(RADIUS * overlap), rel=1e-2)


def test_partial_slip_is_that_of_cattaneo():
    """Under a constant normal force N the surface moves by 3 mu N (1 - (1 - T/(mu N))^(2/3))/(16 G* a)."""
    overlap, friction = 1e-5, 0.3
    radius = sqrt(RADIUS * overlap)
    foundation = Foundation(RADIUS, E_STAR, G_STAR, friction, 1.5 * radius)
    limit = friction * foundation.normal(overlap)
    for share in (0.2, 0.5, 0.9):
        moved = 3.0 * limit * (1.0 - (1.0 - share) ** (2.0 / 3.0)) / (16.0 * G_STAR * radius)
        foundation.stretch[:] = 0.0
        assert -foundation.tangential(overlap, moved) == pytest.approx(share * limit, rel=1e-2)


@pytest.fixture(scope="module")
def bounced():
    """Speed of the surface after an impact over UNIT by that before, by the kernel and ring by ring."""

    def both(share):
        across = share * UNIT
        time = 2.87 * (MASS**2 / (RADIUS * E_STAR**2 * DOWN)) ** 0.2
        touch = contact(None, FRICTION)
        model = spheres([(0.0, 0.0, RADIUS)], [(across, 0.0, -DOWN)], wall_contact=touch, dt=time / 4000.0)
        engine = Engine(model)
        engine.step_to(6000)
        (row,) = rows(engine)
        assert row[5] == pytest.approx(DOWN, rel=2e-3)
        found = row[3] - row[7] * RADIUS
        return found / UNIT, rebound(RADIUS, MASS, E_STAR, G_STAR, FRICTION, across, DOWN) / UNIT

    return both


@pytest.mark.long
@pytest.mark.parametrize("share", [6.5, 8.0, 12.0])
def test_where_it_slips_throughout_both_are_exact(bounced, share):
    for found in bounced(share):
        assert found == pytest.approx(share - 7.0, abs=0.02)


@pytest.mark.long
@pytest.mark.parametrize("share", [0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0])
def test_where_it_sticks_for_a_while(bounced, share):
    """One spring for the whole contact stays within 0.7 of a curve that reaches down to -1.7: it never slips in part, and its
    force does not shrink with the contact."""
    found, exact = bounced(share)
    assert found == pytest.approx(exact, abs=0.7)
    if share >= 3.0:
        assert found == pytest.approx(exact, abs=0.36)
        assert found < -0.5  # the surface springs back
