"""Every law runs in the kernel: a small silo comes to rest, its ledger closes, its walls carry the weight."""

import numpy as np
import pytest

from silostudy.contact import LAWS, curve
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import TURNOVER, balance
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.walls import sums_by_wall
from silostudy.scene.plane_silo import FLOOR, SIDES

from .scenes import DAMPING, STIFFNESS, silo

CURVE = curve.curve(0.01, youngs_modulus=7.35e7, poissons_ratio=0.3)
KNOWN = {
    "normal_stiffness": STIFFNESS,
    "normal_damping": DAMPING,
    "normal_damping_root": 0.0,
    "line_compliance": CURVE[0],
    "line_bracket": CURVE[1],
    "tangential_stiffness": 0.25 * STIFFNESS,
    "tangential_damping": 0.5 * DAMPING,
    "tangential_damping_root": 0.0,
    "sliding_friction": 0.4,
    "rolling_stiffness": 5.0,
    "rolling_friction": 0.1,
    "pull": 0.5,
    "hertz_stiffness": 1e7,
    "hertz_damping": 1e3,
    "mindlin_stiffness": 2e7,
    "rolling_damping": 1e-4,
    "twisting_stiffness": 1e-3,
    "twisting_damping": 1e-7,
    "twisting_friction": 0.1,
    "cohesion_energy_density": 1e4,
    "work_of_adhesion": 0.05,
}
CHOICES = [Laws.of(normal=key, tangential="spring-slider") for key in LAWS["normal"]]
CHOICES += [Laws.of(tangential=key) for key in LAWS["tangential"] if key != "spring-slider"]
CHOICES += [Laws.of(tangential="spring-slider", rolling="spring-slider", cohesion="constant-pull")]
CHOICES += [Laws.of(tangential="spring-slider", rolling="spring-dashpot-slider")]


def contact(laws):
    return Contact.taking(laws, KNOWN)


@pytest.mark.long
@pytest.mark.parametrize("laws", CHOICES, ids=lambda laws: f"{laws.normal.key}, {laws.tangential.key}, {laws.rolling.key}")
def test_a_law_settles_and_its_ledger_closes(laws):
    model = silo(across=5, height=0.12, pair_contact=contact(laws), wall_contact=contact(laws), booked=True, dt=1e-5)
    engine = Engine(model)
    engine.step_to(1)
    start = balance(engine.ledger.account)
    engine.step_to(30000)
    account = engine.ledger.account
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]
    engine.clear_window()
    engine.step_to(40000)
    mean = engine.record.window[:, :, 0] / 10000
    walls = sums_by_wall(model, mean)
    carried = walls[FLOOR][0] + sum(walls[name][1] for name in SIDES)
    assert carried == pytest.approx(model.mass.sum() * 9.81, rel=2e-2)
    assert np.isfinite(engine.bodies.rows[: engine.n]).all()
