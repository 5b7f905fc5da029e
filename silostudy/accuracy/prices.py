"""Cost of each effect of a scene in time and memory: the same discs at the same places, stepped with it and without it.

A packing without friction soon is another packing, so the discs are first brought near rest with every effect on, and the
steps that are timed are so short that nothing moves: contacts, lists and forces are those of one state throughout.
"""

import time
from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import chain
from typing import Any, TypeAlias

import numpy as np

from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model
from silostudy.dem.pace import FIXED
from silostudy.dem.pieces import Laws
from silostudy.dem.varied import Varied

TURNS = 15  # readings of each variant
READING = 0.02  # CPU seconds that a reading lasts about
SETTLING = 4e7  # particle-steps in which a loose lattice of spheres falls together: a second or two
SHORT = 1e-12  # s: a step in which nothing moves
APART = 1e-9  # relative difference of radii that makes discs of several sizes of equal ones
FRICTION = "friction, rotation, history"
LAW_EFFECTS = {"rolling": "rolling resistance", "cohesion": "cohesion", "twisting": "twisting resistance"}  # by family
Pair: TypeAlias = tuple[Model, Model]  # with an effect and without it


@dataclass(frozen=True)
class Price:
    """Share of a step's CPU time and of the engine's memory: median over the turns, and quartiles."""

    time: float
    low: float
    high: float
    memory: float


def without(model: Model) -> dict[str, Pair]:
    """Pairs of models with and without one effect, for the effects that a model has; both of the same places."""
    measured, (pair, wall) = {}, (model.between(0, 0), model.at_wall(0, 0))
    if model.pieces.turns:
        measured[FRICTION] = (model, replace(model, pair_contact=_bare(pair), wall_contact=_bare(wall)))
    for family, name in LAW_EFFECTS.items():
        if getattr(model.pair_contact.laws, family).acts:
            measured[name] = (model, replace(model, pair_contact=_less(pair, family), wall_contact=_less(wall, family)))
    if isinstance(model.wall_contact, Varied):
        measured["walls of several coefficients"] = (model, replace(model, wall_contact=wall))
    if isinstance(model.pair_contact, Varied):
        alike = replace(model, kind=None, pair_contact=pair, wall_contact=wall)
        measured[f"several kinds of {model.space.body}s"] = (model, alike)
    if model.unequal:
        equal = np.full(len(model.x), model.radius.mean())
        hardly = equal * (1.0 + APART * (np.arange(len(equal)) % 2))
        measured[f"{model.space.body}s of several sizes"] = (replace(model, radius=hardly), replace(model, radius=equal))
    if model.quake is not None:
        measured["shaking"] = (model, replace(model, quake=None))
    if model.watched:
        measured["wall forces every step"] = (model, replace(model, watched=False))
    if model.moving:
        measured["walls that move"] = (model, replace(model, moving=False))
    if model.booked:
        measured["energy balance"] = (model, replace(model, booked=False))
    return measured


def _less(contact: Contact, *families: str) -> Contact:
    fewer = replace(contact.laws, **{family: getattr(Laws(), family) for family in families})
    return Contact.taking(fewer, contact.coefficients)


def _bare(contact: Contact) -> Contact:
    return _less(contact, "tangential", "rolling", "twisting")


def still(model: Model) -> Model:
    """The model near rest, with a step in which nothing moves, and which stays."""
    model = replace(model, dt=model.step, pace=FIXED)
    engine = Engine(replace(model, booked=False))
    engine.step_to(max(1, int(SETTLING / len(model.x))))
    columns = model.columns
    moved: dict[str, Any] = dict(zip(columns, engine.places.T, strict=False))
    moved |= dict.fromkeys(columns[model.space.ways + 1 :])  # which are speeds
    return replace(model, **moved, dt=SHORT)


def price_of_step(model: Model, turns: int = TURNS) -> tuple[float, float]:
    """CPU seconds and bytes of memory of a body in a step of a model, near rest."""
    engine = Engine(still(model))
    steps = _steps(engine)
    readings = [_seconds_a_step(engine, steps) for _ in range(turns)]
    return float(np.median(readings)) / engine.n, engine.nbytes / engine.n


def prices(model: Model, turns: int = TURNS) -> tuple[float, dict[str, Price]]:
    """CPU seconds of a step of the whole model, and the price of each of its effects."""
    model = still(model)
    pairs = without(model)
    stepped = _stepped((model, *chain(*pairs.values())), turns)
    return float(np.median(stepped[id(model)][0])), _compared(pairs, stepped)


def prices_of(pairs: dict[str, Pair], turns: int = TURNS) -> dict[str, Price]:
    """Price of each effect from models near rest with it and without it."""
    return _compared(pairs, _stepped(chain(*pairs.values()), turns))


def _stepped(models: Iterable[Model], turns: int) -> dict[int, tuple[list[float], int]]:
    """CPU seconds of a step in every turn, and memory (bytes), of each model by its id; all are read in turn."""
    engines = {id(model): Engine(model) for model in models}
    steps = {key: _steps(engine) for key, engine in engines.items()}
    readings: dict[int, list[float]] = {key: [] for key in engines}
    for _ in range(turns):
        for key, engine in engines.items():
            readings[key].append(_seconds_a_step(engine, steps[key]))
    return {key: (readings[key], engine.nbytes) for key, engine in engines.items()}


def _compared(pairs: dict[str, Pair], stepped: dict[int, tuple[list[float], int]]) -> dict[str, Price]:
    compared = {}
    for name, (whole, less) in pairs.items():
        (seconds, memory), (seconds_less, memory_less) = stepped[id(whole)], stepped[id(less)]
        compared[name] = price(seconds, seconds_less, 1.0 - memory_less / memory)
    return compared


def price(whole: Iterable[float], less: Iterable[float], memory: float) -> Price:
    """The price from readings with and without, taken in turn."""
    share = 1.0 - np.array(list(less)) / np.array(list(whole))
    low, middle, high = np.quantile(share, (0.25, 0.5, 0.75))
    return Price(float(middle), float(low), float(high), memory)


def _steps(engine: Engine) -> int:
    """Steps of a reading, from a first look; the kernel is compiled before it."""
    engine.step_to(1)
    return max(10, int(READING / max(1e-7, _seconds_a_step(engine, 50))))


def _seconds_a_step(engine: Engine, steps: int) -> float:
    start = time.process_time()
    engine.step_to(engine.step + steps)
    return (time.process_time() - start) / steps
