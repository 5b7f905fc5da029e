"""The fronts of shell studies: jumps are seen, trials on other silos, and a cube against one of many levels."""

import numpy as np
import pytest

from silostudy.accuracy import fronts_shell
from silostudy.accuracy.fronts_levels import studies, trials_of
from silostudy.choice.pressure import LEVELS, integral_number, jump_number, smooth_number
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from silostudy.config.load import read_yaml
from tests.conftest import ROOT, expanded

Z = np.linspace(0.0, 1.0, LEVELS)


def test_numbers_of_friction():
    """A step from 1 to 3 half-way down makes half of 2 over the mean 2; a smooth curve has no jump."""
    step = np.where(Z < 0.5, 1.0, 3.0)
    assert jump_number(step + 1e-3 * Z) == pytest.approx(0.5, rel=1e-2)
    assert smooth_number(step + 1e-3 * Z) == 0
    assert jump_number(1 - np.exp(-9 * Z)) == 0
    assert smooth_number(Z**2) == integral_number(Z**2) == pytest.approx(0.5, rel=1e-4)


@pytest.mark.long
@pytest.mark.parametrize("quantity", fronts_shell.QUANTITIES, ids=lambda quantity: quantity.name)
def test_levels_meet_what_was_asked_on_other_silos(quantity):
    found = trials_of(quantity, fronts_shell.walled(studies(12, 60, 3), 12), lambda text: None)
    assert len(found) >= 6
    assert np.mean([trial.met for trial in found]) >= 0.95
    assert np.median([trial.setting / trial.least for trial in found]) <= 1.5


@pytest.mark.parametrize(
    "asked", [{"axial_wall_force": 0.01}, {"required_thickness": 0.003}, {"axial_wall_force": 0.05, "peak_pressure": 0.02}]
)
def test_a_shell_cube_keeps_and_records_what_was_asked(asked):
    content = read_yaml(ROOT / "config/studies/steel-wheat-silo.yaml")
    content = {name: value for name, value in content.items() if name not in ("relative_depth", "depth_m", "outputs")}
    content["sweep"] = [{"axis": "slenderness", "values": {"silo.slenderness": [1.0, 3.0, 6.0]}}]

    def cube(**more):
        expansion = expanded(content | more, ROOT / "config/studies")
        pressure = pressure_cube(expansion)
        return shell_cube(expansion, pressure), pressure

    (found, pressed), (fine, pressed_fine) = cube(accuracy=asked), cube(relative_depth={"start": 0, "stop": 1, "count": 4001})
    largest = {"axial_wall_force": (found, fine), "required_thickness": (found, fine), "peak_pressure": (pressed, pressed_fine)}
    names = {"peak_pressure": "wall_normal_pressure"}
    for name, error in asked.items():
        one, other = (each[names.get(name, name)].max("relative_depth") for each in largest[name])
        assert float(abs(one / other - 1).max()) <= error
        assert f"{name} {error:g}" in found.attrs["accuracy_asked"]
    assert f"'count': {found.sizes['relative_depth']}" in found.attrs["accuracy_settings"]
    assert found.sizes["relative_depth"] < 200
