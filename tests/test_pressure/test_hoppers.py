"""Hoppers: vertical balance over random scenes, wedges, the switch, and the flow pattern."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silostudy.compute.hopper import balanced
from silostudy.pressure import PRESSURE, hopper_shape, janssen, radial_field
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import hopper
from silostudy.pressure.family import IN_SCOPE
from silostudy.pressure.jenike_1969 import State, flow_field, initial_field
from silostudy.pressure.mass_flow import PATTERNS, flow_pattern, limit_angle
from silostudy.scene.silo import Silo
from tests.test_pressure.bins import BIN, one

WITH_BALANCE = [(row.key, phase) for row in PRESSURE.values() for phase, total in row.totals.items() if "outlet_force" in total]


@st.composite
def scenes(draw, slots=True):
    diameter, slot = draw(st.floats(0.5, 30)), draw(st.sampled_from([0.0, 1.0] if slots else [0.0]))
    phi = np.radians(draw(st.floats(20, 50)))
    silo = Silo(plan="slot" if slot else "circular", diameter=diameter, wall_depth=1.0, length=draw(st.floats(0.5, 5)))
    return BIN | {
        "unit_weight": draw(st.floats(1e3, 3e4)),
        "internal_friction_angle": phi,
        "effective_friction_angle": phi + np.radians(draw(st.floats(0, 15))),
        "wall_friction": np.tan(phi) * draw(st.floats(0.01, 1)),
        "hopper_wall_friction": np.tan(phi) * draw(st.floats(0.01, 1)),
        "lateral_pressure_ratio": draw(st.floats(0.2, 0.7)),
        "hydraulic_radius": silo.hydraulic_radius,
        "perimeter": silo.perimeter,
        "length": silo.length,
        "diameter": diameter,
        "slot": slot,
        "circular": 1 - slot,
        "cylinder_depth": diameter * draw(st.floats(0.45, 8)),
        "hopper_half_angle": np.radians(draw(st.floats(3, 65))),
        "outlet_width": diameter * draw(st.one_of(st.just(0.0), st.floats(1e-3, 0.8))),
    }


@pytest.mark.parametrize(("method", "phase"), WITH_BALANCE)
@settings(max_examples=40, deadline=None)
@given(scene=scenes())
def test_weight_and_load_are_carried(method, phase, scene):
    found = balanced(PRESSURE[method], phase, one(scene))["hopper_balance"][0]
    if np.isfinite(found):
        assert abs(float(found)) < 1e-10


def test_the_balance_is_met_by_many_scenes_and_could_fail():
    assert {("jenike_1969", "filling"), ("jenike_1969", "discharge"), ("en1991_4", "discharge")} <= set(WITH_BALANCE)
    for method, phase in WITH_BALANCE:
        assert np.isfinite(balanced(PRESSURE[method], phase, one(BIN))["hopper_balance"][0]).all()
    wrong = one(BIN) | {"plan": np.array(["circular"]), "perimeter": np.array([15.0])}
    assert abs(float(balanced(PRESSURE["jenike_1969"], "filling", wrong)["hopper_balance"][0])) < 1e-10
    heavier = PRESSURE["jenike_mass_flow"].hopper["filling"]["hopper_normal_pressure"]
    assert call(heavier, 1.0, BIN | {"unit_weight": 9e3}) > 1.1 * call(heavier, 1.0, BIN)


WEDGE = BIN | {"slot": 1.0, "circular": 0.0, "perimeter": 2.0, "length": 1.0, "hydraulic_radius": 2.5}


@pytest.mark.parametrize("phase", ["filling", "discharge"])
@pytest.mark.parametrize("angle", [10.0, 18.0, 35.0, 55.0])
@pytest.mark.parametrize("outlet", [0.0, 0.6])
def test_wedges_by_en_1991_4_carry_contents_and_load(phase, angle, outlet):
    scene = one(WEDGE | {"hopper_half_angle": np.radians(angle), "outlet_width": outlet})
    missing, scope = balanced(PRESSURE["en1991_4"], phase, scene)["hopper_balance"]
    assert scope == IN_SCOPE
    assert abs(float(missing)) < 1e-12


def test_the_wedge_exponent_of_programs_breaks_equilibrium():
    """S (F T) - 2 with S = 1 against slices, d(p_v x)/dx = F T p_v - gamma x, which ask for F T - 1: by a long way."""
    weight, top, ft = 8e4, 5e4, 1.4
    share = np.linspace(0.1, 1, 2001)
    missing = {}
    for off in (1, 2):
        p_v = hopper.vertical_pressure(share, weight=weight, exponent=ft - off, top=top)
        carried = np.trapezoid(ft * p_v, share)
        held = top - share[0] * p_v[0] + weight * (1 - share[0] ** 2) / 2
        missing[off] = 1 - carried / held
    assert abs(missing[1]) < 1e-5
    assert abs(missing[2]) > 0.3


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9, 1.0])
def test_balance_at_every_place_of_the_switch(share):
    """Flow field below the switch, ring force at it, initial field above: together the contents and the load."""
    state, flow = State(initial_field, BIN), State(flow_field, BIN)
    top, bottom = state.height, hopper_shape.outlet_height(BIN["outlet_width"], BIN["hopper_half_angle"])
    at = bottom + share * (top - bottom)
    ring = call(PRESSURE["jenike_1969"].hopper["switch"]["switch_force"], np.array([at]), BIN)[0]
    below = flow.weight * flow.bearing * ((at / top) ** 3 - (bottom / top) ** 3)
    initial = state.weight * (1 - (at / top) ** 3) + (janssen_load() - state.ring_force) - state.force(np.array([at]))[0]
    total = below + ring + initial + state.ring_force + flow.field_force(bottom)
    contents = state.weight * (1 - (bottom / top) ** 3)
    assert float(total) == pytest.approx(contents + janssen_load(), rel=1e-12, abs=0)


def janssen_load():
    return call(janssen.transition_force, None, BIN)


def test_switch_arrives_with_the_ring_force_of_flow():
    row = PRESSURE["jenike_1969"]
    arrived = call(row.hopper["switch"]["switch_force"], np.array([State(flow_field, BIN).height]), BIN)
    assert float(arrived[0]) == pytest.approx(float(call(row.totals["discharge"]["ring_force"], None, BIN)), rel=1e-12, abs=0)


def test_flow_pattern_keeps_the_designers_margin():
    limit = float(limit_angle(np.radians(40), 0.3))
    angles = np.array([limit - 0.06, limit - 0.01, limit + 0.01])
    flags = flow_pattern(angles, np.radians(40), 0.3, 0.0)
    assert [PATTERNS[flag] for flag in flags] == ["mass_flow", "within_the_margin", "funnel_flow"]
    assert PATTERNS[int(flow_pattern(0.3, np.nan, 0.3, 0.0))] == "unknown"
    assert PATTERNS[int(flow_pattern(0.3, np.radians(15), 0.1, 0.0))] == "unknown"


def test_beyond_the_limit_flow_is_masked_and_filling_is_not():
    scene = one(BIN | {"hopper_half_angle": np.radians(20), "hopper_wall_friction": 0.6})
    row = PRESSURE["jenike_1969"]
    assert np.isnan(call(row.totals["discharge"]["ring_force"], None, scene)).all()
    assert np.isfinite(call(row.totals["filling"]["outlet_force"], None, scene)).all()


def test_one_call_over_many_cases_is_the_cases_one_by_one():
    angles = np.radians([[10.0], [15.0], [20.0]])
    together = radial_field.flow_slope(angles, 0.3, np.radians([[40.0, 50.0]]), 0.0)
    assert together.shape == (3, 2)
    assert together[1, 1] == pytest.approx(float(radial_field.flow_slope(angles[1, 0], 0.3, np.radians(50.0), 0.0)), rel=1e-9)


def test_strain_energy_of_a_slot_in_fine_slices():
    """Plane strain: the least of the sum of (1 - nu)(S^2 + p^2) - 2 nu S p over slices, by linear algebra."""
    nu, gamma, radius, mu, k, depth, z_s, n = 0.3, 8e3, 2.5, 0.3, 0.5, 10.0, 4.0, 4000
    b, h = radius / mu, (depth - z_s) / n
    s0 = float(janssen.vertical_pressure(z_s, unit_weight=gamma, hydraulic_radius=radius, wall_friction=mu,
                                         lateral_pressure_ratio=k))  # fmt: skip
    # quadratic form in the nodal S; mid-slice values, p = b (gamma - dS/dz)
    import scipy.sparse as sp
    import scipy.sparse.linalg as sl

    mean = sp.diags([np.full(n, 0.5), np.full(n, 0.5)], [0, 1], shape=(n, n + 1))
    slope = sp.diags([np.full(n, -b / -h), np.full(n, b / -h)], [0, 1], shape=(n, n + 1))  # of p, less b gamma
    hessian = 2 * (1 - nu) * (mean.T @ mean + slope.T @ slope) - 2 * nu * (mean.T @ slope + slope.T @ mean)
    force = -(2 * (1 - nu) * slope.T - 2 * nu * mean.T) @ np.full(n, b * gamma)
    free = sp.csc_matrix(hessian)[1:, 1:]
    s = sl.spsolve(free, force[1:] - np.asarray(sp.csc_matrix(hessian)[1:, 0].todense()).ravel() * s0)
    expected = b * (gamma - (s[0] - s0) / h)
    scene = BIN | {"poisson_ratio": nu, "slot": 1.0, "hydraulic_radius": radius, "cylinder_depth": depth, "unit_weight": gamma}
    found = call(PRESSURE["jenike_mass_flow"].phases["discharge"]["wall_normal_pressure"], z_s, scene)
    assert float(found) == pytest.approx(expected, rel=2e-3, abs=0)
    circular = call(PRESSURE["jenike_mass_flow"].phases["discharge"]["wall_normal_pressure"], z_s, scene | {"slot": 0.0})
    assert abs(float(circular) / expected - 1) > 0.01  # the two energies differ
