"""EN 1991-4, action assessment classes and what they change, load on the bottom, corrugated walls."""

import numpy as np
import pytest

from silostudy.compute.pressure import pressure_cube
from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import classes, factors
from silostudy.pressure.en1991_4.characteristic import characteristic
from tests.conftest import expanded
from tests.test_pressure.bins import BIN
from tests.test_pressure.slender import PROPERTIES, SLENDER, value


@pytest.mark.parametrize(
    ("tonnes", "eccentricity", "expected"),
    [(99, 0.0, 1), (101, 0.4, 2), (999, 0.26, 2), (1001, 0.25, 2), (1001, 0.26, 3), (9999, 0.2, 2), (10_001, 0.0, 3)],
)
def test_least_assessment_class(tonnes, eccentricity, expected):
    given_ = {"volume": tonnes * 1e3 * 9.80665 / 8e3, "unit_weight": 8e3, "diameter": 5.0}
    assert classes.least_class(**given_, outlet_eccentricity=5 * eccentricity) == expected
    for declared in (1.0, 2.0, 3.0):
        taken = classes.class_taken(assessment_class=declared, **given_, outlet_eccentricity=5 * eccentricity)
        assert taken == declared


def test_simplified_factors_of_class_1():
    """Slender, e = 0.1 d_c: C_h = 1.15 + 1.5 * 1.04 * C_op; between squat and slender nothing is given."""
    off_axis = {"filling_eccentricity": 0.5, "outlet_eccentricity": 0.2, "diameter": 5.0}
    assert factors.simplified_normal_factor(patch_factor=0.5, **off_axis, cylinder_depth=10.0) == pytest.approx(1.93)
    assert factors.simplified_friction_factor(**off_axis, cylinder_depth=10.0) == pytest.approx(1.456)
    assert factors.simplified_normal_factor(patch_factor=0.5, **off_axis, cylinder_depth=5.0) == 1.0
    assert np.isnan(factors.simplified_friction_factor(**off_axis, cylinder_depth=9.9))


def test_class_1_takes_mean_values_on_the_wall_and_magnifies_the_load_on_the_hopper():
    own = {"method": "en1991_4_class_1", "z": 9.0}
    assert value("wall_normal_pressure", **own) == value("wall_normal_pressure", method="en1991_4_mean", z=9.0)
    assert value("wall_friction_traction", "discharge", **own) == pytest.approx(
        1.4 * (1 + 0.4 * 0.1) * value("wall_friction_traction", method="en1991_4_mean", z=9.0)
    )
    load = {
        key: float(call(PRESSURE[key].totals["filling"]["transition_force"], None, SLENDER))
        for key in ("en1991_4", "en1991_4_class_1")
    }
    assert load["en1991_4_class_1"] == pytest.approx(1.3 * load["en1991_4"])
    assert "patch_pressure" not in PRESSURE["en1991_4_class_1"].totals["filling"]


def test_the_bottom_is_loaded_by_the_pressure_at_the_transition_times_its_magnifier():
    totals = PRESSURE["en1991_4"].totals["filling"]
    p_v = value("vertical_pressure", z=12.0)
    for dynamic, magnifier in ((0.0, 1.0), (1.0, 1.2)):
        scene = SLENDER | {"dynamic_bottom": dynamic}
        assert float(call(totals["bottom_load_magnifier"], None, scene)) == magnifier
        assert float(call(totals["bottom_pressure"], None, scene)) == pytest.approx(magnifier * p_v)
        assert float(call(totals["transition_force"], None, scene)) == pytest.approx(magnifier * p_v * np.pi * 25 / 4)


@pytest.mark.parametrize("name", ["wall_normal", "wall_friction"])
def test_friction_of_a_corrugated_wall_is_made_of_like_values(name):
    scene = {one: BIN[one] for one in PROPERTIES}
    sign = {"wall_normal": -1, "wall_friction": 1}[name]
    inside, flat = np.tan(scene["internal_friction_angle"] * 1.1**sign), 0.3 * 1.15**sign
    assert characteristic(name, **scene, contact_share=0.2)[0] == pytest.approx(0.8 * inside + 0.2 * flat)
    assert characteristic(name, **scene, contact_share=1.0)[0] == pytest.approx(flat)
    rough = characteristic(name, **(scene | {"wall_friction": 5.0}), contact_share=0.2)[0]
    assert rough == pytest.approx(inside)  # never more than the solid on itself
    hopper_filling = PRESSURE["en1991_4"].used["filling"]["hopper"]["wall_friction"]
    assert call(hopper_filling, None, BIN | {"contact_share": 0.2}) == call(hopper_filling, None, BIN)  # of flat sheet


def silent(cube, method):
    return bool(cube["wall_normal_pressure"].sel(pressure_method=method).isnull().all())


def test_the_declared_class_decides_which_load_cases_are_given(study):
    silo = {"plan": "circular", "diameter_m": 3.0, "cylinder_depth_m": 9.0, "outlet_eccentricity_m": 1.0}
    study["scene"] |= {"silo": silo, "solid": "wheat_e1", "wall": "d2"}
    study |= {"methods": ["en1991_4", "en1991_4_class_1", "en1991_4_eccentric"], "depth_m": [9.0]}
    # silent methods by the class declared: eccentric discharge is given unless a lower class than 3 is declared
    for declared, expected in ((None, set()), (1, {"en1991_4_eccentric"}), (2, {"en1991_4_class_1", "en1991_4_eccentric"}),
                               (3, {"en1991_4_class_1"})):  # fmt: skip
        study["scene"]["silo"] = silo | {"action_assessment_class": declared}
        cube = pressure_cube(expanded(study))
        assert {method for method in study["methods"] if silent(cube, method)} == expected
        assert (cube["least_assessment_class"].sel(pressure_method="en1991_4") == 1).all()
    study["scene"]["silo"] = silo | {"cylinder_depth_m": 29.0, "diameter_m": 5.0, "action_assessment_class": 1}
    cube = pressure_cube(expanded(study))
    assert silent(cube, "en1991_4_class_1")  # more than 100 t
    assert (cube["least_assessment_class"].sel(pressure_method="en1991_4") == 2).all()
