"""The packings: counts, gaps, seeds, and what cannot be."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from silostudy.errors import BadInput
from silostudy.packing import PACKINGS
from silostudy.tables.kiyama_1983 import ACTIVE, DISC_COUNT, GAPS, PASSIVE, RADIUS, SILO_WIDTH

PAPER = {"width": SILO_WIDTH, "height": 0.36, "radius": RADIUS, "gap": GAPS[ACTIVE]}


def gaps(x, y, radius):
    i, j = cKDTree(np.c_[x, y]).query_pairs(2.5 * radius.max(), output_type="ndarray").T
    return np.hypot(x[i] - x[j], y[i] - y[j]) - radius[i] - radius[j]


@pytest.mark.parametrize("across", range(12, 19))
def test_rows(across):
    """Every disc inside has four neighbours at the gap, none nearer; the outer ones stand at the gap from the walls."""
    gap = GAPS.get(across, GAPS[ACTIVE])
    x, y, radius = PACKINGS["rows"].place(**(PAPER | {"gap": gap}), across=across)
    between = gaps(x, y, radius)
    assert between.min() == pytest.approx(gap, rel=1e-6)
    touching = np.zeros(len(x), int)
    i, j = cKDTree(np.c_[x, y]).query_pairs(2.0 * 0.01 + 1.01 * gap, output_type="ndarray").T
    np.add.at(touching, np.r_[i, j], 1)
    inner = (x > 0.03) & (x < 0.37) & (y > 0.02) & (y < y.max() - 0.001)
    assert set(touching[inner]) == {4}
    assert x.min() == pytest.approx(0.01 + gap)
    assert x.max() == pytest.approx(0.39 - gap)
    assert y.min() == pytest.approx(0.01 + gap)
    assert y.max() <= 0.36 - 0.01


def test_the_paper_has_350_discs_or_so():
    x, _, _ = PACKINGS["rows"].place(**PAPER, across=ACTIVE)
    assert len(x) == pytest.approx(DISC_COUNT, rel=0.06)


def test_offsets_are_seeded_and_never_overlap():
    wide = PAPER | {"gap": GAPS[PASSIVE]}
    one, same, other = (PACKINGS["rows"].place(**wide, across=17, offset=1e-4, seed=seed) for seed in (1, 1, 2))
    assert np.array_equal(one[0], same[0])
    assert not np.array_equal(one[0], other[0])
    assert gaps(*one).min() > 0.0
    assert one[0].min() > 0.01


@pytest.mark.parametrize("change", [{"across": 30}, {"across": 1}, {"across": 10}, {"offset": 1e-3}])
def test_rows_that_cannot_be(change):
    with pytest.raises(BadInput, match=next(iter(change))):
        PACKINGS["rows"].place(**(PAPER | {"across": 18, "offset": 0.0} | change))


def test_loose():
    x, y, radius = PACKINGS["loose"].place(width=0.4, count=500, radius=0.01, spread=0.3, seed=4)
    assert len(x) == 500
    assert gaps(x, y, radius).min() > 0.0
    assert np.all((x > radius) & (x < 0.4 - radius) & (y > radius))
    assert 0.007 <= radius.min() < 0.0075
    assert 0.0125 < radius.max() <= 0.013
    with pytest.raises(BadInput, match="radius"):
        PACKINGS["loose"].place(width=0.01, count=5, radius=0.01)


def test_given():
    _x, _y, radius = PACKINGS["given"].place(x=[0.0, 1.0], y=[0.0, 1.0], radius=0.3)
    assert radius.tolist() == [0.3, 0.3]
    with pytest.raises(BadInput, match="equal length"):
        PACKINGS["given"].place(x=[0.0, 1.0], y=[0.0], radius=0.3)
