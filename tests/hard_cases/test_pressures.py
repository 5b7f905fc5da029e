"""Hard cases of wall pressure: against the sources' formulas in high precision, against limits, or masked with a reason."""

import mpmath
import numpy as np
import pytest

from silostudy.errors import BadInput
from silostudy.pressure import PRESSURE, hopper_shape, radial_field
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import hopper
from silostudy.pressure.jenike_1969 import State, initial_field
from silostudy.pressure.jenike_mass_flow import envelope_pressure
from silostudy.pressure.limits import broken
from silostudy.pressure.mass_flow import PATTERNS, flow_pattern, limit_angle
from tests.conftest import SMALL, expanded
from tests.test_pressure.bins import BIN
from tests.test_pressure.test_limits import WHEAT, exact_envelope, pressure

EXACT = 4e-15  # a few units in the last place


def exact_janssen(z, mu, k, radius, gamma):
    with mpmath.workdps(400):
        z, mu, k, radius, gamma = map(mpmath.mpf, (z, mu, k, radius, gamma))
        return float(gamma * radius / mu * (1 - mpmath.exp(-k * mu * z / radius)))


def study_with(**scene):
    return expanded(SMALL | {"scene": SMALL["scene"] | scene})


@pytest.mark.parametrize("z", [1e-6, 1.0, 18.0, 5e4])
def test_janssen_at_a_wall_friction_of_1e_12(z):
    found = pressure("janssen", "filling", z, wall_friction=1e-12)
    assert float(found) == pytest.approx(exact_janssen(z, 1e-12, 0.45, 1.25, WHEAT["unit_weight"]), rel=EXACT, abs=0)


@pytest.mark.parametrize("z", [1.0, 500.0, 5e4])
def test_janssen_at_a_slenderness_of_1e4(z):
    found = pressure("janssen", "filling", z, cylinder_depth=5e4)
    assert float(found) == pytest.approx(exact_janssen(z, 0.44, 0.45, 1.25, WHEAT["unit_weight"]), rel=EXACT, abs=0)


@pytest.mark.parametrize("share", [1e-9, 1e-5, 0.5, 0.999999, 1.0])
def test_strain_energy_at_a_depth_of_1e5_diameters(share):
    depth = 5e5
    with mpmath.workdps(80):
        exact = exact_envelope(share * depth, depth, 0.44, 0.45, 0.4, WHEAT["unit_weight"], 1.25)
    found = call(envelope_pressure, share * depth, WHEAT | {"cylinder_depth": depth})
    assert float(found) == pytest.approx(exact, rel=1e-12, abs=0)


@pytest.mark.parametrize("off", [-1e-12, 0.0, 1e-12])
@pytest.mark.parametrize("share", [1e-9, 0.3, 1.0 - 1e-12, 1.0])
def test_hopper_exponent_next_to_one(off, share):
    n = 1.0 + off
    with mpmath.workdps(60):
        s, e, w, t = mpmath.mpf(share), mpmath.mpf(n), mpmath.mpf(8e4), mpmath.mpf(5e4)
        exact = float(-w * s * mpmath.log(s) + t * s if e == 1 else w / (e - 1) * (s - s**e) + t * s**e)
    found = hopper.vertical_pressure(np.array(share), weight=8e4, exponent=n, top=5e4)
    assert float(found) == pytest.approx(exact, rel=EXACT, abs=0)


@pytest.mark.parametrize("degrees", [1e-3, 0.05, 0.5])
def test_nearly_vertical_hopper(degrees):
    """A rough one is a Janssen pipe: slices of a narrowing cone tend to those of a cylinder of the same width."""
    half, mu = np.radians(degrees), 0.4
    steep = float(hopper_shape.steepness(half, mu))
    assert steep == pytest.approx(1.0 + mu / float(mpmath.tan(mpmath.radians(degrees))), rel=1e-13)
    slope = float(radial_field.initial_slope(half, mu, 0.8, 0.0))
    assert slope == pytest.approx(0.8 / (1.6 * steep - 3.0), rel=2e-2 if degrees > 0.1 else 2e-3)
    state = State(initial_field, BIN | {"hopper_half_angle": half, "hopper_wall_friction": mu})
    carried = state.force(np.array([float(state.height)]))
    assert np.isfinite(carried).all()
    assert np.all(state.normal_pressure(np.linspace(0.0, 1.0, 5) * float(state.height)) >= 0.0)


@pytest.mark.parametrize("degrees", [80.0, 89.0, 89.999])
def test_nearly_flat_hopper(degrees):
    """Neither a flow field nor an initial one exists so flat (masked, not guessed), and the pattern is funnel flow."""
    half, delta = np.radians(degrees), np.radians(45.0)
    assert np.isnan(radial_field.flow_slope(half, 0.4, delta, 0.0))
    assert PATTERNS[int(flow_pattern(half, delta, 0.4, 0.0))] == "funnel_flow"
    state = State(initial_field, BIN | {"hopper_half_angle": half, "hopper_wall_friction": 0.4})
    assert np.isnan(state.force(np.array([float(state.height)]))).all()
    assert state.height == pytest.approx(BIN["diameter"] / 2.0 / np.tan(half), rel=1e-12)


@pytest.mark.parametrize("phi", [1e-12, 1e-6, 1e-3])
def test_no_internal_friction(phi):
    """phi -> 0: a liquid. Active, passive and wall pressure are all gamma z."""
    weight = WHEAT["unit_weight"] * 7.0
    changed = {"internal_friction_angle": phi, "wall_friction": 0.0}
    for phase in ("filling", "discharge"):
        assert float(pressure("caquot", phase, 7.0, **changed)) == pytest.approx(weight, rel=3.0 * phi + EXACT, abs=0)
    assert float(pressure("reimbert", "filling", 7.0, **changed)) == pytest.approx(2.0 * weight, rel=3.0 * phi + EXACT, abs=0)


@pytest.mark.parametrize("below", [1e-1, 1e-3, 1e-6])
def test_internal_friction_of_ninety_degrees(below):
    """phi -> 90 deg: the ratio of principal stresses goes to zero and keeps its digits."""
    phi = np.pi / 2.0 - below
    with mpmath.workdps(50):
        ratio = mpmath.tan(mpmath.pi / 4 - mpmath.mpf(phi) / 2) ** 2
        exact = float(ratio * mpmath.mpf(WHEAT["unit_weight"]) * 7)
    found = float(pressure("reimbert", "filling", 7.0, internal_friction_angle=phi, wall_friction=0.0)) / 2.0
    assert found == pytest.approx(exact, rel=1e-14, abs=0)
    caquot = float(pressure("caquot", "filling", 7.0, internal_friction_angle=phi, wall_friction=0.0))
    assert caquot == pytest.approx(exact, rel=1e-14, abs=0)


@pytest.mark.parametrize("below", [1e-15, 1e-9, 1e-4])
def test_poisson_ratio_next_to_one_half(below):
    nu = 0.5 - below
    with mpmath.workdps(60):
        exact = exact_envelope(7.0, 18.0, 0.44, 0.45, nu, WHEAT["unit_weight"], 1.25)
    found = call(envelope_pressure, 7.0, WHEAT | {"poisson_ratio": nu})
    assert float(found) == pytest.approx(exact, rel=1e-13, abs=0)


@pytest.mark.parametrize("nu", [0.5, 0.6, -0.1])
def test_poisson_ratio_that_no_solid_has(nu):
    with pytest.raises(BadInput, match=r"properties\.poisson_ratio = .*(less than 0\.5|greater than 0)"):
        study_with(properties={"poisson_ratio": nu})


@pytest.mark.parametrize("degrees", [0.0, 90.0, -5.0, float("nan")])
def test_hopper_angle_that_no_hopper_has(degrees):
    with pytest.raises(BadInput, match=r"hopper\.half_angle_deg = .*(greater than 0|less than 90|finite)"):
        study_with(silo=SMALL["scene"]["silo"] | {"hopper": {"half_angle_deg": degrees}})


def test_outlet_as_wide_as_the_silo():
    with pytest.raises(BadInput, match=r"outlet_width_m"):
        study_with(silo=SMALL["scene"]["silo"] | {"hopper": {"half_angle_deg": 20.0, "outlet_width_m": 5.0}})


def test_mass_flow_limit_at_its_ends():
    """A wall as rough as the solid: the limit is the closed one, and beyond it there is none."""
    delta = np.radians(50.0)
    wall = np.tan(delta)
    smooth = float(limit_angle(delta, 0.0))
    k = np.sin(delta)
    assert smooth == pytest.approx(np.pi / 2.0 - np.arccos((1.0 - k) / (2.0 * k)) / 2.0, rel=EXACT)
    assert np.isnan(limit_angle(delta, wall * (1.0 + 1e-9)))
    assert np.isnan(limit_angle(np.radians(19.9999), 0.1))


def test_heap_so_high_that_reimbert_has_no_length():
    """c <= 0: beyond the row's limit, which masks it; and no solid heaps up so steeply, so that a study is refused."""
    high = WHEAT | {"top_cone_height": 60.0, "wall_friction": 0.57}
    limits = PRESSURE["reimbert"].limits
    assert broken(limits, "wall_normal_pressure", "filling", 18.0, high).all()
    assert not broken(limits, "wall_normal_pressure", "filling", 18.0, high | {"top_cone_height": 6.0}).any()
    with pytest.raises(BadInput, match=r"top_cone_height_m = 60\.0: must not be above 9\.33 m"):
        study_with(silo=SMALL["scene"]["silo"] | {"top_cone_height_m": 60.0})


def test_a_million_depths_at_once():
    """One call over a million depths gives what single calls give."""
    depths = np.linspace(0.0, 18.0, 1_000_000)
    for key, phase in (("janssen", "filling"), ("jenike_mass_flow", "discharge"), ("din1055_1964", "discharge")):
        many = pressure(key, phase, depths)
        for at in (0, 1, 499_999, 999_999):
            assert many[at] == pytest.approx(float(pressure(key, phase, depths[at])), rel=EXACT, abs=0, nan_ok=True)


@pytest.mark.parametrize("scale", [1e-9, 1e9])
def test_silos_of_another_size(scale):
    """Every theory without a length of its own gives pressures in proportion to the size."""
    for key in ("janssen", "reimbert", "caquot", "jenike_mass_flow"):
        for phase, quantities in PRESSURE[key].phases.items():
            lengths = ("hydraulic_radius", "diameter", "cylinder_depth", "outlet_depth")
            scene = WHEAT | {name: scale * WHEAT[name] for name in lengths}
            found = call(quantities["wall_normal_pressure"], scale * 7.0, scene)
            assert float(found) == pytest.approx(scale * float(pressure(key, phase, 7.0)), rel=1e-13, abs=0)


def test_solid_without_weight():
    with pytest.raises(BadInput, match=r"unit_weight_kN_m3 = 0.*greater than 0"):
        study_with(properties={"unit_weight_kN_m3": 0})
