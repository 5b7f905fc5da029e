"""What a packing is: one row with a function that lays the discs."""

from collections.abc import Callable
from dataclasses import dataclass

from silostudy.catalogue import Row


@dataclass(frozen=True, kw_only=True)
class Packing(Row):
    """place(**needs) -> x, y (m) and radius (m) of the discs."""

    place: Callable
    needs: tuple[str, ...]
