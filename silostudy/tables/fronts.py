"""Measured fronts: which settings reach which error at what cost, and the cheapest of them for the errors asked for.

What an error depends on from scene to scene are the scene's traits, numbers by name.  A row holds for scenes whose traits lie
`within` its ranges; where it is `scaled_by` a trait, its error is that of a scene in which the trait is 1, and goes with it.
"""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from silostudy.errors import BadInput
from silostudy.tables.read import HERE, rows

COLUMNS = ("kind", "quantity", "settings", "error", "scaled_by", "within", "cost_s", "scenes",
           "machine", "measured_on", "source", "locator")  # fmt: skip
Traits = Mapping[str, float]
ALSO = {"shell": "pressure"}  # a shell study is a pressure study that goes on: what may be asked of one may be of the other


@dataclass(frozen=True)
class Measured:
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

    def holds(self, scene: Traits) -> bool:
        """Whether the scene's traits lie where the row was measured."""
        return all(low <= scene[name] <= high for name, (low, high) in self.within.items())

    def expected(self, scene: Traits) -> float:
        """Error (1) expected of a scene."""
        return self.error * (scene[self.scaled_by] if self.scaled_by else 1.0)


@dataclass(frozen=True)
class Choice:
    """Settings by dotted key, and for each quantity asked for the error expected of them."""

    settings: dict[str, Any]
    expected: dict[str, float]
    measured: str  # on what machine and when


def _measured(raw: dict) -> Measured:
    names = ("kind", "quantity", "settings", "error", "scaled_by", "machine", "measured_on")
    within = {name: (low, high) for name, (low, high) in json.loads(raw["within"] or "{}").items()}
    return Measured(cost=raw["cost_s"], within=within, **{name: raw[name] for name in names})


TEXT = ("kind", "quantity", "settings", "scaled_by", "within", "machine", "measured_on")
ASKED: dict[tuple[str, str], str] = {
    (raw["kind"], raw["quantity"]): raw["title"] for raw in rows(HERE / "asked.csv", text=("kind", "quantity"))
}
TRAITS: dict[str, str] = {raw["trait"]: raw["title"] for raw in rows(HERE / "traits.csv", text=("trait",))}
FRONTS = [_measured(raw) for raw in rows(HERE / "fronts.csv", text=TEXT)]


def rows_for(kind: str) -> list[Measured]:
    """The rows that a kind of study chooses from."""
    return [row for row in FRONTS if row.kind in (kind, ALSO.get(kind))]


def quantities(kind: str) -> tuple[str, ...]:
    """Quantities whose accuracy a kind of study may ask for."""
    return tuple(dict.fromkeys(row.quantity for row in rows_for(kind)))


def choose(kind: str, asked: Mapping[str, float], scenes: Sequence[Traits] = ({},)) -> Choice:
    """The cheapest measured settings that keep every scene's error at or below what is asked; BadInput where none does.

    scenes: traits of each.  Quantities that hang on the same keys are met by one choice.
    """
    return _joined(kind, asked, scenes, cheapest)


def finest(kind: str, asked: Mapping[str, float]) -> Choice:
    """The most accurate settings, whatever they cost: for as long as the scenes are not known."""
    return _joined(kind, asked, (), _finest)


def _joined(kind: str, asked: Mapping[str, float], scenes: Sequence[Traits], pick) -> Choice:
    settings: dict[str, Any] = {}
    expected: dict[str, float] = {}
    told = set()
    for names in _together(kind, asked):
        best, errors = pick(kind, {name: asked[name] for name in names}, scenes)
        settings |= json.loads(best.settings)
        expected |= errors
        told.add(f"{best.machine}, {best.measured_on}")
    return Choice(settings, expected, "; ".join(sorted(told)))


def _together(kind: str, asked: Mapping[str, float]) -> list[list[str]]:
    """The quantities asked for, grouped by the keys that their settings set."""
    groups: dict[tuple, list[str]] = {}
    known = quantities(kind)
    for name, error in asked.items():
        if name not in known:
            raise BadInput("accuracy", name, f"unknown; known: {', '.join(known) or 'none for this kind'}")
        if not error > 0:
            raise BadInput(f"accuracy.{name}", error, "must be above 0")
        first = next(row for row in rows_for(kind) if row.quantity == name)
        groups.setdefault(tuple(json.loads(first.settings)), []).append(name)
    return list(groups.values())


def _rows(kind: str, names) -> dict[str, dict[str, list[Measured]]]:
    """settings -> quantity -> its rows."""
    found: dict[str, dict[str, list[Measured]]] = {}
    for row in rows_for(kind):
        if row.quantity in names:
            found.setdefault(row.settings, {}).setdefault(row.quantity, []).append(row)
    return {settings: by for settings, by in found.items() if len(by) == len(names)}


def cheapest(kind: str, asked: Mapping[str, float], scenes: Sequence[Traits]) -> tuple[Measured, dict[str, float]]:
    """A row of the cheapest settings that reach it, and the worst error expected by quantity."""
    each = [(by, worst(by, scenes)) for by in _rows(kind, asked).values()]
    measured = [(by, errors) for by, errors in each if errors is not None]
    if not measured:
        rows = [row for by, _ in each for all_of in by.values() for row in all_of]
        raise BadInput("accuracy", dict(asked), f"was measured on no such scene: {_outside(rows, scenes)}")
    reached = [(by, errors) for by, errors in measured if all(errors[name] <= asked[name] for name in asked)]
    if not reached:
        least = {name: float(f"{min(errors[name] for _, errors in measured):.3g}") for name in asked}
        raise BadInput("accuracy", dict(asked), f"no measured setting reaches it; the least errors are {least}")
    by, errors = min(reached, key=lambda one: max(row.cost for all_of in one[0].values() for row in all_of))
    return next(iter(by.values()))[0], errors


def _outside(rows: Sequence[Measured], scenes: Sequence[Traits]) -> str:
    """Which traits of the scenes lie outside all ranges, and what they are."""
    ranges: dict[str, dict[tuple[float, float], None]] = {}  # in the order of the rows
    for row in rows:
        for name, span in row.within.items():
            ranges.setdefault(name, {})[span] = None
    told = []
    for name, spans in ranges.items():
        beyond = [one[name] for one in scenes if not any(low <= one[name] <= high for low, high in spans)]
        if beyond:
            measured = " or ".join(f"{low:g} to {high:g}" for low, high in spans)
            told.append(f"{name} {beyond[0]:.3g} (measured {measured}; {TRAITS[name]})")
    return ", ".join(told)


def worst(by: Mapping[str, list[Measured]], scenes: Sequence[Traits]) -> dict[str, float] | None:
    """Worst error expected over the scenes, by quantity; None where one of the scenes is like none that was measured."""
    found = dict.fromkeys(by, 0.0)
    for name, all_of in by.items():
        for scene in scenes:
            holding = [row.expected(scene) for row in all_of if row.holds(scene)]
            if not holding:
                return None
            found[name] = max(found[name], *holding)
    return found


def _finest(kind: str, asked: Mapping[str, float], scenes: Sequence[Traits]) -> tuple[Measured, dict[str, float]]:
    each = [[row for all_of in by.values() for row in all_of] for by in _rows(kind, asked).values()]
    rows = min(each, key=lambda rows: max(row.error for row in rows))
    return rows[0], {row.quantity: row.error for row in rows}
