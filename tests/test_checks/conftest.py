"""The slender silo of the checks, computed once."""

import pytest

from silostudy.compute.checks import checks_cube
from silostudy.compute.pressure import pressure_cube
from tests.conftest import expanded
from tests.test_checks.studies import study


@pytest.fixture(scope="session")
def parts():
    expansion = expanded(study())
    pressure = pressure_cube(expansion)
    return expansion, pressure, checks_cube(expansion, pressure)


@pytest.fixture(scope="session")
def cube(parts):
    return parts[2]
