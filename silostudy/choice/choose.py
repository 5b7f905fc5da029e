"""The cheapest measured settings that keep every error asked for in every scene."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from silostudy.choice.fronts import TRAITS, FrontPoint, Traits, rows_for
from silostudy.choice.promise import Choice
from silostudy.errors import BadInput

Rows = Mapping[str, list[FrontPoint]]  # of one setting: quantity -> its rows


def choose(fronts: Sequence[str], asked: Mapping[str, float], scenes: Sequence[Traits] = ({},)) -> Choice:
    """The choice from the fronts of some kinds; BadInput where no measured settings reach what is asked.

    scenes: traits of each.  Quantities that hang on the same keys are met by one choice.
    """
    settings: dict[str, Any] = {}
    expected: dict[str, float] = {}
    told = set()
    for names in _together(fronts, asked):
        best, errors = cheapest(fronts, {name: asked[name] for name in names}, scenes)
        settings |= best.given
        expected |= errors
        told.add(f"{best.machine}, {best.measured_on}")
    return Choice(dict(asked), settings, expected, "; ".join(sorted(told)))


def _together(fronts: Sequence[str], asked: Mapping[str, float]) -> list[list[str]]:
    """The quantities asked for, grouped by the keys that their settings set."""
    groups: dict[tuple[str, ...], list[str]] = {}
    for name in asked:
        groups.setdefault(rows_for(fronts, [name])[0].keys, []).append(name)
    return list(groups.values())


def _by_settings(fronts: Sequence[str], names: Collection[str]) -> list[Rows]:
    """The rows of every setting that was measured for all of the quantities."""
    groups: dict[str, dict[str, list[FrontPoint]]] = {}
    for row in rows_for(fronts, names):
        groups.setdefault(row.settings, {}).setdefault(row.quantity, []).append(row)
    return [by for by in groups.values() if len(by) == len(names)]


def cheapest(
    fronts: Sequence[str], asked: Mapping[str, float], scenes: Sequence[Traits]
) -> tuple[FrontPoint, dict[str, float]]:
    """A row of the cheapest settings that reach it, and the worst error expected by quantity."""
    tried = [(by, worst(by, scenes)) for by in _by_settings(fronts, asked)]
    measured = [(by, errors) for by, errors in tried if errors is not None]
    if not measured:
        rows = [row for by, _ in tried for all_of in by.values() for row in all_of]
        raise BadInput("accuracy", dict(asked), f"was measured on no such scene: {_outside(rows, scenes)}")
    reached = [(by, errors) for by, errors in measured if all(errors[name] <= asked[name] for name in asked)]
    if not reached:
        least = {name: float(f"{min(errors[name] for _, errors in measured):.3g}") for name in asked}
        raise BadInput("accuracy", dict(asked), f"no measured setting reaches it; the least errors are {least}")
    by, errors = min(reached, key=lambda group: max(row.cost for all_of in group[0].values() for row in all_of))
    return next(iter(by.values()))[0], errors


def _outside(rows: Sequence[FrontPoint], scenes: Sequence[Traits]) -> str:
    """Traits of the scenes that lie outside all ranges, with their values."""
    ranges: dict[str, dict[tuple[float, float], None]] = {}  # in the order of the rows
    for row in rows:
        for name, span in row.within.items():
            ranges.setdefault(name, {})[span] = None
    told = []
    for name, spans in ranges.items():
        beyond = [scene[name] for scene in scenes if not any(low <= scene[name] <= high for low, high in spans)]
        if beyond:
            measured = " or ".join(f"{low:g} to {high:g}" for low, high in spans)
            told.append(f"{name} {beyond[0]:.3g} (measured {measured}; {TRAITS[name]})")
    return ", ".join(told)


def worst(by: Rows, scenes: Sequence[Traits]) -> dict[str, float] | None:
    """Worst error expected over the scenes, by quantity; None where one of the scenes is like none that was measured."""
    errors = dict.fromkeys(by, 0.0)
    for name, all_of in by.items():
        for scene in scenes:
            holding = [row.expected(scene) for row in all_of if row.holds(scene)]
            if not holding:
                return None
            errors[name] = max(errors[name], *holding)
    return errors
