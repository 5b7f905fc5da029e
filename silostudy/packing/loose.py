"""Random loose packing: discs on a wide grid, shaken in place, to be rained in by gravity."""

import numpy as np

from silostudy.errors import BadInput
from silostudy.packing.family import Packing, PackingField

ROOM = 2.3  # of the largest radius: side of the square that each disc has for itself


def place(*, width, count, radius, spread=0.0, seed=0):
    """Places x, y and radius (m) of `count` discs without contact, radii even from radius (1 - spread) to radius (1 + spread).

    Raises BadInput where not one disc fits the width, or the spread is not in 0 ... 1.
    """
    if not 0.0 <= spread < 1.0:
        raise BadInput("spread", spread, "must lie in 0 ... 1, below 1")
    side = ROOM * radius * (1.0 + spread)
    across = int(width / side)
    if across < 1:
        raise BadInput("radius", radius, f"not one disc of this size fits the width {width:g} m")
    random = np.random.default_rng(seed)
    radii = radius * random.uniform(1.0 - spread, 1.0 + spread, count)
    level, number = np.divmod(np.arange(count), across)
    free = np.c_[np.full(count, width / across), np.full(count, side)] - 2.0 * radii[:, None]
    corner = np.c_[number * width / across, level * side]
    x, y = (corner + radii[:, None] + free * random.uniform(0.0, 1.0, (count, 2))).T
    return x, y, radii


ROW = Packing(
    key="loose",
    rank=20,
    title="Random and loose, to be rained in",
    source="kiyama_fujimura_1983",
    locator="none: discs of random size and place without contact",
    place=place,
    needs=("width", "count", "radius", "spread", "seed"),
    asks=(
        PackingField(name="count", argument="count", text="number of discs", kind=int, bounds={"ge": 1, "le": 10_000_000}),
        PackingField(
            name="radius_spread",
            argument="spread",
            text="radii lie between radius (1 - spread) and radius (1 + spread)",
            bounds={"ge": 0, "lt": 1},
            default=0.0,
        ),
    ),
    count=lambda radius, *, count, **_: count,
    spread="spread",
)
