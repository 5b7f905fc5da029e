"""The source's seismic study, made quick, and its cube."""

import copy

import pytest

from silostudy.compute.seismic import seismic_cube
from silostudy.config.load import read_yaml
from tests.conftest import ROOT, expanded

SASAKI = ROOT / "config/studies/sasaki-1991.yaml"


def quick() -> dict:
    """The default study, with few candidates and trials."""
    content = copy.deepcopy(read_yaml(SASAKI))
    content["identification"] |= {"refinement": 2, "recovery_trials": 5}
    return content


@pytest.fixture
def content() -> dict:
    return quick()


@pytest.fixture(scope="module")
def cube():
    return seismic_cube(expanded(quick()))
