"""What is left in a silo of spheres over the time of its discharge."""

import numpy as np
import pytest

from silostudy.compute.scenes_spheres import SHARES, left


def test_what_has_passed_by_then_is_gone():
    """Three of four equal masses pass a tenth, half and 0.99 of the way from 1 s to 3 s, the first before it."""
    found = left(np.array([0.5, 1.19, 1.99, 2.98]), np.ones(4), 5.0, 1.0, 3.0)
    assert found[0] == pytest.approx(0.8)
    assert found[SHARES > 0.09][0] == pytest.approx(0.6)
    assert found[np.searchsorted(SHARES, 0.5)] == pytest.approx(0.4)
    assert found[-1] == pytest.approx(0.2)
    assert (np.diff(found) <= 0.0).all()


def test_without_an_opening_nothing_is_told():
    assert np.isnan(left(np.array([0.5]), np.ones(1), 2.0, np.nan, 3.0)).all()
