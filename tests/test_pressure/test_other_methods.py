"""Pieper's flour, AS 3774 and Jenike's funnel-flow rules: against their formulas written out, and their scopes."""

import mpmath
import numpy as np
import pytest

from silostudy.compute.pressure import pressure_cube
from silostudy.pressure import PRESSURE, as3774_1996, janssen, pieper_flour
from silostudy.pressure.calls import call
from silostudy.pressure.jenike_funnel_1973 import effective_transition
from silostudy.tables.walls import WALLS
from tests.conftest import expanded
from tests.test_pressure.bins import BIN

CELL = {
    "kind": "pressure",
    "title": "flour",
    "scene": {
        "silo": {"plan": "square", "width_m": 4.0, "cylinder_depth_m": 22.0},
        "solid": "flour",
        "wall": "roughness_2",
    },
    "methods": ["pieper_flour", "pieper_flour_small", "pieper_flour_buckling"],
    "depth_m": [5.0, 22.0],
}


def exact(z, gamma, ratio, angle_deg):
    """Janssen for the 4 m square cell in 50 digits."""
    with mpmath.workdps(50):
        mu = mpmath.tan(mpmath.radians(angle_deg))
        return float(mpmath.mpf(gamma) / mu * (1 - mpmath.exp(-ratio * mu * z)))


@pytest.mark.parametrize(
    ("method", "phase", "gamma", "ratio", "share"),
    [
        ("pieper_flour", "filling", (2 * 0.8 + 0.6) / 3, "0.31", 0.90),
        ("pieper_flour", "discharge", (2 * 0.8 + 0.6) / 3, "0.47", 0.8 * 0.90),
        ("pieper_flour_small", "discharge", (0.8 + 2 * 0.6) / 3, "0.47", 0.8 * 0.90),
        ("pieper_flour_buckling", "filling", (2 * 0.8 + 0.6) / 3, "0.31", 0.95),
        ("pieper_flour_buckling", "discharge", (2 * 0.8 + 0.6) / 3, "0.47", 0.8 * 0.95),
    ],
)
def test_flour_in_a_square_cell(method, phase, gamma, ratio, share):
    cube = pressure_cube(expanded(CELL))
    for depth in (5.0, 22.0):
        found = float(cube["wall_normal_pressure"].sel(pressure_method=method, phase=phase, depth=depth))
        expected = exact(depth, gamma * 9806.65, mpmath.mpf(ratio), share * 20)
        assert found == pytest.approx(expected, rel=1e-13, abs=0)


def test_design_unit_weights_are_the_sources_roundings():
    cube = pressure_cube(expanded(CELL))
    found = cube["design_unit_weight"].sel({"phase": "filling"}) / 9806.65
    assert [round(float(value), 2) for value in found] == [0.73, 0.67, 0.73]
    assert float(cube["averaging_height"].max()) == pytest.approx(0.7 * 4)


def test_more_friction_for_buckling_hangs_more_on_the_wall():
    cube = pressure_cube(expanded(CELL))["axial_wall_force"].sel({"phase": "filling", "depth": 22.0})
    assert float(cube.sel(pressure_method="pieper_flour_buckling")) > 1.01 * float(cube.sel(pressure_method="pieper_flour"))


def test_polished_walls_lose_five_hundredths_except_glass():
    for group in (2, 3, 4, 5):
        new, polished = WALLS[f"roughness_{group}"].factors, WALLS[f"roughness_{group}_polished"].factors
        assert polished == pytest.approx({grain: factor - 0.05 for grain, factor in new.items()})
    assert "roughness_1_polished" not in WALLS


def test_model_law_by_hydraulic_radius():
    """Pressure and depth scale with R/R: what a small model measures, a similar large cell has at the scaled depth."""
    own = {"unit_weight": 7e3, "wall_friction": 0.3, "lateral_pressure_ratio": 0.4}
    small = janssen.normal_pressure(3.0, hydraulic_radius=0.175, **own)
    pressure, depth = pieper_flour.model_law(small, 3.0, hydraulic_radius=0.175, other_hydraulic_radius=2.875)
    assert janssen.normal_pressure(depth, hydraulic_radius=2.875, **own) == pytest.approx(float(pressure), rel=1e-13)


def test_flour_needs_two_unit_weights(study):
    cube = pressure_cube(expanded(study | {"methods": ["pieper_flour"]}))
    flag = cube["wall_normal_pressure_scope"]
    assert flag.attrs["flag_meanings"].split()[int(flag.max())] == "solid_property_missing"


@pytest.mark.parametrize(("mu", "phi"), [(0.3, 0.5), (0.05, 0.6), (0.6, 0.6), (0.0, 0.5)])
def test_as3774_ratio_in_fifty_digits(mu, phi):
    with mpmath.workdps(50):
        s, c, m = mpmath.sin(phi), mpmath.cos(phi), mpmath.mpf(mu)
        k = (1 + s**2 - 2 * mpmath.sqrt(s**2 - (m * c) ** 2)) / (4 * m**2 + c**2)
    assert float(as3774_1996.lateral_ratio(mu, phi)) == pytest.approx(max(float(k), 0.35), rel=1e-13)


def test_as3774_flow():
    row = PRESSURE["as3774_1996"]
    scene = BIN | {"cylinder_depth": 15.0}
    ratio = {}
    for quantity in ("wall_normal_pressure", "wall_friction_traction"):
        filling, flow = (call(row.phases[phase][quantity], 7.0, scene) for phase in ("filling", "discharge"))
        ratio[quantity] = float(flow / filling)
    assert ratio["wall_normal_pressure"] == pytest.approx(7.6 * 3**0.06 - 6.4)
    assert ratio["wall_friction_traction"] == pytest.approx(1.2)
    planar = as3774_1996.flow_factor(cylinder_depth=15.0, diameter=5.0, slot=1.0)
    assert float(planar) == pytest.approx(1.2 * (7.6 * 3**0.06 - 6.4))


def funnel(z, depth, angle=8.0):
    scene = BIN | {"cylinder_depth": depth, "outlet_depth": depth, "channel_half_angle": np.radians(angle)}
    return float(call(PRESSURE["jenike_funnel_1973"].bounded("discharge")["wall_normal_pressure"], z, scene)), scene


def test_funnel_flow_rules():
    shallow, scene = funnel(6.0, 10.0)
    assert shallow == pytest.approx(float(call(janssen.normal_pressure, 6.0, scene)))
    assert np.isnan(funnel(6.0, 17.5)[0])
    tall, scene = funnel(6.0, 30.0)
    transition = effective_transition(diameter=5.0, outlet_depth=30.0, channel_half_angle=np.radians(8.0))
    envelope = PRESSURE["jenike_mass_flow"].phases["discharge"]["wall_normal_pressure"]
    assert tall == pytest.approx(float(call(envelope, 6.0, scene | {"cylinder_depth": transition})))
    assert np.isnan(funnel(transition + 0.1, 30.0)[0])
    assert transition == pytest.approx(30 - 2.5 / np.tan(np.radians(8.0)))
