"""A row of the measured fronts, and a trial of what the fronts make one choose: what every kind of front shares."""

import json
from dataclasses import dataclass
from typing import Any

from silostudy.accuracy.front import on_front


@dataclass(frozen=True)
class Trial:
    """One error asked for on one scene: what the choice gave, its cost, and the cheapest cost that would have met it."""

    kind: str
    quantity: str
    asked: float
    error: float
    cost: float
    cheapest: float

    @property
    def met(self) -> bool:
        return self.error <= self.asked


def front_row(kind: str, quantity: str, settings: dict[str, Any], error: float, cost: float, scenes: int, source: str) -> dict:
    """A row of tables/fronts.csv, but for machine and date: worst relative error over the scenes, CPU seconds."""
    return {
        "kind": kind,
        "quantity": quantity,
        "settings": json.dumps(settings),
        "error": float(f"{error:.3g}"),
        "cost_s": float(f"{cost:.3g}"),
        "scenes": scenes,
        "source": source,
        "locator": "measured on its model",
    }


def kept(rows: list[dict]) -> list[dict]:
    """The rows on the front."""
    worth = on_front([row["cost_s"] for row in rows], [row["error"] for row in rows])
    return [row for row, on in zip(rows, worth, strict=True) if on]
