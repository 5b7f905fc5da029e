"""Combinations of actions on a silo with their partial factors: the package's table, which a study may replace."""

from dataclasses import dataclass, fields

from silostudy.catalogue import Entry, Family
from silostudy.tables.read import HERE, rows

ACTIONS = ("solids", "wind", "snow", "suction", "earthquake")
CONTENTS = ("full", "filling", "empty")
SIDES = ("none", "pressed", "lifted")


@dataclass(frozen=True, kw_only=True)
class Combination(Entry):
    """One combination of actions: the one that leads it, what stands in the silo, and a factor for each.

    permanent: on roof and steel where they press; permanent_favourable: where they hold down.
    side: of a wall that an earthquake bends.
    """

    leading: str
    contents: str
    side: str
    permanent: float
    permanent_favourable: float
    solids: float
    wind: float
    snow: float
    suction: float
    earthquake: float
    source: str = ""
    locator: str = ""

    @property
    def actions(self) -> frozenset[str]:
        """The variable actions that it counts."""
        return frozenset(name for name in ACTIONS if getattr(self, name) > 0)

    @property
    def factors(self) -> dict[str, float]:
        """Factor of every action."""
        return {name: getattr(self, name) for name in ("permanent", "permanent_favourable", *ACTIONS)}


def _combination(raw: dict) -> Combination:
    known = {item.name for item in fields(Combination)}
    return Combination(key=raw["combination"], **{name: value for name, value in raw.items() if name in known})


_TEXT = ("combination", "leading", "contents", "side")
COMBINATIONS: Family[Combination] = Family(
    "combination of actions", map(_combination, rows(HERE / "combinations.csv", text=_TEXT))
)
