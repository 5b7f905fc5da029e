"""The packings: a family of initial arrangements of discs in a box."""

from collections.abc import Callable
from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.packing import given, loose, rows


@dataclass(frozen=True, kw_only=True)
class Packing(Row):
    """place(**needs) -> x, y (m) and radius (m) of the discs."""

    place: Callable
    needs: tuple[str, ...]


PACKINGS: Family[Packing] = Family(
    "packing",
    [
        Packing(
            key="rows",
            title="Rows of s and s - 1 equal discs in turn",
            source="kiyama_fujimura_1983",
            locator="section 5 (1), Fig. 6",
            place=rows.place,
            needs=("width", "height", "radius", "across", "gap", "offset", "seed"),
        ),
        Packing(
            key="loose",
            title="Random and loose, to be rained in",
            source="kiyama_fujimura_1983",
            locator="none: discs of random size and place without contact",
            place=loose.place,
            needs=("width", "count", "radius", "spread", "seed"),
        ),
        Packing(
            key="given",
            title="Positions from a file",
            source="kiyama_fujimura_1983",
            locator="none: the arrangement of an earlier run or another program",
            place=given.place,
            needs=("x", "y", "radius"),
        ),
    ],
)
