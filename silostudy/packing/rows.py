"""The (s-1)/s packings of Kiyama & Fujimura (1983): rows of s and s - 1 equal discs in turn, four contacts a disc."""

from math import floor, sqrt

import numpy as np

from silostudy.errors import BadInput
from silostudy.packing.family import Packing, PackingField


def place(*, width, height, radius, across, gap, offset=0.0, seed=0):
    """Places x, y and radius (m) of the discs that start within the height, x from the left wall and y from the floor.

    Kiyama & Fujimura (1983), section 5 (1): s = `across` discs span the width. Neighbours along a slope and discs at
    the walls and floor keep a gap (m). Every disc is moved at random by up to `offset` (m) each way.
    Raises BadInput where s discs or a row do not fit, or rows overlap, or the offset is larger than the gap allows.
    """
    if across < 2 or across != int(across):
        raise BadInput("across", across, "must be a whole number of discs, 2 or more")
    pitch = (width - 2.0 * (radius + gap)) / (across - 1)
    if pitch < 2.0 * radius + gap:
        most = max(0, floor((width - gap) / (2.0 * radius + gap)))
        allowed = f"{across} discs of radius {radius:g} m and their gaps do not fit {width:g} m, which has room for {most}"
        raise BadInput("across", across, allowed)
    if pitch >= 2.0 * (2.0 * radius + gap):
        raise BadInput("across", across, "the rows would fall through each other; put more discs across")
    if not 0.0 <= offset <= gap / (2.0 * sqrt(2.0)):
        raise BadInput("offset", offset, f"must lie in 0 ... {gap / (2.0 * sqrt(2.0)):.4g} m, or discs may overlap")
    rise = sqrt((2.0 * radius + gap) ** 2 - (pitch / 2.0) ** 2)
    levels = floor((height - 2.0 * radius - gap) / rise) + 1
    if levels < 1:
        raise BadInput("height", height, f"must be {2.0 * radius + gap:.4g} m or more: not one row of discs lies below it")
    counts = [across - level % 2 for level in range(levels)]
    level = np.repeat(np.arange(levels), counts)
    number = np.concatenate([np.arange(count) for count in counts])
    x = radius + gap + (level % 2) * pitch / 2.0 + number * pitch
    y = radius + gap + level * rise
    moved = offset * np.random.default_rng(seed).uniform(-1.0, 1.0, (2, len(x)))
    return x + moved[0], y + moved[1], np.full(len(x), float(radius))


ROW = Packing(
    key="rows",
    rank=10,
    title="Rows of s and s - 1 equal discs in turn",
    source="kiyama_fujimura_1983",
    locator="section 5 (1), Fig. 6",
    place=place,
    needs=("width", "height", "radius", "across", "gap", "offset", "seed"),
    asks=(
        PackingField(name="across", argument="across", text="s, discs in the lowest row", kind=int, bounds={"ge": 2}),
        PackingField(
            name="fill_height_m", argument="height", text="height up to which rows are laid", unit="m", bounds={"gt": 0}
        ),
        PackingField(name="gap_m", argument="gap", text="gap between neighbours at the start", unit="m", bounds={"ge": 0}),
        PackingField(
            name="offset_m",
            argument="offset",
            text="random offset of every disc, each way",
            unit="m",
            bounds={"ge": 0},
            default=0.0,
        ),
    ),
    count=lambda radius, *, across, height, **_: across * height / (1.8 * radius),
)
