"""A property of every scene: random discs in a box or in the open keep their books, their momentum, their distance.

Depth of overlap has a bound of its own: one contact's spring can hold no more than all the energy there is.
"""

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silostudy.contact import curve
from silostudy.contact.family import USUAL
from silostudy.dem.engine import Engine
from silostudy.dem.lanes import U, V
from silostudy.dem.ledger import CREATED, DASHPOT, ELASTIC, KINETIC, POTENTIAL, SLIDING, TURNOVER, balance
from silostudy.dem.model import Contact, Wall
from silostudy.dem.pieces import Laws
from silostudy.dem.stability import longest_step
from tests.test_dem.scenes import DENSITY, RADIUS, STIFFNESS, free

SIDE, ACROSS, LOOKS, STEPS = 3.0 * RADIUS, 4, 8, 1500
# of the energy at hand times the share of the stable step: what finite steps may add to it, and what they may hand to friction
RISE, MADE = 0.3, 4.0


MARCHES = [
    ("17-18", Laws.of(tangential="spring-slider")),
    ("17-19", Laws.of(tangential="spring-slider")),
    ("velocity-verlet", Laws.of(tangential="spring-slider")),
    ("17-18", Laws.of(normal="spring-dashpot-implicit", tangential="spring-slider-implicit")),
    ("17-19", Laws.of(normal="spring-dashpot-implicit", tangential="spring-slider-implicit")),
    ("17-18", Laws.of(tangential="spring-slider-total", rolling="spring-slider", cohesion="constant-pull")),
    ("velocity-verlet", Laws.of(normal="line-contact", tangential="viscous-coulomb")),
    ("17-18", Laws.of(normal="spring-dashpot-tension", tangential="spring-slider", cohesion="constant-pull")),
]
CURVE = curve.curve(RADIUS, youngs_modulus=7.35e7, poissons_ratio=0.3)


def contact_of(laws, damping, friction, rolling, pull) -> Contact:
    """One contact for discs and walls, with those of its coefficients that its laws take."""
    known = {
        "normal_stiffness": STIFFNESS, "normal_damping": damping, "normal_damping_root": 0.0,
        "line_compliance": CURVE[0], "line_bracket": CURVE[1],
        "tangential_stiffness": 0.25 * STIFFNESS, "tangential_damping": 0.5 * damping, "tangential_damping_root": 0.0,
        "sliding_friction": friction, "rolling_stiffness": 5.0, "rolling_friction": rolling, "pull": pull,
    }  # fmt: skip
    return Contact.taking(laws, known)


@st.composite
def scenes(draw, integrator, laws):
    """A model of two to a dozen discs of several sizes, at a share of its stable step; whether it stands in a box."""
    boxed = draw(st.booleans())
    n = draw(st.integers(2, 12))
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    least = 1.0 if laws.normal.one_size else draw(st.floats(0.15, 0.9))  # that curve is for discs of one size
    radius = RADIUS * random.uniform(least, 1.0, n)
    place = SIDE * (np.array(np.divmod(random.permutation(ACROSS**2)[:n], ACROSS)) + 0.5)
    x, y = place + random.uniform(-1.0, 1.0, (2, n)) * (0.49 * SIDE - radius)
    speed = draw(st.floats(0.0, 1.0))
    u, v = random.uniform(-speed, speed, (2, n))
    w = random.uniform(-1.0, 1.0, n) * speed / RADIUS
    damping = draw(st.floats(0.0, 1.5)) * 2.0 * sqrt(DENSITY * pi * radius.min() ** 2 * STIFFNESS)
    friction = draw(st.sampled_from([0.0, 0.2, 0.577, 5.0]))
    pull = draw(st.floats(0.0, 100.0)) if laws.cohesion.acts else 0.0
    touch = contact_of(laws, damping, friction, draw(st.sampled_from([0.0, 0.1, 1.0])), pull)
    size = SIDE * ACROSS
    corners = [(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)]
    walls = [Wall(str(k), corners[k], corners[(k + 1) % 4], joined=(True, True)) for k in range(4)]
    model = free(
        x, y, u=u, v=v, w=w, radius=radius, booked=True, dt=1.0, gravity=(0.0, -9.81 if boxed else 0.0),
        walls=tuple(walls) if boxed else (Wall("far", (-1e3, -1e3), (1e3, -1e3)),),
        pair_contact=touch, wall_contact=touch, integrator=integrator,
    )  # fmt: skip
    return model, draw(st.floats(0.02, 0.25)), boxed


def deepest(engine) -> float:
    """Largest overlap (m) of two discs, or of a disc and the box."""
    place, radius = engine.bodies.rows[: engine.n, :2], engine.radius
    apart = np.hypot(*(place[:, None] - place[None]).transpose(2, 0, 1)) - radius[:, None] - radius
    np.fill_diagonal(apart, np.inf)
    return float(-apart.min())


@pytest.mark.parametrize(
    ("integrator", "laws"),
    [pytest.param(*march, marks=() if march == MARCHES[0] else pytest.mark.long) for march in MARCHES],
    ids=[f"{key}, {laws.normal.key}, {laws.tangential.key}" for key, laws in MARCHES],
)
@settings(max_examples=25, deadline=None)
@given(data=st.data())
def test_random_scenes_keep_books_momentum_and_distance(integrator, laws, data):
    model, share, boxed = data.draw(scenes(integrator, laws))
    engine = Engine(replace(model, dt=share * longest_step(model)))
    engine.step_to(1)
    account = engine.ledger.account
    start, before = balance(account), account.copy()
    mass = engine.mass
    momentum = mass @ engine.bodies.rows[: engine.n, [U, V]]
    swing = mass @ np.abs(engine.bodies.rows[: engine.n, [U, V]]) + 1e-9 * mass.sum()
    at_hand = before[[KINETIC, ELASTIC]].sum() + (mass.sum() * 9.81 * SIDE * ACROSS if boxed else 0.0)
    pull, springs = model.pair_contact.coefficients.get("pull", 0.0), model.pair_contact.ordered[0]
    at_hand += 3 * len(mass) * pull**2 / (2.0 * STIFFNESS)  # what so many contacts give where they draw discs together
    # a cap on the sum of spring and dashpot stretches the spring against the dashpot: what it holds is no part of the whole
    lost, whole = 0.0, laws.tangential.key == "spring-slider-total"
    for _ in range(LOOKS):
        engine.step_to(engine.step + STEPS)
        account = engine.ledger.account
        assert np.isfinite(engine.bodies.rows[: engine.n]).all()
        assert abs(balance(account) - start) <= 1e-9 * (account[TURNOVER] + at_hand)
        held = [KINETIC, POTENTIAL] if whole else [KINETIC, POTENTIAL, ELASTIC]
        assert account[held].sum() - before[held].sum() <= RISE * share * at_hand
        if not whole:
            assert account[SLIDING] >= lost * (1.0 - 1e-9)
            assert account[DASHPOT] >= -1e-3 * account[TURNOVER]
            assert abs(account[CREATED]) <= MADE * share * at_hand
        lost = account[SLIDING]
        overlap = max(deepest(engine), 0.0)
        held_by_one = laws.normal.energy(overlap, USUAL, springs) - pull * overlap
        assert held_by_one <= (1.0 + MADE * share) * at_hand * (1.0 + 1e-9)
        if not boxed:
            assert np.abs(mass @ engine.bodies.rows[: engine.n, [U, V]] - momentum).max() <= 1e-12 * swing.max()
