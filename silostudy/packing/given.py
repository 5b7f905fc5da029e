"""Discs whose places are known: from an earlier run, or from another program."""

import numpy as np

from silostudy.errors import BadInput
from silostudy.packing.family import Packing, PackingField


def place(*, x, y, radius):
    """Places x, y and radius (m) as given, a radius for each disc or one for all.  Raises BadInput where the lengths differ."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    if x.shape != y.shape or x.ndim != 1:
        raise BadInput("x", x.shape, f"x and y must be two rows of equal length, y has {y.shape}")
    return x, y, np.broadcast_to(np.asarray(radius, float), x.shape).copy()


ROW = Packing(
    key="given",
    rank=30,
    title="Positions from a file",
    source="kiyama_fujimura_1983",
    locator="none: the arrangement of an earlier run or another program",
    place=place,
    needs=("x", "y", "radius"),
    asks=(
        PackingField(
            name="file",
            text="netCDF file with disc_x, disc_y, disc_radius (m; its last snapshot), relative to the scene file",
            unit="",
            kind=str,
        ),
    ),
    from_file=True,
)
