"""What a source does not define is masked, with the reason; nothing else is."""

import numpy as np
import pytest

from silostudy.compute.pressure import pressure_cube
from silostudy.pressure.family import QUANTITIES, REASONS
from tests.conftest import expanded


def reasons(cube, quantity="wall_normal_pressure", **where):
    return {REASONS[flag] for flag in np.unique(cube[f"{quantity}_scope"].sel(where).values)}


def test_every_masked_value_has_a_reason_and_every_other_none(wheat):
    for quantity in QUANTITIES.keys() & wheat.keys():
        masked = np.isnan(wheat[quantity].values)
        assert np.array_equal(masked, wheat[f"{quantity}_scope"].values != 0)
        assert masked.any()
        assert not masked.all()


def test_phases_and_quantities_a_source_does_not_define(wheat):
    assert reasons(wheat, pressure_method="janssen", phase="discharge") == {"phase_not_covered"}
    ty124 = {"pressure_method": "ty124_1956", "phase": "discharge"}
    assert reasons(wheat, "axial_wall_force", **ty124) == {"quantity_not_defined_by_source"}
    assert reasons(wheat, **ty124) == {"in_scope"}


def test_charts_stop_at_their_ends(wheat):
    aci = wheat["wall_normal_pressure_scope"].sel(pressure_method="aci313_1977", phase="discharge")
    top = 5.0 * np.tan(np.radians(30))
    assert set(np.unique(aci.where(aci.depth < top, drop=True))) == {REASONS.index("outside_published_range")}
    assert set(np.unique(aci.where(aci.depth > top, drop=True))) == {0}


@pytest.mark.parametrize("method", ["jenike_funnel_flow", "deutsch", "aci313_1977"])
def test_one_silos_numbers_are_not_carried_to_another(study, method):
    study["methods"] = [method]
    study["scene"]["silo"]["cylinder_depth_m"] = 18.1
    cube = pressure_cube(expanded(study))
    assert reasons(cube, pressure_method=method, phase="discharge") == {"outside_published_range"}


def test_one_silos_numbers_scale_with_it(study, wheat):
    study |= {"methods": ["deutsch", "jenike_funnel_flow"], "depth_m": [8.5 * 2, 36.0]}
    study["scene"]["silo"] |= {"diameter_m": 10.0, "cylinder_depth_m": 36.0}
    cube = pressure_cube(expanded(study))
    for method in study["methods"]:
        here = {"pressure_method": method, "phase": "discharge"}
        twice = cube["wall_normal_pressure"].sel({**here, "depth": 17.0})
        assert float(twice) == pytest.approx(2 * float(wheat["wall_normal_pressure"].sel({**here, "depth": 8.5})), rel=1e-12)


def test_plans_that_a_source_does_not_cover(study):
    study["scene"]["silo"] = {"plan": "rectangular", "width_m": 4.0, "length_m": 6.0, "cylinder_depth_m": 20.0}
    study["methods"] = ["janssen", "reimbert", "din1055_1964"]
    cube = pressure_cube(expanded(study))
    assert reasons(cube, pressure_method="reimbert", phase="filling") == {"plan_not_covered"}
    assert reasons(cube, pressure_method="janssen", phase="filling") == {"in_scope"}
    assert float(cube["hydraulic_radius"]) == pytest.approx(24 / 20)


def test_missing_property_masks_only_methods_that_need_it(study):
    study["scene"] |= {"solid": "cement", "wall": "painted_concrete"}
    study["methods"] = ["janssen", "din1055_1964", "jenike_mass_flow"]
    cube = pressure_cube(expanded(study))
    assert reasons(cube, pressure_method="janssen", phase="filling") == {"solid_property_missing"}
    assert reasons(cube, pressure_method="din1055_1964", phase="filling") == {"in_scope"}


def test_above_the_wall_contact_there_is_no_wall(study):
    study["scene"]["silo"]["top_cone_height_m"] = 4.5
    cube = pressure_cube(expanded(study))
    assert reasons(cube, pressure_method="janssen", phase="filling", depth=1.0) == {"above_wall_contact"}
    assert reasons(cube, pressure_method="janssen", phase="filling", depth=2.0) == {"in_scope"}
