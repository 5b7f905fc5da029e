"""Blocks in which a large cube is written: every case once, in order, in whole pieces of the file."""

from math import prod

import numpy as np
import pytest

from silostudy.sweep.slabs import blocks, extents


@pytest.mark.parametrize("shape", [(), (1,), (7,), (3, 5), (4, 1, 6), (5, 3, 2, 4)])
@pytest.mark.parametrize("piece", [1, 2, 5, 1000])
@pytest.mark.parametrize("count", [1, 3, 8, 1000])
def test_blocks_cover_every_case_once(shape, piece, count):
    chunk, cells, seen = extents(shape, piece), np.arange(prod(shape)).reshape(shape), []
    assert prod(chunk) <= piece
    for first, last, place in blocks(shape, chunk, count):
        np.testing.assert_array_equal(cells[place].ravel(), np.arange(first, last))
        assert last - first <= max(count, prod(chunk))
        for part, size in zip(place, chunk, strict=True):
            assert part.start % size == 0
        seen += range(first, last)
    assert seen == list(range(prod(shape)))
