"""What each effect of a scene costs: measured by timing a step with it and without it, in turn."""

import time
from dataclasses import replace

import numpy as np

from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model

TURNS, WARM, STEPS = 9, 50, 300  # turns of each variant, and their steps before and under the watch


def without(model: Model) -> dict[str, Model]:
    """The model without one effect at a time, for those that it has."""
    found = {}
    if model.pieces.turns:
        found["friction, rotation, history"] = replace(model, pair=_bare(model.pair), wall=_bare(model.wall))
    if model.pair.laws.rolling != "none":
        found["rolling resistance"] = replace(
            model, pair=_less(model.pair, rolling="none"), wall=_less(model.wall, rolling="none")
        )
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
    """Seconds of a step of the whole model, and each effect's share of it (below zero: within the noise).

    Every turn starts afresh and is short, because a packing without friction soon is another packing.
    """
    variants = {"": model} | without(model)
    times: dict[str, list[float]] = {name: [] for name in variants}
    for _ in range(TURNS):
        for name, variant in variants.items():
            times[name].append(_seconds_a_step(variant))
    cost = {name: min(found) for name, found in times.items()}
    whole = cost.pop("")
    return whole, {name: 1.0 - part / whole for name, part in cost.items()}


def _seconds_a_step(model: Model) -> float:
    engine = Engine(model)
    engine.step_to(WARM)
    start = time.perf_counter()
    engine.step_to(WARM + STEPS)
    return (time.perf_counter() - start) / STEPS
