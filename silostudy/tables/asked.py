"""Accuracies that may be asked for in place of settings: of which kind of study or scene, and which settings they decide."""

from collections.abc import Iterable
from dataclasses import dataclass

from silostudy.tables.read import HERE, rows


@dataclass(frozen=True)
class Quantity:
    """A quantity whose largest relative error may be given: of what the error is, and the dotted keys that it decides."""

    front: str
    name: str
    title: str
    decides: tuple[str, ...]  # none: the runs themselves find out how many they must be


def _quantity(raw: dict) -> Quantity:
    return Quantity(raw["kind"], raw["quantity"], raw["title"], tuple(raw["decides"].split()))


ASKED = [_quantity(raw) for raw in rows(HERE / "asked.csv", text=("kind", "quantity", "decides"))]


def quantities(fronts: Iterable[str]) -> dict[str, Quantity]:
    """Name -> quantity, for all that may be asked of fronts of some kinds."""
    named = tuple(fronts)
    return {row.name: row for row in ASKED if row.front in named}
