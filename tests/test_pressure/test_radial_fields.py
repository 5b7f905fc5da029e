"""Jenike's radial fields and their transition force against other solvers and fifty digits, and where no field exists."""

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_bvp, solve_ivp

from silostudy.compute.evaluate import masked
from silostudy.pressure import PRESSURE, hopper_shape, janssen, radial_field
from silostudy.pressure.calls import call
from silostudy.pressure.family import OUT_OF_RANGE
from silostudy.pressure.jenike_1969 import INITIAL_RATIO, State, flow_field, initial_field
from silostudy.pressure.mass_flow import limit_angle
from tests.test_pressure.bins import BIN, one


def test_peak_without_load_is_the_sources_formula():
    """p = gamma D / [2 (1 + m i)(tan theta + tan phi')], cone and wedge."""
    for slot, perimeter in ((0.0, np.pi * 5), (1.0, 2.0)):
        scene = BIN | {"slot": slot, "perimeter": perimeter, "hopper_wall_friction": 0.6}
        state = State(initial_field, scene, loaded=0.0)
        spread = np.tan(scene["hopper_half_angle"]) + scene["hopper_wall_friction"]
        peak = scene["unit_weight"] * 5.0 / (2 * (1 + (1 - slot) * state.peak) * spread)
        assert float(state.largest) == pytest.approx(float(peak), rel=1e-12, abs=0)
        assert float(state.normal_pressure(np.array([state.peak * state.height]))[0]) == pytest.approx(float(peak), rel=1e-12)


@pytest.mark.parametrize("excess", [0.0, 1e-15, 1e-12, 1e-8, 1e-4, 0.3, 50.0, 1e6, 1e12])
@pytest.mark.parametrize("slot", [0.0, 1.0])
@pytest.mark.parametrize("share", [1e-6, 0.3, 0.9999999, 1.0])
def test_force_in_fifty_digits_from_peaks_at_the_transition_to_peaks_at_the_apex(excess, slot, share):
    """Bearing 1 + excess: i = 1 for no excess, i -> 0 for a large one; both ends are removable singularities."""
    m = int(1 - slot)
    scene = BIN | {"slot": slot, "perimeter": 2.0 if slot else np.pi * 5, "hydraulic_radius": 2.5 if slot else 1.25}
    steepness = float(hopper_shape.steepness(scene["hopper_half_angle"], scene["hopper_wall_friction"]))
    state = State(lambda: (1 + excess) / (steepness * (1 + m)), scene, loaded=0.0)
    with mpmath.workdps(50):
        bearing = mpmath.mpf(float(state.slope)) * mpmath.mpf(steepness) * (1 + m)
        carried = min(mpmath.mpf(1), bearing)
        g = carried * (1 + m) / bearing
        i = 2 * g / (1 + mpmath.sqrt(1 + 4 * m * g))
        x = mpmath.mpf(share)
        below = min(x, i)
        area = below ** (m + 2) / (i * (m + 2))
        if x > i:
            area += ((x ** (m + 1) - i ** (m + 1)) / (m + 1) - (x ** (m + 2) - i ** (m + 2)) / (m + 2)) / (1 - i)
        wall = carried / (1 + m * i) * (1 + m) * (2 + m) * area
        exact = float(wall), float(wall - x ** (2 + m))
    found = float(state.force(np.array([share * float(state.height)]))[0] / state.weight)
    assert found == pytest.approx(exact[1], rel=1e-13, abs=3e-15 * exact[0])  # a difference of two forces


def test_transition_force_is_the_sources_formula():
    """Q_c = (pi/4)^m gamma D^(2+m) L^(1-m) (1 - exp(-lam h/D))/lam; lam = 4 K mu for m = 1, 2 K mu for m = 0."""
    for slot, perimeter, radius, length in ((0.0, np.pi * 5, 1.25, 1.0), (1.0, 6.0, 2.5, 3.0)):
        scene = BIN | {"slot": slot, "perimeter": perimeter, "hydraulic_radius": radius}
        m, lam = 1 - slot, (4 - 2 * slot) * 0.5 * 0.3
        q = (np.pi / 4) ** m * 8e3 * 5 ** (2 + m) * length**slot * (1 - np.exp(-lam * 2)) / lam
        assert float(call(janssen.transition_force, None, scene)) == pytest.approx(q, rel=1e-12, abs=0)


@pytest.mark.parametrize(("theta", "phi_w", "delta"), [(20, 20, 40), (25, 10, 50)])
@pytest.mark.parametrize("m", [0, 1])
def test_flow_field_against_a_boundary_value_solver(theta, phi_w, delta, m):
    half, wall, k = np.radians(theta), np.radians(phi_w), np.sin(np.radians(delta))
    target = wall + np.arcsin(np.sin(wall) / k)

    def equations(angle, y):
        s, w = y
        a, b, c, t = s * (1 - k * np.cos(w)), s * (1 + k * np.cos(w)), s * (1 + k), -s * k * np.sin(w)
        cot = 1 / np.tan(angle)
        e1 = -((2 + m) * a - b - m * c + m * t * cot + np.cos(angle))  # = t'
        e2 = np.sin(angle) - (3 + m) * t - m * (b - c) * cot  # = b'
        out = np.empty_like(y)
        for i in range(angle.size):  # the two equations solved as they stand, no closed form
            matrix = [[-k * np.sin(w[i]), -s[i] * k * np.cos(w[i])], [1 + k * np.cos(w[i]), -s[i] * k * np.sin(w[i])]]
            out[:, i] = np.linalg.solve(matrix, [e1[i], e2[i]])
        return out

    first = 1e-4 if m else 1e-7  # of the half angle; a cone's axis is a singular point, a wedge's is none
    mesh = np.linspace(first * half, half, 60)
    found = radial_field.flow_slope(half, np.tan(wall), np.radians(delta), 1 - m)
    start = np.array([np.full(60, 0.3), np.linspace(0, target, 60)])
    solved = solve_bvp(equations, lambda ya, yb: np.array([ya[1], yb[1] - target]), mesh, start, tol=1e-9, max_nodes=20000)
    assert solved.success
    expected = solved.y[0, -1] * (1 + k * np.cos(target)) / np.cos(half)
    assert float(found) == pytest.approx(expected, rel=2e-5, abs=0)
    if m:  # the cone as a whole: wall = weight + what the field presses through a spherical cap, all over gamma r^3
        s, w = solved.y
        down = s * (1 - k * np.cos(w)) * np.cos(solved.x) + s * k * np.sin(w) * np.sin(solved.x)
        cap = np.trapezoid(2 * np.pi * np.sin(solved.x) * down, solved.x)
        pressure = float(found) * np.cos(half)
        carried = 2 * np.pi / 3 * np.sin(half) * pressure * (np.sin(half) + np.tan(wall) * np.cos(half))
        assert carried == pytest.approx(2 * np.pi / 3 * (1 - np.cos(half)) + cap, rel=1e-4, abs=0)


@pytest.mark.parametrize("m", [0, 1])
def test_initial_field_against_an_initial_value_solver(m):
    half, mu, ratio = np.radians(15), 0.5, INITIAL_RATIO
    spread = (2 + m) / ratio - 1 - m

    def wall(on_axis):
        def equations(angle, y):
            b, t = y
            return [np.sin(angle) - (3 + m) * t, -(spread * b + m * t / np.tan(angle) + np.cos(angle))]

        first = 1e-6
        start = [on_axis, -(spread * on_axis + 1) / (1 + m) * first]
        return solve_ivp(equations, (first, half), start, rtol=1e-11, atol=1e-13).y[:, -1]

    (b0, t0), (b1, t1) = wall(0.0), wall(1.0)
    on_axis = -(t0 + mu * b0) / (t1 - t0 + mu * (b1 - b0))
    expected = (b0 + on_axis * (b1 - b0)) / np.cos(half)
    assert float(radial_field.initial_slope(half, mu, ratio, 1 - m)) == pytest.approx(expected, rel=1e-6, abs=0)


def test_steep_smooth_fields_tend_to_slices():
    """For small angles the peaked field is that of slices with p = K sigma: slope K / (2 K T - 3), T = 1 + mu/tan(theta)."""
    half, mu = np.radians(0.5), np.tan(np.radians(0.6))
    t = 1 + mu / np.tan(half)
    found = float(radial_field.initial_slope(half, mu, 0.8, 0.0))
    assert found == pytest.approx(0.8 / (1.6 * t - 3), rel=1e-3, abs=0)


@pytest.mark.parametrize("name", ["hopper_normal_pressure", "hopper_friction_traction", "hopper_vertical_pressure"])
def test_without_a_peaked_field_the_initial_state_is_masked(name):
    """The wall of a flat or smooth hopper holds none: the peak would sink to the apex."""
    row, x = PRESSURE["jenike_1969"], np.array([[0.0, 0.5, 2.0]])
    for half_angle, friction in ((40.0, 0.2), (80.0, 0.3), (20.0, np.tan(np.radians(15)))):
        scene = one(BIN | {"hopper_half_angle": np.radians(half_angle), "hopper_wall_friction": friction})
        assert np.isinf(radial_field.initial_slope(np.radians(half_angle), friction, INITIAL_RATIO, 0.0))
        value, scope = masked(row, name, "filling", row.hopper["filling"][name], x, scene)
        assert np.isnan(value).all()
        assert set(scope.ravel()) == {OUT_OF_RANGE}
    assert np.isfinite(masked(row, name, "filling", row.hopper["filling"][name], x, one(BIN))[0]).all()


def test_the_switch_starts_from_the_straight_line_where_that_is_asked_for():
    """Ring force + what flow takes up = the straight-line initial state's force, at every height."""
    x = np.array([1.0, 4.0])
    ring = call(PRESSURE["jenike_mass_flow"].hopper["switch"]["switch_force"], x, BIN)
    initial = call(PRESSURE["jenike_mass_flow"].hopper["filling"]["hopper_vertical_pressure"], x, BIN)
    area = np.pi / 4 * (2 * x * np.tan(BIN["hopper_half_angle"])) ** 2
    assert ring + State(flow_field, BIN).field_force(x) == pytest.approx(initial * area, rel=1e-12)
    assert (ring > 0).all()


@pytest.mark.parametrize("delta", [30, 40, 50, 60])
@pytest.mark.parametrize("phi_w", [8, 15, 22])
def test_radial_flow_fields_end_at_the_mass_flow_limit(delta, phi_w):
    """Two independent things: where the stress-field equations stop having a solution, and the closed limit."""
    mu, d = np.tan(np.radians(phi_w)), np.radians(delta)
    limit = float(limit_angle(d, mu))
    inside, outside = radial_field.flow_slope(limit + np.radians([-0.5, 1.0]), mu, d, 0.0)
    assert np.isfinite(inside)
    assert np.isnan(outside)
