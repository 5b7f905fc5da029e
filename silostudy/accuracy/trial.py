"""A row of the measured fronts, and a trial of what the fronts make one choose: what every kind of front shares."""

import json
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.accuracy.front import on_front

LEAST = 1e-3  # s of CPU time that a reading lasts at least


@dataclass(frozen=True)
class Trial:
    """One error asked for on one scene: what the choice gave, its cost, and the cheapest cost that would have met it."""

    kind: str
    quantity: str
    asked: float
    error: float
    cost: float
    cheapest: float
    setting: float = np.nan  # the number that the settings vary, and the least of them that would have met it
    least: float = np.nan

    @property
    def met(self) -> bool:
        return self.error <= self.asked


def front_row(
    kind: str, quantity: str, settings: dict[str, Any], error: float, cost: float, scenes: int, source: str,
    *, scaled_by: str = "", within: dict[str, tuple[float, float]] | None = None,
) -> dict:  # fmt: skip
    """A row of tables/fronts.csv, but for machine and date: worst relative error over the scenes, CPU seconds."""
    return {
        "kind": kind,
        "quantity": quantity,
        "settings": json.dumps(settings),
        "error": float(f"{error:.3g}"),
        "scaled_by": scaled_by,
        "within": json.dumps(within) if within else "",
        "cost_s": float(f"{cost:.3g}"),
        "scenes": scenes,
        "source": source,
        "locator": "measured on its model",
    }


def worthwhile(rows: list[dict]) -> list[dict]:
    """The rows on the front."""
    worth = on_front([row["cost_s"] for row in rows], [row["error"] for row in rows])
    return [row for row, on in zip(rows, worth, strict=True) if on]


def cpu_seconds(run: Callable[[], Any], readings: int = 3) -> float:
    """CPU time of a run: median of readings, each of as many runs as make one."""
    readings_s = []
    for _ in range(readings):
        runs, start = 0, time.process_time()
        while (spent := time.process_time() - start) < LEAST or not runs:
            run()
            runs += 1
        readings_s.append(spent / runs)
    return float(np.median(readings_s))
