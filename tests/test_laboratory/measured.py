"""A laboratory's cell that is really pressed and sheared, and what must hold of any."""

from typing import Any

import numpy as np

from silostudy.compute.laboratory import OFF, measure
from silostudy.scene.expand import Expansion


def measured(found: Expansion, case: int = 0) -> dict[str, Any]:
    """The numbers of one cell with one of its fillings."""
    return measure(found.study, found.cases[case].scene)


def check_balanced(numbers: dict[str, Any], within: float) -> None:
    """Forces and torques on the cell are in balance (share of them), and its stresses are those asked for."""
    for name in ("force_imbalance", "internal_torque_imbalance", "wall_torque_imbalance"):
        assert abs(numbers[name]).max() < within, name
    for name in ("pressing_stress_error", "internal_stress_error", "wall_stress_error"):
        assert abs(numbers[name]).max() < OFF, name


def check_bits(numbers: dict[str, Any], again: dict[str, Any], other: dict[str, Any]) -> None:
    """The same filling gives the same bits, another gives others."""
    assert all(np.array_equal(numbers[name], again[name]) for name in numbers)
    assert (other["internal_shear_ratio"] != numbers["internal_shear_ratio"]).any()
