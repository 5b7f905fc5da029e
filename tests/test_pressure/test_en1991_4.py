"""EN 1991-4: characteristic sets, power law and hopper in 50-digit arithmetic, patches."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from silostudy.pressure import PRESSURE, hopper_shape
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import cylinder, hopper, patch
from silostudy.pressure.en1991_4.characteristic import characteristic
from silostudy.tables.solids import SOLIDS
from tests.test_pressure.bins import BIN
from tests.test_pressure.slender import PROPERTIES, SLENDER, value


def exact_power_law(z, gamma, radius, mu, k, contact, repose):
    z, gamma, radius, mu, k, contact = map(mpmath.mpf, (z, gamma, radius, mu, k, contact))
    z_o = radius / (k * mu)
    n = -(1 + mpmath.tan(repose)) * (1 - contact / z_o)
    p_h = gamma * radius / mu * (1 - ((z - contact) / (z_o - contact) + 1) ** n)
    stretched = (z + z_o - 2 * contact) ** (n + 1) / (z_o - contact) ** n
    return p_h, gamma * (contact - (z_o - contact - stretched) / (n + 1))


@settings(max_examples=150, deadline=None)
@given(
    depth=st.floats(-6, 1).map(lambda e: 10**e), mu=st.floats(-9, 0).map(lambda e: 10**e), k=st.floats(0.05, 1.5),
    repose=st.floats(0.01, 1.0), contact=st.floats(0.0, 1.0),
)  # fmt: skip
def test_power_law_in_fifty_digits(depth, mu, k, repose, contact):
    given_ = {"unit_weight": 8e3, "hydraulic_radius": 1.25, "mu": mu, "k": k, "contact": contact, "repose_angle": repose}
    z = contact + depth
    found = cylinder.power_law(np.float64(z), **given_)
    if k * mu * contact >= 1.25:
        assert np.isnan(found[0])
        return
    with mpmath.workdps(60):
        exact = exact_power_law(mpmath.mpf(z), 8e3, 1.25, mu, k, contact, repose)
    left = 1.25 / (1.25 - k * mu * contact)
    relative = 3e-14 * (left + z / depth)  # z - h_o and R - K mu h_o themselves are rounded
    assert float(found[0]) == pytest.approx(float(exact[0]), rel=relative, abs=0)
    assert float(found[1]) == pytest.approx(float(exact[1]), rel=3e-14 * left, abs=0)


@pytest.mark.parametrize("step", [0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4, 0.3, -0.3])
def test_power_law_on_both_sides_of_minus_one(step):
    """n = -1 where (1 + tan phi_r)(1 - h_o/z_o) = 1."""
    repose, mu, k = 0.5, 0.4, 0.5
    share = 1 / (1 + np.tan(repose)) * (1 + step)  # 1 - h_o/z_o
    contact = (1 - share) * 1.25 / (k * mu)
    found = cylinder.power_law(np.float64(9.0), unit_weight=8e3, hydraulic_radius=1.25, mu=mu, k=k, contact=contact,
                               repose_angle=repose)  # fmt: skip
    with mpmath.workdps(60):
        z_o = mpmath.mpf(1.25) / (mpmath.mpf(k) * mpmath.mpf(mu))
        if abs(-(1 + mpmath.tan(repose)) * (1 - mpmath.mpf(contact) / z_o) + 1) < mpmath.mpf(10) ** -40:
            pytest.skip("exactly -1")
        exact = exact_power_law(9.0, 8e3, 1.25, mu, k, contact, repose)
    assert float(found[0]) == pytest.approx(float(exact[0]), rel=1e-14, abs=0)
    assert float(found[1]) == pytest.approx(float(exact[1]), rel=1e-14, abs=0)


@pytest.mark.parametrize("offset", [0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-9, -1e-9, 1e-5, -1e-5, 0.01, -0.01, 0.7, -0.7, 5.0])
@pytest.mark.parametrize("share", [1e-9, 1e-3, 0.3, 0.999999, 1.0])
def test_hopper_on_both_sides_of_n_equal_one(offset, share):
    n = 1 + offset
    found = float(hopper.vertical_pressure(np.float64(share), weight=8e4, exponent=n, top=5e4))
    with mpmath.workdps(60):
        x, e = mpmath.mpf(share), mpmath.mpf(n)
        own = -x * mpmath.log(x) if e == 1 else (x - x**e) / (e - 1)
        exact = 80000 * own + 50000 * x**e
    assert found == pytest.approx(float(exact), rel=4e-15, abs=0)


@settings(max_examples=150, deadline=None)
@given(n=st.floats(-0.9, 20), log=st.floats(-12, 0), top=st.floats(0, 1e6))
def test_hopper_in_fifty_digits(n, log, top):
    share = 10**log
    found = float(hopper.vertical_pressure(np.float64(share), weight=8e4, exponent=n, top=top))
    with mpmath.workdps(80):
        x, e = mpmath.mpf(share), mpmath.mpf(n)
        own = -x * mpmath.log(x) if e == 1 else (x - x**e) / (e - 1)
        exact = 80000 * own + mpmath.mpf(top) * x**e
    assert found == pytest.approx(float(exact), rel=2e-13, abs=1e-290)


def test_characteristic_sets():
    scene = {name: BIN[name] for name in PROPERTIES}
    mu, k, phi = characteristic("wall_normal", **scene)
    assert (mu, k, phi) == pytest.approx((0.3 / 1.15, 0.5 * 1.1, BIN["internal_friction_angle"] / 1.1))
    mu, k, phi = characteristic("vertical_load", **scene)
    assert (mu, k, phi) == pytest.approx((0.3 / 1.15, 0.5 / 1.1, BIN["internal_friction_angle"] * 1.1))
    mu, *_ = characteristic("wall_friction", **(scene | {"wall_friction": 0.7}))
    assert mu == pytest.approx(np.tan(BIN["internal_friction_angle"] / 1.1))  # never above tan(phi) of the same set


def test_design_takes_the_unfavourable_set_for_each_quantity():
    for quantity, name in (("wall_normal_pressure", "wall_normal"), ("wall_friction_traction", "wall_friction"),
                           ("axial_wall_force", "wall_friction"), ("vertical_pressure", "vertical_load")):  # fmt: skip
        each = {
            key: value(quantity, method=f"en1991_4_{key}") for key in ("mean", "wall_normal", "wall_friction", "vertical_load")
        }
        assert value(quantity) == each[name] == max(each.values())


@pytest.mark.parametrize(
    ("slenderness", "normal", "friction"),
    [(3.0, 1.15, 1.10), (2.0, 1.15, 1.10), (1.5, 1.075, 1.05), (1.0, 1.0, 1.0), (0.5, 1.0, 1.0)],
)
def test_discharge_factors_by_class(slenderness, normal, friction):
    depth = slenderness * 5
    scene = {"cylinder_depth": depth, "z": 0.9 * depth}
    assert value("wall_normal_pressure", "discharge", **scene) / value("wall_normal_pressure", **scene) == pytest.approx(normal)
    assert value("axial_wall_force", "discharge", **scene) / value("axial_wall_force", **scene) == pytest.approx(friction)


def test_places_above_the_heap_are_masked():
    assert np.isnan(value("wall_normal_pressure", cylinder_depth=6.0, contact_depth=0.5, z=0.49))
    assert value("wall_normal_pressure", cylinder_depth=6.0, contact_depth=0.5, z=0.51) > 0


@pytest.mark.parametrize("depth", [3.0, 4.5, 7.0, 9.9])
@pytest.mark.parametrize("contact", [0.0, 0.55])
def test_squat_friction_adds_up_to_the_axial_force(depth, contact):
    scene = {"cylinder_depth": depth, "contact_depth": contact}
    integral = quad(lambda z: value("wall_friction_traction", **scene, z=z), contact, depth, epsrel=1e-11)[0]
    assert value("axial_wall_force", **scene, z=depth) == pytest.approx(integral, rel=1e-9, abs=0)


def test_patch_loads():
    given_ = {"patch_factor": 0.5, "eccentricity": 0.5, "diameter": 5.0}
    exponential = 1 - np.exp(-1.5 * (2.4 - 1))
    expected = 0.21 * 0.5 * (1 + 2 * 0.2**2) * exponential
    assert patch.patch_factor_filling(**given_, cylinder_depth=12.0) == pytest.approx(expected)
    assert patch.patch_factor_discharge(**given_, cylinder_depth=12.0) == pytest.approx(2 * expected)
    assert patch.patch_factor_discharge(**given_, cylinder_depth=5.5) == pytest.approx(0.272 * 0.5 * (0.1 + 0.2))
    assert patch.patch_factor_filling(**given_, cylinder_depth=3.0) == 0.0
    totals = PRESSURE["en1991_4"].totals["filling"]
    depth = float(call(totals["patch_depth"], None, SLENDER))
    mu, k, _ = characteristic("wall_normal", **{name: SLENDER[name] for name in PROPERTIES})
    assert 1.25 / (k * mu) > depth == pytest.approx(6.0)  # half the wall's height
    rough = SLENDER | {"wall_friction": 0.6}
    mu = characteristic("wall_normal", **{name: rough[name] for name in PROPERTIES})[0]
    assert 6.0 > float(call(totals["patch_depth"], None, rough)) == pytest.approx(1.25 / (k * mu))
    pressure = float(call(totals["patch_pressure"], None, SLENDER))
    assert pressure == pytest.approx(expected * value("wall_normal_pressure", z=depth))
    angles = np.linspace(0, 2 * np.pi, 20001)  # p_p cos(theta) over the patch's height, summed towards its side
    s = np.pi * 5 / 16
    push = np.trapezoid(pressure * np.cos(angles) ** 2, angles) * 2.5 * s
    assert float(call(totals["patch_resultant"], None, SLENDER)) == pytest.approx(push, rel=1e-9)


def test_hopper_ratios():
    mu, beta, phi = 0.3, np.radians(20), np.radians(35)
    assert hopper.filling_ratio(beta, mu) == pytest.approx(1 - 0.2 / (1 + np.tan(beta) / mu))
    assert hopper.filling_ratio(beta, 0.0) == 1.0
    smooth = (1 + np.sin(phi)) / (1 - np.sin(phi) * np.cos(2 * beta))
    assert hopper.discharge_ratio(beta, 0.0, phi) == pytest.approx(smooth)
    assert not hopper.is_steep(np.radians(60), mu, 0.5)
    assert hopper.effective_friction(np.radians(60), mu, 0.5) == pytest.approx(0.5 / (2 * np.tan(np.radians(60))))


@pytest.mark.parametrize("quantity", ["normal_pressure", "friction_traction", "vertical_pressure"])
def test_shallow_hoppers_discharge_as_they_fill(quantity):
    """Where tan(beta) reaches (1 - K)/(2 mu) with the lower K and lower mu, in filling and discharge, and in no steeper one."""
    row, x = PRESSURE["en1991_4"].hopper, np.array([0.3, 1.0])
    k, mu = SLENDER["lateral_pressure_ratio"] / SLENDER["a_K"], SLENDER["hopper_wall_friction"] / SLENDER["a_mu"]
    limit = np.arctan((1 - k) / (2 * mu))
    for share, same in ((0.999, False), (1.001, True), (1.3, True)):
        scene = SLENDER | {"hopper_half_angle": share * limit}
        filling, discharge = (call(row[phase][f"hopper_{quantity}"], x, scene) for phase in ("filling", "discharge"))
        assert np.isfinite(discharge).all()
        assert np.array_equal(filling, discharge) == same


def test_hopper_pressure_starts_from_the_largest_vertical_load():
    top = hopper_shape.apex_height(5.0, SLENDER["hopper_half_angle"])
    p_v = call(PRESSURE["en1991_4"].hopper["filling"]["hopper_vertical_pressure"], np.array([top]), SLENDER)
    assert float(p_v[0]) == pytest.approx(value("vertical_pressure", z=12.0), rel=1e-12)


def test_table_e1():
    wheat = SOLIDS["wheat_e1"]
    assert (wheat.unit_weight_lower, wheat.unit_weight) == (7500, 9000)
    assert (wheat.a_phi, wheat.lateral_pressure_ratio, wheat.a_K, wheat.a_mu) == (1.12, 0.54, 1.11, 1.16)
    assert (wheat.d1, wheat.d2, wheat.d3, wheat.patch_factor) == (0.24, 0.38, 0.57, 0.5)
    assert len([row for row in SOLIDS.values() if row.source == "en1991_4_2006"]) == 25
