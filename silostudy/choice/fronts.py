"""Measured fronts: which settings reach which error at what cost, in which scenes.

What an error depends on from scene to scene are the scene's traits, numbers by name.  A row holds for scenes whose traits lie
`within` its ranges; where it is `scaled_by` a trait, its error is that of a scene in which the trait is 1, and goes with it.
"""

import json
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from silostudy.tables.read import HERE, rows

COLUMNS = ("kind", "quantity", "settings", "error", "scaled_by", "within", "cost_s", "scenes",
           "machine", "measured_on", "source", "locator")  # fmt: skip
TEXT = ("kind", "quantity", "settings", "scaled_by", "within", "machine", "measured_on")
Traits = Mapping[str, float]


@dataclass(frozen=True)
class FrontPoint:
    """Worst relative error of a quantity over the measured scenes with these settings (dotted keys), and CPU seconds."""

    kind: str
    quantity: str
    settings: str  # JSON
    error: float
    scaled_by: str  # a trait, or empty
    within: dict[str, tuple[float, float]]  # range of each trait in which it was measured
    cost: float
    machine: str
    measured_on: str

    @property
    def given(self) -> dict[str, Any]:
        """Settings by dotted key."""
        return json.loads(self.settings)

    @property
    def keys(self) -> tuple[str, ...]:
        """Dotted keys that its settings set."""
        return tuple(self.given)

    def holds(self, scene: Traits) -> bool:
        """Whether the scene's traits lie where the row was measured."""
        return all(low <= scene[name] <= high for name, (low, high) in self.within.items())

    def expected(self, scene: Traits) -> float:
        """Error (1) expected of a scene."""
        return self.error * (scene[self.scaled_by] if self.scaled_by else 1.0)


def _measured(raw: dict) -> FrontPoint:
    names = ("kind", "quantity", "settings", "error", "scaled_by", "machine", "measured_on")
    within = {name: (low, high) for name, (low, high) in json.loads(raw["within"] or "{}").items()}
    return FrontPoint(cost=raw["cost_s"], within=within, **{name: raw[name] for name in names})


TRAITS: dict[str, str] = {raw["trait"]: raw["title"] for raw in rows(HERE / "traits.csv", text=("trait",))}
FRONTS = [_measured(raw) for raw in rows(HERE / "fronts.csv", text=TEXT)]


def rows_for(kinds: Collection[str], quantities: Collection[str]) -> list[FrontPoint]:
    """The rows of some quantities on the fronts of some kinds."""
    return [row for row in FRONTS if row.kind in kinds and row.quantity in quantities]
