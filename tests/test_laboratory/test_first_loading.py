"""First loading of a laboratory's cell: windows in which the lid gives way, or presses again, do not count."""

import numpy as np
import pytest

from silostudy.compute.laboratory import _loading, _path
from silostudy.compute.laboratory_readings import Readings


def pressed(vertical, horizontal) -> Readings:
    """Readings of which only the stresses are looked at."""
    nothing = np.zeros(len(vertical))
    return Readings(nothing, np.array(vertical), np.array(horizontal), *[nothing] * 6)


def test_only_windows_that_press_harder_than_any_before_count():
    history = [pressed([1.0, 2.0, 1.5, 3.0], [0.5, 1.0, 9.0, 1.5]), pressed([2.0, 4.0], [9.0, 2.0])]
    vertical, horizontal = _loading(history)
    assert vertical.tolist() == [1.0, 2.0, 3.0, 4.0]
    assert horizontal.tolist() == [0.5, 1.0, 1.5, 2.0]
    assert _path(history, 4) == pytest.approx([0.5, 1.0, 1.5, 2.0])
