"""EN 1998-4's pressure and its integral, the demand on the wall, and the family of rules."""

import numpy as np
import pytest

from silostudy.errors import BadInput
from silostudy.seismic.beam import modes
from silostudy.seismic.demand import demand
from silostudy.seismic.en1998_4 import contents_share, wall_pressure
from silostudy.seismic.records import Record
from silostudy.seismic.rules import MASS_RULES
from silostudy.tables.references import cite
from tests.test_seismic.test_beam import MODEL


@pytest.mark.parametrize("slenderness", [0.1, 0.3, 0.5, 0.8, 2.0, 6.0])
def test_share_is_the_integral_of_the_pressure(slenderness):
    diameter = 5.0
    height, weight, acceleration = slenderness * diameter, 8000.0, 2.0
    x = (np.arange(20000) + 0.5) / 20000 * height
    angle = np.linspace(0, 2 * np.pi, 181)[:-1]
    pressure = wall_pressure(x[:, None], acceleration=acceleration, unit_weight=weight, contents_height=height,
                             diameter=diameter, angle=angle)  # fmt: skip
    force = (pressure * np.cos(angle)).mean() * height * np.pi * diameter
    mass = weight / 9.80665 * np.pi * diameter**2 / 4 * height
    assert contents_share(slenderness) == pytest.approx(force / (mass * acceleration), rel=1e-4)


def test_slender_silos_pass_eighty_percent():
    assert contents_share(3.0) > MASS_RULES["eighty_percent"].function(3.0)
    assert contents_share(0.3) < 0.8
    assert contents_share(0.5 - 1e-9) == pytest.approx(contents_share(0.5 + 1e-9), rel=1e-6)


def test_pressure_on_the_wall():
    given = {"acceleration": 9.80665, "unit_weight": 8000.0, "contents_height": 20.0, "diameter": 6.0}
    assert wall_pressure(np.array([0.0, 0.5, 1.0, 10.0]), **given) == pytest.approx([0, 12000, 24000, 24000])
    assert wall_pressure(5.0, **given, angle=np.pi) == pytest.approx(-24000)


def test_demand_of_a_slow_push_is_static():
    """A base acceleration that rises slowly: shear = mass x acceleration, moment = shear x half the height."""
    t = np.linspace(0, 20, 4001)
    base = Record(1.5 * np.sin(np.pi * t / 40) ** 2, t[1], "slow push")
    found = demand(MODEL, 0.026, 0.8, 0.05, base, np.array([0.0, MODEL.height, 0.05]))
    mass = MODEL.height * (2350 * 2 * np.pi * 0.25 * 0.015 + 0.8 * 790 * np.pi * 0.2425**2)
    assert found.shear_force[0] == pytest.approx(1.5 * mass, rel=1e-3)
    assert found.bending_moment[0] == pytest.approx(1.5 * mass * MODEL.height / 2, rel=1e-3)
    assert found.axial_wall_force[0] == pytest.approx(found.bending_moment[0] / (np.pi * 0.25**2), rel=1e-12)
    assert found.shear_force[1] < 1e-3 * found.shear_force[0]
    assert found.top_peak == pytest.approx(1.5, rel=1e-3)
    assert found.wall_pressure[0] == 0  # three times no height above the bottom
    reach = np.array([0.0, 0.2425, 0.15])  # the inner radius at the top, three times the height near the bottom
    assert found.wall_pressure == pytest.approx(found.acceleration * 790.0 * reach, rel=1e-12)


def test_true_peak_is_above_the_sampled_one():
    t = 0.01 * np.arange(400)
    frequency = modes(MODEL, 0.8, 0.026).frequency[0]
    found = demand(MODEL, 0.026, 0.8, 0.05, Record(np.sin(2 * np.pi * frequency * t), 0.01, "sine"), np.array([0.0]))
    assert found.top_peak > 1.0005 * found.top_peak_sampled


def test_rules_are_complete():
    for row in MASS_RULES.values():
        assert cite(row.source)
        assert "(1)" in (row.function.__doc__ or "").split("\n")[0]
        assert row.formula
        assert row.validity
    with pytest.raises(BadInput, match="known: resonance_shift"):
        MASS_RULES["ninety_percent"]
