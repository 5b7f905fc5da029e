"""A property of every scene: random discs in a box or in the open keep their books, their momentum, their distance.

Depth of overlap has a bound of its own: one contact's spring can hold no more than all the energy there is.
"""

from dataclasses import replace
from math import pi, sqrt

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from silostudy.dem.engine import Engine
from silostudy.dem.lanes import U, V
from silostudy.dem.ledger import CREATED, DASHPOT, ELASTIC, KINETIC, POTENTIAL, SLIDING, TURNOVER, balance
from silostudy.dem.model import Wall
from silostudy.dem.stability import longest_step
from tests.test_dem.scenes import DENSITY, RADIUS, STIFFNESS, contact, free

SIDE, ACROSS, LOOKS, STEPS = 3.0 * RADIUS, 4, 8, 1500
# of the energy at hand times the share of the stable step: what finite steps may add to it, and what they may hand to friction
RISE, MADE = 0.3, 4.0


@st.composite
def scenes(draw, boxed=None):
    """A model of two to a dozen discs of several sizes, at a share of its stable step; whether it stands in a box."""
    boxed = draw(st.booleans()) if boxed is None else boxed
    n = draw(st.integers(2, 12))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    radius = RADIUS * random.uniform(draw(st.floats(0.15, 0.9)), 1.0, n)
    place = SIDE * (np.array(np.divmod(random.permutation(ACROSS**2)[:n], ACROSS)) + 0.5)
    x, y = place + random.uniform(-1.0, 1.0, (2, n)) * (0.49 * SIDE - radius)
    speed = draw(st.floats(0.0, 1.0))
    u, v = random.uniform(-speed, speed, (2, n))
    w = random.uniform(-1.0, 1.0, n) * speed / RADIUS
    damping = draw(st.floats(0.0, 1.5)) * 2.0 * sqrt(DENSITY * pi * radius.min() ** 2 * STIFFNESS)
    friction = draw(st.sampled_from([0.0, 0.2, 0.577, 5.0]))
    size = SIDE * ACROSS
    corners = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]
    walls = [Wall(str(k), corners[k], corners[(k + 1) % 4], joined=(True, True)) for k in range(4)]
    model = free(
        x, y, u=u, v=v, w=w, radius=radius, booked=True, dt=1.0, gravity=(0.0, -9.81 if boxed else 0.0),
        walls=tuple(walls) if boxed else (Wall("far", (-1e3, -1e3), (1e3, -1e3)),),
        pair=contact(1.0, friction, damping), wall=contact(1.0, friction, damping),
    )  # fmt: skip
    return model, draw(st.floats(0.02, 0.25)), boxed


def deepest(engine) -> float:
    """Largest overlap (m) of two discs, or of a disc and the box."""
    place, radius = engine.discs.rows[: engine.n, :2], engine.radius
    apart = np.hypot(*(place[:, None] - place[None]).transpose(2, 0, 1)) - radius[:, None] - radius
    np.fill_diagonal(apart, np.inf)
    return float(-apart.min())


@settings(max_examples=120, deadline=None)
@given(scene=scenes())
def test_random_scenes_keep_books_momentum_and_distance(scene):
    model, share, boxed = scene
    engine = Engine(replace(model, dt=share * longest_step(model)))
    engine.step_to(1)
    account = engine.ledger.account
    start, before = balance(account), account.copy()
    mass = engine.mass
    momentum = mass @ engine.discs.rows[: engine.n, [U, V]]
    swing = mass @ np.abs(engine.discs.rows[: engine.n, [U, V]]) + 1e-9 * mass.sum()
    at_hand = before[[KINETIC, ELASTIC]].sum() + (mass.sum() * 9.81 * SIDE * ACROSS if boxed else 0.0)
    lost = 0.0
    for _ in range(LOOKS):
        engine.step_to(engine.step + STEPS)
        account = engine.ledger.account
        assert np.isfinite(engine.discs.rows[: engine.n]).all()
        assert abs(balance(account) - start) <= 1e-9 * (account[TURNOVER] + at_hand)
        assert account[SLIDING] >= lost * (1.0 - 1e-9)
        lost = account[SLIDING]
        assert account[DASHPOT] >= -1e-3 * account[TURNOVER]
        held = account[[KINETIC, POTENTIAL, ELASTIC]].sum() - before[[KINETIC, POTENTIAL, ELASTIC]].sum()
        assert held <= RISE * share * at_hand
        assert abs(account[CREATED]) <= MADE * share * at_hand
        assert deepest(engine) <= sqrt(2.0 * (1.0 + MADE * share) * at_hand / STIFFNESS) * (1.0 + 1e-9)
        if not boxed:
            assert np.abs(mass @ engine.discs.rows[: engine.n, [U, V]] - momentum).max() <= 1e-12 * swing.max()
