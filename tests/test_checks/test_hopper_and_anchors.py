"""The stage of the checks below the wall: the hopper in equilibrium, anchors by hand."""

import numpy as np
import pytest

from silostudy.compute.checks import checks_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.tables.constants import STANDARD_GRAVITY
from tests.conftest import expanded
from tests.test_checks.studies import cube_of, study


def test_hopper_hangs_in_equilibrium_in_the_cube(parts):
    """EN 1991-4 after filling: the meridional force at the transition carries load and contents, less what the outlet bears."""
    _, pressure, cube = parts
    here = {"pressure_method": "en1991_4", "wall_friction_end": "upper"}
    forces, solid = cube.sel(here | {"combination": "F"}), pressure.sel(here | {"phase": "filling"})
    hanging = float(solid["hopper_weight"] + solid["transition_force"] - solid["outlet_force"])
    plate = 7850 * STANDARD_GRAVITY * 0.007 * np.pi * (3.0**2 - 0.3**2) / np.sin(np.pi / 6)
    found = float(forces["hopper_meridional_force"][0]) * 2 * np.pi * 3.0 * np.cos(np.pi / 6)
    assert found == pytest.approx(1.5 * hanging + 1.35 * plate, rel=2e-3)
    thin = study(hopper_shell__thickness_mm=float(cube["hopper_required_thickness"].max()) * 1e3, methods=["en1991_4"])
    assert float(cube_of(thin)["hopper_check_utilisation"].max()) == pytest.approx(1, rel=0.02)
    ring = float(forces["transition_ring_force"])
    assert ring == pytest.approx(float(forces["hopper_meridional_force"][0]) * 3.0 * 0.5, rel=1e-12)


@pytest.mark.parametrize("phase", ["filling", "discharge"])
def test_every_method_s_hopper_hangs_in_equilibrium(phase):
    """Contents and load less the outlet's force, the ring force of Jenike's switch included, for every method in balance."""
    own = [{"combination": "A", "leading": "solids", "contents": "full", "permanent": 0.0, "solids": 1.0}]
    content = study(checks={"combinations": own}, methods=["jenike_mass_flow", "en1991_4", "jenike_1969"])
    content["scene"] |= {"wall_friction_end": "mean", "properties": {"effective_friction_angle_deg": 45.0}}
    content["scene"]["silo"]["hopper"]["half_angle_deg"] = 15.0
    content["hopper_position"]["count"], content["phases"] = 201, [phase]
    expansion = expanded(content)
    pressure = pressure_cube(expansion)
    solid = pressure.isel(phase=0)
    hanging = (solid["hopper_weight"] + solid["transition_force"] - solid["outlet_force"]).values
    top = checks_cube(expansion, pressure)["hopper_meridional_force"].isel(combination=0, hopper_position=0).values
    found = top * 2 * np.pi * 3.0 * np.cos(np.radians(15.0))
    balanced = np.isfinite(hanging) & (np.abs(solid["hopper_balance"].values) < 1e-6)
    assert balanced.sum() >= 2
    np.testing.assert_allclose(found[balanced], hanging[balanced], rtol=2e-3)


def test_anchors_by_hand(cube):
    """4 M/(n d) - W/n with the roof and the steel alone, and the wind's higher harmonics with a held top."""
    one = cube.sel(combination="WE", pressure_method="janssen", wall_friction_end="upper")
    weight = 7850 * STANDARD_GRAVITY * 18 * (0.33 * 4 + 0.33 * 5 + 0.34 * 7) * 1e-3 * 6 * np.pi + 30e3
    moment = 1.5 * 0.7 * 900 * 6 * 18**2 / 2
    higher = 1.5 * 900 * 18**2 / 6 / 4 * (4 * 0.8 + 9 * 0.3 - 16 * 0.1 - 25 * 0.05)
    by_hand = moment * 4 / (24 * 6.2) - weight / 24 + higher * np.pi * 6.0 / 24  # 6.2 m, the circle of the anchors
    assert float(one["anchor_tension"]) == pytest.approx(by_hand, rel=1e-9)


def test_few_anchors_are_no_elastic_ring():
    content = study(anchors__count=7, methods=["janssen"])
    scope = cube_of(content)["support_check_utilisation_scope"].sel(support_check="anchors", combination="WE")
    assert {scope.attrs["flag_meanings"].split()[flag] for flag in np.unique(scope)} == {"out_of_range"}
