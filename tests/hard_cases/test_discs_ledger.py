"""Hard cases of discrete elements whose energy is booked: what must balance, whatever happens."""

import numpy as np
import pytest

from silostudy.dem import ledger
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import TURNOVER, balance
from tests.test_dem.scenes import RADIUS, contact, free


def test_ledger_of_a_violent_mixture():
    """Discs of ratio 1:20 thrown at each other: the ledger closes and no momentum is made."""
    random = np.random.default_rng(5)
    x, y = 0.03 * (np.mgrid[:5, :5].reshape(2, -1) + random.uniform(-0.1, 0.1, (2, 25)))
    radius = np.geomspace(5e-4, 0.01, 25)
    u, v = random.uniform(-2.0, 2.0, (2, 25))
    engine = Engine(free(x, y, radius=radius, u=u, v=v, dt=5e-7, booked=True))
    engine.step_to(1)
    start = balance(engine.ledger.account)
    momentum = engine.mass @ engine.bodies.rows[: engine.n, 2]
    engine.step_to(60000)
    account = engine.ledger.account
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]
    assert engine.mass @ engine.bodies.rows[: engine.n, 2] == pytest.approx(
        momentum, abs=1e-12 * float(engine.mass @ np.abs(u))
    )


def test_ledger_without_friction_and_for_any_list():
    """Where nothing rubs nothing is lost by rubbing, and pairs that are only listed as near are not booked."""
    random = np.random.default_rng(6)
    x, y = 2.2 * RADIUS * (np.mgrid[:6, :6].reshape(2, -1) + random.uniform(-0.04, 0.04, (2, 36)))
    u, v = random.uniform(-0.5, 0.5, (2, 36))
    radius = RADIUS * random.uniform(0.9, 1.0, 36)
    accounts = []
    for friction in (0.0, 0.3):
        for skin in (0.0, 0.01):
            law = contact(1.0, friction, damping=100.0)
            engine = Engine(free(x, y, u=u, v=v, radius=radius, dt=5e-6, pair_contact=law, booked=True), skin=skin)
            engine.step_to(8000)
            accounts.append(engine.ledger.account.copy())
    assert np.array_equal(accounts[0], accounts[1])
    assert np.array_equal(accounts[2], accounts[3])
    assert accounts[0][ledger.SLIDING] == 0.0
    assert accounts[2][ledger.SLIDING] > 0.1 * accounts[2][ledger.DASHPOT] > 0.0
