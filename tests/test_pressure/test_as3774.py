"""AS 3774: formulas in 50 digits, the squat ramp, hopper, floor, eccentric discharge, swelling: in equilibrium."""

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from silostudy.compute.pressure import pressure_cube
from silostudy.pressure import PRESSURE
from silostudy.pressure.as3774_1996 import cooling, eccentric, floor, hopper, wall
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import hopper as en_hopper
from silostudy.pressure.family import REASONS
from silostudy.pressure.saturation import growth_excess
from tests.conftest import expanded
from tests.test_pressure.bins import BIN

ROW = PRESSURE["as3774_1996"]
SQUAT = BIN | {"cylinder_depth": 4.0, "contact_depth": 0.5}


def value(quantity, z, phase="filling", **changed):
    return float(call(ROW.phases[phase][quantity], np.float64(z), SQUAT | changed))


@pytest.mark.parametrize(("mu", "phi"), [(0.3, 0.5), (0.05, 0.6), (0.6, 0.6), (0.0, 0.5)])
def test_as3774_ratio_in_fifty_digits(mu, phi):
    with mpmath.workdps(50):
        s, c, m = mpmath.sin(phi), mpmath.cos(phi), mpmath.mpf(mu)
        k = (1 + s**2 - 2 * mpmath.sqrt(s**2 - (m * c) ** 2)) / (4 * m**2 + c**2)
    assert float(wall.lateral_ratio(mu, phi)) == pytest.approx(max(float(k), 0.35), rel=1e-13)


def test_as3774_flow():
    row = PRESSURE["as3774_1996"]
    scene = BIN | {"cylinder_depth": 15.0}
    ratio = {}
    for quantity in ("wall_normal_pressure", "wall_friction_traction"):
        filling, flow = (call(row.phases[phase][quantity], 7.0, scene) for phase in ("filling", "discharge"))
        ratio[quantity] = float(flow / filling)
    assert ratio["wall_normal_pressure"] == pytest.approx(7.6 * 3**0.06 - 6.4)
    assert ratio["wall_friction_traction"] == pytest.approx(1.2)
    planar = wall.flow_factor(cylinder_depth=15.0, diameter=5.0, slot=1.0)
    assert float(planar) == pytest.approx(1.2 * (7.6 * 3**0.06 - 6.4))


def test_flow_over_initial_pressure_of_a_slender_silo_as_an_account_lists_it():
    """1.9 for a silo whose h/d is not told: h/d = 4.3 comes to it."""
    assert float(wall.flow_factor(cylinder_depth=4.3, diameter=1.0, slot=0.0)) == pytest.approx(1.9, abs=0.01)


def test_squat_pressure_rises_from_the_contact_to_janssens():
    janssen = {"contact_depth": 0.0}
    assert value("wall_normal_pressure", 0.5) == 0.0
    assert value("wall_normal_pressure", 0.625) == pytest.approx(value("wall_normal_pressure", 0.75, **janssen) / 2)
    for z in (0.75, 0.751, 3.0):
        assert value("wall_normal_pressure", z) == pytest.approx(value("wall_normal_pressure", z, **janssen), rel=1e-12)
    tall = {"cylinder_depth": 5.0}
    assert value("wall_normal_pressure", 0.6, **tall) == value("wall_normal_pressure", 0.6, **tall, **janssen)


@settings(max_examples=40, deadline=None)
@given(contact=st.floats(0.0, 1.2), share=st.floats(0.01, 1), mu=st.floats(0.05, 0.6))
def test_squat_containers_are_in_equilibrium(contact, share, mu):
    """What hangs on the wall is its own friction integrated, and with the vertical pressure it is the weight."""
    own = {"contact_depth": contact, "wall_friction": mu}
    z = contact + share * (4.0 - contact)
    kink = min(1.5 * contact, z)
    parts = [
        quad(lambda t: value("wall_friction_traction", t, **own), *ends, epsrel=1e-11)[0]
        for ends in ((contact, kink), (kink, z))
    ]
    hung = value("axial_wall_force", z, **own)
    assert hung == pytest.approx(sum(parts), rel=1e-9, abs=1e-6)
    assert value("vertical_pressure", z, **own) + hung / 1.25 == pytest.approx(8e3 * z, rel=1e-12)


def test_a_flexible_wall_of_a_squat_container_is_pressed_less():
    rigid = value("wall_normal_pressure", 3.0)
    soft = {"solid_modulus_factor": 70.0, "wall_flexibility": 1 / (200e9 * 2e-3)}
    expected = 1 - 70 * 8e3 * 3.0 * 2.5 / (200e9 * 2e-3)
    assert value("wall_normal_pressure", 3.0, **soft) == pytest.approx(expected * rigid)
    assert value("wall_friction_traction", 3.0, **soft) == value("wall_friction_traction", 3.0)
    softest = soft | {"wall_flexibility": 1.0}
    assert value("wall_normal_pressure", 3.0, **softest) == pytest.approx(0.85 * rigid)
    assert value("wall_normal_pressure", 3.0, **softest, cylinder_depth=5.0) == value(
        "wall_normal_pressure", 3.0, cylinder_depth=5.0
    )
    assert value("wall_normal_pressure", 3.0, **softest, circular=0.0) == rigid


@pytest.mark.parametrize("angle", [10.0, 25.0, 60.0])
@pytest.mark.parametrize("mu", [0.05, 0.3, 0.6])
def test_filling_of_a_hopper_is_en_1991_4s_without_its_share_of_friction(angle, mu):
    """b = 1 in F = 1 - b/(1 + tan(beta)/mu): k_h, and the exponent vanishes."""
    beta = np.radians(angle)
    ratio = hopper.filling_ratio(hopper_half_angle=beta, hopper_wall_friction=mu)
    assert ratio == pytest.approx(1 - 1 / (1 + np.tan(beta) / mu))
    assert en_hopper.exponent(ratio, beta, mu) == pytest.approx(0, abs=1e-12)


def test_flow_in_a_hopper_by_the_codes_own_form():
    """k_hf with eta = eps/2: 2 eta = phi_w + asin(sin phi_w/sin phi)."""
    phi, angle, mu = BIN["internal_friction_angle"], BIN["hopper_half_angle"], BIN["hopper_wall_friction"]
    wall_angle = np.arctan(mu)
    eta = (wall_angle + np.arcsin(np.sin(wall_angle) / np.sin(phi))) / 2
    expected = (1 + np.sin(phi) * np.cos(2 * eta)) / (1 - np.sin(phi) * np.cos(2 * (angle + eta)))
    found = call(ROW.totals["discharge"]["hopper_pressure_ratio"], None, BIN)
    assert float(found) == pytest.approx(expected)
    exponent = float(call(ROW.totals["discharge"]["hopper_exponent"], None, BIN))
    assert exponent == pytest.approx(2 * (expected * (1 + mu / np.tan(angle)) - 1))


def test_the_floor_carries_the_vertical_pressure_on_the_mean():
    p_v = float(call(floor.LOAD, None, BIN))
    place = lambda x: float(call(floor.PRESSURES["floor_normal_pressure"], np.float64(x), BIN))  # noqa: E731
    total = quad(lambda x: 2 * np.pi * x * place(x), 0, 2.5)[0]
    assert total == pytest.approx(p_v * np.pi * 25 / 4, rel=1e-12)
    shear = [float(call(floor.PRESSURES["floor_shear_traction"], np.float64(x), BIN)) for x in (0.0, 1.25, 2.5)]
    assert shear == pytest.approx([0.0, 0.3 * p_v / 4, 0.0])
    assert float(call(floor.LOAD, None, SQUAT)) == pytest.approx(8e3 * 4.0)  # as if nothing hung on the wall


def test_eccentric_discharge():
    own = {"diameter": 5.0, "outlet_eccentricity": 1.25}
    assert eccentric.far_side_increase(**own) == pytest.approx(0.15)
    assert eccentric.near_side_decrease(**own) == pytest.approx(0.225)
    assert eccentric.far_side_increase(diameter=5.0, outlet_eccentricity=0.4) == 0.0
    assert np.degrees(eccentric.near_side_half_angle(diameter=5.0, outlet_eccentricity=0.5)) == pytest.approx(90.0)
    scene = BIN | own | {"outlet_depth": 12.0}
    depth = float(call(ROW.totals["discharge"]["far_side_depth"], None, scene))
    assert depth == pytest.approx(12.0 - 3.75 * np.tan(np.radians(35)))
    pressure = float(call(ROW.totals["discharge"]["far_side_pressure"], None, scene))
    deep = float(call(ROW.totals["discharge"]["far_side_pressure"], None, scene | {"outlet_depth": 16.0}))
    assert np.isnan(deep)  # below the transition
    assert pressure == pytest.approx(1.15 * float(call(ROW.phases["discharge"]["wall_normal_pressure"], depth, scene)))


@pytest.mark.parametrize("share", [0.1, 0.2, 0.3, 0.45])
def test_the_arc_of_the_near_side_is_the_printed_length(share):
    """d_e = 1.83 d_c (1 - 1.43 e_o/d_c) to either side of the outlet, an angle of d_e over the diameter."""
    angle = eccentric.near_side_half_angle(diameter=1.0, outlet_eccentricity=share)
    assert np.degrees(angle) == pytest.approx(np.degrees(1.83 * (1 - 1.43 * share)), abs=0.2)


@pytest.mark.parametrize("x", [0.0, 1e-12, 1e-3, 0.5, 0.999999, 1.0, 1.000001, 3.0, 20.0])
def test_growth_excess_in_fifty_digits(x):
    with mpmath.workdps(80):
        exact = (mpmath.exp(x) - 1 - x) / mpmath.mpf(x) ** 2 if x else mpmath.mpf(1) / 2
    assert float(growth_excess(x)) == pytest.approx(float(exact), rel=4e-15, abs=0)


def test_a_swelling_solid_lifts_the_wall():
    row, z, z_o = PRESSURE["as3774_1996_swelling"].phases["filling"], 6.0, 1.25 / 0.3
    growth = np.exp(z / z_o) - 1
    found = {name: float(call(function, np.float64(z), BIN)) for name, function in row.items()}
    assert found["wall_normal_pressure"] == pytest.approx(8e3 * z_o * growth)
    assert found["axial_wall_force"] == pytest.approx(-8e3 * 1.25 * (z_o * growth - z))
    assert found["wall_friction_traction"] == pytest.approx(-0.3 * found["wall_normal_pressure"])


def test_floor_and_one_source_methods_in_a_study(study):
    study["scene"] |= {
        "silo": {"plan": "circular", "diameter_m": 6.0, "cylinder_depth_m": 12.0},
        "solid": "wheat_e1",
        "wall": "d2",
    }
    study |= {"methods": ["janssen", "as3774_1996"], "depth_m": [12.0], "floor_position": [0.0, 0.5, 1.0]}
    cube = pressure_cube(expanded(study))
    one = cube.sel(pressure_method="as3774_1996", phase="filling")
    assert one["floor_normal_pressure"].values / float(one["bottom_pressure"]) == pytest.approx([1.25, 1.125, 0.75])
    study["scene"]["silo"]["hopper"] = {"half_angle_deg": 20.0}
    cube = pressure_cube(expanded(study))
    assert cube["floor_normal_pressure"].isnull().all()
    flags = cube["floor_normal_pressure_scope"].sel(pressure_method="as3774_1996", phase="filling")
    assert {REASONS[flag] for flag in flags.values} == {"no_flat_floor"}
    everything = expanded(study | {"methods": "all"}).study.method_keys
    assert "as3774_1996" in everything
    assert not {key for key, row in PRESSURE.items() if row.on_request} & set(everything)
    assert expanded(study | {"methods": ["as3774_1996_swelling"]}).study.method_keys == ("as3774_1996_swelling",)


def test_a_cooling_wall_at_its_two_limits():
    """A rigid solid: alpha dT E_w t/r; a rigid wall: alpha dT E_s/(1 - nu), nu = 0.3."""
    strain, stiffness = 1.2e-5 * 20, 200e9 * 5e-3
    own = {"radius": 2.5, "wall_flexibility": 1 / stiffness}
    assert cooling.ring_pressure(strain, **own, solid_modulus=1e30) == pytest.approx(strain * stiffness / 2.5)
    assert cooling.ring_pressure(strain, radius=2.5, wall_flexibility=0.0, solid_modulus=5e6) == pytest.approx(
        strain * 5e6 / 0.7
    )


def test_cooling_is_added_to_the_filling_pressure():
    scene = BIN | {"cooling_strain": 2e-4, "solid_modulus_factor": 100.0, "wall_flexibility": 1e-9}
    row, z = PRESSURE["as3774_1996_cooling"].phases["filling"]["wall_normal_pressure"], np.float64(6.0)
    modulus = 100 * float(call(ROW.phases["filling"]["vertical_pressure"], z, scene))
    expected = 10 * 2e-4 / (2.5e-9 + 0.7 / modulus)
    filling = float(call(ROW.phases["filling"]["wall_normal_pressure"], z, scene))
    assert float(call(row, z, scene)) == pytest.approx(filling + expected)
    assert float(call(row, np.float64(0.0), scene)) == 0.0


@pytest.mark.parametrize(("z", "expected"), [(1.0, 0.6 * 8e3), (2.0, 8e3 * 1.2), (3.0, 8e3 * 1.2)])
def test_rapid_filling(z, expected):
    row = PRESSURE["as3774_1996_rapid_filling"].phases["filling"]["wall_normal_pressure"]
    assert float(call(row, np.float64(z), BIN | {"fluid_depth": 1.2})) == pytest.approx(expected)
    normal = float(call(ROW.phases["filling"]["wall_normal_pressure"], np.float64(z), BIN))
    assert float(call(row, np.float64(z), BIN | {"fluid_depth": 1e-3})) == pytest.approx(normal)  # never less
