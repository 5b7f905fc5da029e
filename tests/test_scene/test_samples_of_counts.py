"""Samples of keys that take whole numbers."""

import pytest

from silostudy.choice.expand import expand
from silostudy.config.load import read_yaml
from silostudy.errors import BadInput
from tests.conftest import ROOT


def test_a_sampled_range_of_whole_numbers_says_what_to_write():
    """Spheres are counted: a range of real numbers gives fractions of them."""
    content = read_yaml(ROOT / "config/studies/silo-of-spheres.yaml")
    ranges = {"filling.count": {"start": 100, "stop": 200}, "spheres.restitution": {"start": 0.2, "stop": 0.5}}
    sweep = [{"axis": "plan", "sample": {"count": 3, "ranges": ranges}}, content["sweep"][-1]]
    with pytest.raises(BadInput, match=r"filling\.count = .*whole number: a sampled range gives fractions, list whole numbers"):
        expand(content | {"sweep": sweep, "codes": None, "outputs": []}, "plan", "plan.yaml", ROOT / "config/studies", [0])
    listed = ranges | {"filling.count": [100, 150, 200]}
    sweep[0]["sample"]["ranges"] = listed
    found = expand(content | {"sweep": sweep, "codes": None, "outputs": []}, "plan", "plan.yaml", ROOT / "config/studies", [0])
    assert found.cases[0].scene.config.filling.count in listed["filling.count"]
