"""Readings of a cube of means over fillings: the accuracy that was asked of them, and kept."""

from typing import Any

import numpy as np

SURE = 2.0  # standard errors that a change must exceed to be none of chance


def step_unsure(certificate: Any) -> Any:
    """Mask of the means that half the step may change by more than was asked: by their change and SURE standard errors of it.

    certificate: a cube or a table with error_asked, error_met, step_change and step_change_deviation; nothing is known of a
    step that no filling was halved for.
    """
    change, deviation = certificate["step_change"], certificate["step_change_deviation"]
    known = np.abs(change) + SURE * deviation <= certificate["error_asked"]
    return (certificate["error_met"] >= 0.0) & ~known
