"""Hopper variables of the cube: reasons of masked values, sweeps as their cases, mistakes told."""

import copy

import numpy as np
import pytest

from silostudy.commands.compare import hopper_table, values_used
from silostudy.compute.pressure import pressure_cube
from silostudy.config.load import study_of
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
from silostudy.pressure.family import REASONS
from tests.conftest import expanded
from tests.test_figures.test_hopper_figures import BIN


@pytest.fixture
def content():
    return copy.deepcopy(BIN)


def reason(cube, name, **where):
    return {REASONS[flag] for flag in np.unique(cube[f"{name}_scope"].sel(where).values)}


def test_round_trip(content, tmp_path):
    cube, path = pressure_cube(expanded(content)), tmp_path / "pressure.nc"
    write(cube, path)
    assert read(path).equals(cube)


def test_every_masked_hopper_value_has_a_reason(content):
    cube = pressure_cube(expanded(content))
    for name in ("hopper_normal_pressure", "switch_force", "ring_force", "hopper_balance", "patch_pressure"):
        assert np.array_equal(np.isnan(cube[name].values), cube[f"{name}_scope"].values != 0), name
    assert reason(cube, "hopper_normal_pressure", pressure_method="janssen", phase="filling") == {
        "quantity_not_defined_by_source"
    }
    assert reason(cube, "hopper_normal_pressure", pressure_method="en1991_4", phase="switch") == {"phase_not_covered"}


def test_without_hopper_or_property(content):
    content["scene"]["silo"].pop("hopper")
    cube = pressure_cube(expanded(content))
    assert reason(cube, "hopper_normal_pressure", pressure_method="en1991_4", phase="filling") == {"no_hopper"}
    content = copy.deepcopy(BIN)
    content["scene"]["properties"] = {}
    cube = pressure_cube(expanded(content))
    assert reason(cube, "ring_force", pressure_method="jenike_1969", phase="discharge") == {"solid_property_missing"}
    assert reason(cube, "ring_force", pressure_method="jenike_1969", phase="filling") == {"in_scope"}
    content["scene"]["silo"] |= {"plan": "square", "width_m": 4.0}
    content["scene"]["silo"].pop("diameter_m")
    cube = pressure_cube(expanded(content))
    assert reason(cube, "hopper_normal_pressure", pressure_method="en1991_4", phase="filling") == {"in_scope"}
    assert reason(cube, "hopper_end_normal_pressure", pressure_method="en1991_4", phase="filling") == {"plan_not_covered"}
    assert reason(cube, "hopper_normal_pressure", pressure_method="jenike_1969", phase="filling") == {"plan_not_covered"}
    assert reason(cube, "wall_normal_pressure", pressure_method="en1991_4", phase="filling", depth=5.0) == {"in_scope"}


def test_a_sweep_gives_what_its_cases_give_alone(content):
    swept = copy.deepcopy(content)
    swept["sweep"] = [{"axis": "angle", "values": {"silo.hopper.half_angle_deg": [12.0, 18.0, 60.0]}}]
    together, alone = pressure_cube(expanded(swept)), pressure_cube(expanded(content))
    for name in ("hopper_normal_pressure", "ring_force", "switch_force", "hopper_balance"):
        np.testing.assert_allclose(together[name].isel(angle=1).values, alone[name].values, rtol=1e-9, atol=1e-12)


def test_square_and_wedge_plans(content):
    content["scene"]["silo"] = {"plan": "slot", "width_m": 4.0, "length_m": 2.0, "cylinder_depth_m": 10.0,
                                "hopper": {"half_angle_deg": 18.0}}  # fmt: skip
    cube = pressure_cube(expanded(content))
    assert float(cube["hydraulic_radius"]) == 2.0
    assert abs(float(cube["hopper_balance"].sel(pressure_method="jenike_1969", phase="discharge"))) < 1e-12
    content["scene"]["silo"]["length_m"] = 4.0
    twice = pressure_cube(expanded(content))
    for name in ("ring_force", "transition_force", "hopper_weight"):
        here = {"pressure_method": "jenike_1969", "phase": "discharge"}
        assert float(twice[name].sel(here)) == pytest.approx(2 * float(cube[name].sel(here)), rel=1e-12)


def test_compare_prints_the_balance_and_the_values_used(content):
    cube = pressure_cube(expanded(content))
    lines = hopper_table(cube)
    assert any(line.startswith("jenike_1969, discharge") and "e-1" in line for line in lines) or "0e+00" in "".join(lines)
    assert "mass flow" in lines[-1]
    used = values_used(cube)
    assert used[0].startswith("en1991_4: wall_normal_pressure: mu lower, K upper, phi lower")
    assert "a_mu 1.16" in used[0]


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ({"hopper_position": [0.5, 0.2]}, "must increase from 0 to 1"),
        ({"hopper_position": [0.0, 1.2]}, "must increase from 0 to 1"),
        (
            {"hopper_position": None, "outputs": ["silo_pressures"]},
            "output silo_pressures shows the hopper: give hopper_position",
        ),
        ({"uncertainty": {"log2_samples": 3}}, "greater than or equal to 6"),
        ({"outputs": ["sobol_indices"]}, "drawn from a uncertainty cube"),
    ],
)
def test_mistakes(content, changed, expected):
    with pytest.raises(BadInput, match=r"small.yaml: ") as caught:
        study_of(content | changed, "small.yaml")
    assert expected in str(caught.value)
