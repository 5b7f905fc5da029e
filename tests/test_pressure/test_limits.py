"""Limits that must hold to rounding: against closed limits and against the formulas in 50-digit arithmetic."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silostudy.pressure import PRESSURE, janssen
from silostudy.pressure.calls import call
from silostudy.pressure.jenike_mass_flow import envelope_pressure
from silostudy.pressure.saturation import saturation, saturation_deficit

mpmath.mp.dps = 50
WHEAT = {
    "unit_weight": 7845.32,
    "internal_friction_angle": np.radians(30),
    "wall_friction": 0.44,
    "lateral_pressure_ratio": 0.45,
    "poisson_ratio": 0.4,
    "hydraulic_radius": 1.25,
    "diameter": 5.0,
    "cylinder_depth": 18.0,
    "outlet_depth": 20.5,
    "top_cone_height": 0.0,
    "powder": 0.0,
    "i_phi": 0.584,
    "slot": 0.0,
}
EXACT = 4e-15  # a few units in the last place
CLOSED = [("janssen", "filling"), ("reimbert", "filling"), ("caquot", "filling"), ("caquot", "discharge")]


def pressure(method, phase, z, **changed):
    return call(PRESSURE[method].phases[phase]["wall_normal_pressure"], np.asarray(z, float), {**WHEAT, **changed})


@pytest.mark.parametrize("x", [0.0, 1e-300, 1e-12, 1e-3, 0.3, 0.999999, 1.0, 1.000001, 7.0, 40.0, 800.0, 1e12])
def test_saturation_in_fifty_digits(x):
    with mpmath.workdps(700):  # enough digits for the plain form, which cancels twice
        exact = (1 - mpmath.exp(-mpmath.mpf(x))) / x if x else mpmath.mpf(1)
        deficit = (1 - exact) / x if x else mpmath.mpf(1) / 2
    assert float(saturation(x)) == pytest.approx(float(exact), rel=EXACT, abs=0)
    assert float(saturation_deficit(x)) == pytest.approx(float(deficit), rel=EXACT, abs=0)


@pytest.mark.parametrize("mu", [0.0, 1e-300, 1e-18, 1e-17])
def test_no_wall_friction_is_hydrostatic(mu):
    z = np.array([1e-9, 1.0, 18.0, 1e5])
    k = WHEAT["lateral_pressure_ratio"]
    hydrostatic = k * WHEAT["unit_weight"] * z
    assert pressure("janssen", "filling", z[:3], wall_friction=mu) == pytest.approx(hydrostatic[:3], rel=EXACT, abs=0)
    rankine = (1 - np.sin(WHEAT["internal_friction_angle"])) / (1 + np.sin(WHEAT["internal_friction_angle"]))
    twice = 2 * rankine * WHEAT["unit_weight"] * z[:3]  # Reimbert's initial slope is twice the active one
    assert pressure("reimbert", "filling", z[:3], wall_friction=mu) == pytest.approx(twice, rel=2 * EXACT, abs=0)
    for phase, ratio in (("filling", rankine), ("discharge", 1 / rankine)):
        expected = ratio * WHEAT["unit_weight"] * z[:3]
        assert pressure("caquot", phase, z[:3], wall_friction=mu) == pytest.approx(expected, rel=2 * EXACT, abs=0)


@pytest.mark.parametrize(("method", "phase"), CLOSED)
def test_surface_is_free_of_pressure_and_small_depths_keep_their_digits(method, phase):
    shallow = np.array([0.0, 1e-300, 1e-12, 1e-9])
    found = pressure(method, phase, shallow)
    assert found[0] == 0.0
    slope = found[1:] / shallow[1:]
    assert slope == pytest.approx(np.full(3, slope[0]), rel=1e-8, abs=0)


@pytest.mark.parametrize(("method", "phase"), CLOSED)
def test_deep_silos_reach_gamma_r_over_mu(method, phase):
    deepest = WHEAT["unit_weight"] * WHEAT["hydraulic_radius"] / WHEAT["wall_friction"]
    assert pressure(method, phase, 1e18) == pytest.approx(deepest, rel=EXACT, abs=0)


def test_no_lateral_pressure_without_lateral_ratio():
    z = np.array([0.5, 18.0])
    assert np.all(pressure("janssen", "filling", z, lateral_pressure_ratio=0.0) == 0.0)
    tiny = pressure("janssen", "filling", z, lateral_pressure_ratio=1e-18)
    assert tiny == pytest.approx(1e-18 * WHEAT["unit_weight"] * z, rel=EXACT, abs=0)


def exact_envelope(z, depth, mu, k, nu, gamma, radius):
    """The strain-energy solution as the source states it, solved in 50 digits: S'' = (S - 2 nu gamma b)/(2(1-nu)b^2)."""
    z, depth, mu, k, nu, gamma, radius = map(mpmath.mpf, (z, depth, mu, k, nu, gamma, radius))
    b, m = radius / mu, mpmath.sqrt(2 * (1 - nu))
    stress = gamma * b / k * (1 - mpmath.exp(-k * z / b))
    particular, length = 2 * nu * gamma * b, (depth - z) / (b * m)
    c, s = mpmath.cosh(length), mpmath.sinh(length)
    p0 = stress - particular
    # transition: b (gamma - S') = nu/(1-nu) S with S = particular + p0 cosh + q sinh, S' = (p0 sinh + q cosh)/(b m)
    ratio = nu / (1 - nu)
    q = (gamma * b - ratio * particular - p0 * (s / m + ratio * c)) / (c / m + ratio * s)
    return float(b * (gamma - q / (b * m)))


@settings(max_examples=150, deadline=None)
@given(
    share=st.floats(1e-6, 1.0),
    slenderness=st.floats(-6, 3.2).map(lambda e: 10**e),
    mu=st.floats(-9, 0).map(lambda e: 10**e),
    k=st.floats(0.05, 3.0),
    nu=st.floats(0.0, 0.4999999),
)
def test_strain_energy_envelope_in_fifty_digits(share, slenderness, mu, k, nu):
    depth = slenderness * 5.0
    mpmath.mp.dps = 50 + int(2 * max(0, -np.log10(mu * slenderness)))  # the plain form cancels for shallow silos
    mpmath.mp.dps += int(-np.log10(nu)) if nu else 0  # and for a small Poisson's ratio
    exact = exact_envelope(share * depth, depth, mu, k, nu, 7845.32, 1.25)
    changed = {"wall_friction": mu, "lateral_pressure_ratio": k, "poisson_ratio": nu, "cylinder_depth": depth}
    found = call(envelope_pressure, share * depth, {**WHEAT, **changed})
    if nu == 0 and share == 1:
        assert float(found) == 0  # a solid that does not widen leaves the wall at the transition; 50 digits only come close
    else:
        assert float(found) == pytest.approx(exact, rel=2e-13, abs=0)


def test_strain_energy_survives_extremes():
    deep = pressure("jenike_mass_flow", "discharge", [1.0, 5e5], cylinder_depth=5e5)
    assert np.all(np.isfinite(deep))
    assert deep[0] > 0
    no_friction = pressure("jenike_mass_flow", "discharge", [9.0, 18.0], wall_friction=0.0)
    ratio = WHEAT["poisson_ratio"] / (1 - WHEAT["poisson_ratio"])
    assert no_friction == pytest.approx(ratio * WHEAT["unit_weight"] * np.array([9.0, 18.0]), rel=EXACT, abs=0)


def test_design_factors_multiply_janssen():
    z = np.array([4.0, 9.0, 15.0])
    static = janssen.normal_pressure(
        z, **{k: WHEAT[k] for k in ("unit_weight", "hydraulic_radius", "wall_friction", "lateral_pressure_ratio")}
    )
    assert pressure("aij_load_draft", "discharge", z) / static == pytest.approx([1.0, 1.3, 2.6])
    assert pressure("safarian_steel", "discharge", z) / static == pytest.approx([1.5, 1.95, 1.95])
    assert pressure("aij_container_draft", "discharge", z) / static == pytest.approx([1 + 4 / 10.5, 1 + 9 / 10.5, 2.0])


def test_din_relief_meets_filling_pressure_at_the_outlet():
    at_outlet = pressure("din1055_1964", "discharge", 20.5)
    assert at_outlet == pytest.approx(pressure("din1055_1964", "filling", 20.5), rel=EXACT, abs=0)
    above, below = pressure("din1055_1964", "discharge", [14.5, np.nextafter(14.5, 15)])
    assert above == pytest.approx(below, rel=1e-14, abs=0)
