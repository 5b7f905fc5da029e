"""What a cube of means over fillings tells of the accuracy that was asked of them."""

from typing import Any

import numpy as np

SURE = 2.0  # standard errors that a change must exceed to be none of chance


def step_unsure(certificate: Any) -> Any:
    """Where half the step may change a mean by more than was asked of it: by its change and SURE standard errors of that.

    certificate: a cube or a table with error_asked, error_met, step_change and step_change_deviation; nothing is known of a
    step that no filling was halved for.
    """
    change, deviation = certificate["step_change"], certificate["step_change_deviation"]
    known = np.abs(change) + SURE * deviation <= certificate["error_asked"]
    return (certificate["error_met"] >= 0.0) & ~known
