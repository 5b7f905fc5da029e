"""Inserts: what one is, in the plane and in space; those of a scene of discs, a family."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from silostudy.catalogue import Entry, Family
from silostudy.dem.model import Wall
from silostudy.packing.family import PackingField

Pair: TypeAlias = tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class Insert(Entry):
    """Kind of insert. make(name, **arguments) -> a wall or surface; asks: fields of an entry of a scene's `inserts`."""

    asks: tuple[PackingField, ...]
    make: Callable[..., Any]

    def arguments(self, section: Any) -> Mapping[str, Any]:
        """Values that an entry gives, by the names of its arguments."""
        return {field.argument: getattr(section, field.name) for field in self.asks}


def line(name: str, ends: tuple[Pair, Pair]) -> Wall:
    """A straight line that pushes on both sides, and from its ends; its front is on the left of the way to its second end."""
    start, end = ends
    return Wall(name, start, end, faces=2)


NAME = PackingField(
    name="name", argument="name", text="name that its forces are recorded under", unit="", kind=str, bounds={"min_length": 1}
)
LINES: Family[Insert] = Family(
    "insert",
    [
        Insert(
            key="line",
            title="A straight line with two ends",
            asks=(
                NAME,
                PackingField(
                    name="ends_m", argument="ends", unit="m", kind=tuple[Pair, Pair],
                    text="its two ends, x and y each (y above the outlet); its front is on the left of the way from one to the "
                    "other; it may stand outside the silo, as a base below the outlet does",
                ),
            ),
            make=line,
        ),
    ],
)  # fmt: skip
