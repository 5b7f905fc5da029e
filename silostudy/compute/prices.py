"""What each effect of a scene costs: measured by timing a step with it and without it, in turn."""

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from silostudy.dem.engine import Engine
from silostudy.dem.kernel import Laws
from silostudy.dem.model import Contact, Model

TURNS, SECONDS = 5, 0.05  # turns of each variant, and how long one lasts at least


def without(model: Model) -> dict[str, Model]:
    """The model without one effect at a time, for those that it has."""
    found = {}
    if model.pieces.turns:
        found["friction, rotation, history"] = replace(model, pair=_bare(model.pair), wall=_bare(model.wall))
    if model.pair.laws.rolling != "none":
        found["rolling resistance"] = replace(model, pair=_less(model.pair, rolling="none"), wall=_less(model.wall, rolling="none"))
    if model.pair.laws.cohesion != "none":
        found["cohesion"] = replace(model, pair=_less(model.pair, cohesion="none"), wall=_less(model.wall, cohesion="none"))
    if model.unequal:
        found["discs of several sizes"] = replace(model, radius=np.full(len(model.x), model.radius.min()))
    if model.quake is not None:
        found["shaking"] = replace(model, quake=None)
    if model.watched:
        found["wall forces every step"] = replace(model, watched=False)
    if model.booked:
        found["energy ledger"] = replace(model, booked=False)
    return found


def _less(contact: Contact, **laws: str) -> Contact:
    fewer = replace(contact.laws, **laws)
    names = {name for row in Contact.families(fewer) for name in row.coefficients}
    return Contact(fewer, {name: value for name, value in contact.coefficients.items() if name in names})


def _bare(contact: Contact) -> Contact:
    return _less(contact, tangential="none", rolling="none")


def prices(model: Model) -> tuple[float, dict[str, float]]:
    """Seconds of a step of the whole model, and each effect's share of it (negative: within the noise)."""
    variants = {"": model} | without(model)
    steppers: dict[str, Callable[[int], None]] = {}
    engines = {name: Engine(variant) for name, variant in variants.items()}
    for name, engine in engines.items():
        engine.step_to(200)
        steppers[name] = lambda steps, engine=engine: engine.step_to(engine.step + steps)
    many = _enough(steppers[""])
    times: dict[str, list[float]] = {name: [] for name in variants}
    for _ in range(TURNS):
        for name, step in steppers.items():
            times[name].append(_seconds(step, many) / many)
    cost = {name: sorted(found)[TURNS // 2] for name, found in times.items()}
    whole = cost.pop("")
    return whole, {name: 1.0 - part / whole for name, part in cost.items()}


def _seconds(step: Callable[[int], None], many: int) -> float:
    start = time.perf_counter()
    step(many)
    return time.perf_counter() - start


def _enough(step: Callable[[int], None]) -> int:
    many = 50
    while _seconds(step, many) < SECONDS and many < 100_000:
        many *= 2
    return many
