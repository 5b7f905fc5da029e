"""Measured fronts: which settings reach which error at what cost, and the cheapest of them for the errors asked for."""

import json
from dataclasses import dataclass
from typing import Any

from silostudy.errors import BadInput
from silostudy.tables.read import HERE, rows

COLUMNS = ("kind", "quantity", "settings", "error", "cost_s", "scenes", "machine", "measured_on", "source", "locator")


@dataclass(frozen=True)
class Measured:
    """Worst relative error of a quantity over the measured scenes with these settings (dotted keys), and CPU seconds."""

    kind: str
    quantity: str
    settings: str  # JSON
    error: float
    cost: float
    machine: str
    measured_on: str


@dataclass(frozen=True)
class Choice:
    """Settings by dotted key, and for each quantity asked for the error expected of them."""

    settings: dict[str, Any]
    expected: dict[str, float]
    measured: str  # on what machine and when


def _measured(raw: dict) -> Measured:
    names = ("kind", "quantity", "settings", "error", "machine", "measured_on")
    return Measured(cost=raw["cost_s"], **{name: raw[name] for name in names})


TEXT = ("kind", "quantity", "settings", "machine", "measured_on")
FRONTS = [_measured(raw) for raw in rows(HERE / "fronts.csv", text=TEXT)]


def quantities(kind: str) -> tuple[str, ...]:
    """Quantities whose accuracy a kind of study may ask for."""
    return tuple(dict.fromkeys(row.quantity for row in FRONTS if row.kind == kind))


def choose(kind: str, asked: dict[str, float]) -> Choice:
    """The cheapest measured settings whose worst error is at most what is asked; BadInput where none reaches it.

    Quantities that hang on the same keys are met by one choice.
    """
    settings: dict[str, Any] = {}
    expected: dict[str, float] = {}
    told = set()
    for names in _together(kind, asked):
        best = _cheapest(kind, {name: asked[name] for name in names})
        settings |= json.loads(best[0].settings)
        expected |= {row.quantity: row.error for row in best}
        told |= {f"{row.machine}, {row.measured_on}" for row in best}
    return Choice(settings, expected, "; ".join(sorted(told)))


def _together(kind: str, asked: dict[str, float]) -> list[list[str]]:
    """The quantities asked for, grouped by the keys that their settings set."""
    groups: dict[tuple, list[str]] = {}
    known = quantities(kind)
    for name, error in asked.items():
        if name not in known:
            raise BadInput("accuracy", name, f"unknown; known: {', '.join(known) or 'none for this kind'}")
        if not error > 0:
            raise BadInput(f"accuracy.{name}", error, "must be above 0")
        first = next(row for row in FRONTS if row.kind == kind and row.quantity == name)
        groups.setdefault(tuple(json.loads(first.settings)), []).append(name)
    return list(groups.values())


def _cheapest(kind: str, asked: dict[str, float]) -> list[Measured]:
    """One row a quantity, all of the same settings."""
    by_settings: dict[str, list[Measured]] = {}
    for row in FRONTS:
        if row.kind == kind and row.quantity in asked:
            by_settings.setdefault(row.settings, []).append(row)
    reached = [each for each in by_settings.values() if all(row.error <= asked[row.quantity] for row in each)]
    if not reached:
        least = {name: min(row.error for row in FRONTS if row.kind == kind and row.quantity == name) for name in asked}
        raise BadInput("accuracy", asked, f"no measured setting reaches it; the least errors are {least}")
    return min(reached, key=lambda each: max(row.cost for row in each))
