"""EN 1991-4, large eccentric discharge: the channel by geometry, the zones in equilibrium round the ring."""

import numpy as np
import pytest
from scipy.integrate import quad

from silostudy.errors import BadInput
from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import eccentric
from silostudy.pressure.family import CHANNEL_SIZES
from tests.test_pressure.slender import SLENDER, value

ECCENTRIC = [key for key, row in PRESSURE.items() if row.channel]


def round_the_ring(method, size, z, scene=SLENDER):
    """(angles, pressures) round the wall at depth z (m), the zones of wall put together from what the method gives."""
    channel = PRESSURE[method].channel["discharge"]
    here = scene | {"channel_size": size}
    p_c, p_s, p_a = (
        float(call(channel[f"{zone}_normal_pressure"], np.float64(z), here)) for zone in ("channel", "static", "adjacent")
    )
    theta = float(call(channel["channel_half_width"], None, here))
    angles = np.linspace(-np.pi, np.pi, 400_001)
    return angles, np.select([abs(angles) < theta, abs(angles) < 2 * theta], [p_c, p_a], p_s), p_s


@pytest.mark.parametrize("size", CHANNEL_SIZES)
def test_eccentric_channel_by_geometry(size):
    """Area and contact lengths of the channel against counting points and against the two circles' crossing."""
    radius, mu, phi = 2.5, 0.3, np.radians(35)
    theta, psi, offset = eccentric.channel(radius, size, mu, phi)
    crossing = radius * np.array([np.cos(theta), np.sin(theta)])
    assert np.hypot(crossing[0] - offset, crossing[1]) == pytest.approx(size * radius, rel=1e-9)
    side = np.linspace(-radius, radius, 1501)
    x, y = np.meshgrid(side, side)
    inside = (np.hypot(x, y) <= radius) & (np.hypot(x - offset, y) <= size * radius)
    counted = inside.sum() * (side[1] - side[0]) ** 2
    inner = size * radius
    area = (np.pi - psi) * inner**2 + theta * radius**2 - radius * inner * np.sin(psi - theta)
    assert area == pytest.approx(counted, rel=2e-3)
    k, z = 0.5, 9.0
    z_oc = area / (k * (2 * theta * radius * mu + 2 * inner * (np.pi - psi) * np.tan(phi)))
    expected = 8e3 * k * z_oc * (1 - np.exp(-z / z_oc))
    found = eccentric.channel_pressure(z, unit_weight=8e3, radius=radius, size=size, mu=mu, k=k, phi=phi)
    assert float(found) == pytest.approx(expected, rel=1e-12)


def test_no_real_channel_is_an_error():
    with pytest.raises(BadInput, match="no real flow channel"):
        eccentric.channel(2.5, 0.25, 0.9, np.radians(30))


def test_eccentric_discharge_adds_to_the_resting_pressure():
    edge = call(PRESSURE["en1991_4_eccentric"].phases["discharge"]["wall_normal_pressure"], 9.0, SLENDER)
    static = value("wall_normal_pressure", z=9.0)
    assert static < edge < 2 * static


@pytest.mark.parametrize("method", ECCENTRIC)
@pytest.mark.parametrize("size", CHANNEL_SIZES)
def test_zones_of_a_channel_in_equilibrium_round_the_ring(method, size):
    """The mean round the ring is the static pressure; what is left is the horizontal resultant that the method gives."""
    angles, pressure, static = round_the_ring(method, size, 9.0)
    assert np.trapezoid(pressure, angles) / (2 * np.pi) == pytest.approx(static, rel=1e-4)
    push = -np.trapezoid(pressure * np.cos(angles), angles) * 2.5
    found = call(PRESSURE[method].channel["discharge"]["channel_resultant"], np.float64(9.0), SLENDER | {"channel_size": size})
    assert float(found) == pytest.approx(push, rel=1e-3)
    assert push > 0


@pytest.mark.parametrize("method", ECCENTRIC)
@pytest.mark.parametrize(("depth", "contact"), [(12.0, 0.0), (6.0, 0.5)])
def test_shear_and_moment_of_a_channel_are_the_integrals_of_its_resultant(method, depth, contact):
    channel = PRESSURE[method].channel["discharge"]
    scene = SLENDER | {"channel_size": 0.4, "cylinder_depth": depth, "contact_depth": contact}
    level = lambda z: float(call(channel["channel_resultant"], np.float64(z), scene))  # noqa: E731
    shear, moment = (float(call(channel[f"channel_{name}"], None, scene).squeeze()) for name in ("shear", "moment"))
    assert shear == pytest.approx(quad(level, contact, depth)[0], rel=1e-8)
    assert moment == pytest.approx(quad(lambda z: level(z) * (depth - z), contact, depth)[0], rel=1e-8)


def test_the_friction_set_has_the_larger_axial_force_and_the_normal_set_the_larger_pressure():
    normal, friction = (
        {
            name: float(call(PRESSURE[method].channel["discharge"][name], np.float64(11.0), SLENDER | {"channel_size": 0.6}))
            for name in ("static_normal_pressure", "static_friction_traction")
        }
        for method in ("en1991_4_eccentric", "en1991_4_eccentric_friction")
    )
    assert normal["static_normal_pressure"] > friction["static_normal_pressure"]
    assert normal["static_friction_traction"] < friction["static_friction_traction"]
