"""Prices of effects and of optional parts: the bench's silo with every effect, and stages with and without a part."""

from collections.abc import Callable
from dataclasses import replace
from math import nan

import numpy as np

from silostudy.accuracy import optional_discs, optional_formulas
from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.instructions import count, missing
from silostudy.accuracy.optional_parts import part_price
from silostudy.accuracy.prices import Price, prices, still, without
from silostudy.accuracy.silo import LEVELS, silo_of_rows
from silostudy.contact.cohesion import constant_pull, jkr
from silostudy.contact.rolling import constant_torque, spring_slider
from silostudy.contact.twisting import marshall
from silostudy.dem.engine import Engine
from silostudy.dem.model import Contact, Model
from silostudy.tables.kiyama_1983 import ACTIVE

PARTS = (*optional_discs.PARTS, *optional_formulas.PARTS)
STEPS = 2000  # whose instructions are counted
SPHERES = ", of spheres"
DISCS = "discrete elements"  # stage whose effects have counts
OTHERS = "only effects of discrete elements are counted"  # what is said of the other stages


def full_scenes() -> list[tuple[str, Model]]:
    """Scenes that have between them every effect of the engine; friction is priced where nothing is recorded as well."""
    model, _ = silo_of_rows(ACTIVE, LEVELS)
    rolling = replace(model, pair_contact=_rolling(model.between(0, 0)), wall_contact=_rolling(model.at_wall(0, 0)))
    pulling = replace(model, pair_contact=_pulling(model.between(0, 0)), wall_contact=_pulling(model.at_wall(0, 0)))
    sizes = replace(model, radius=model.radius * (1.0 - 0.002 * (np.arange(len(model.x)) % 2)))
    shaken = replace(model, quake=np.zeros((2, 2)))
    recording = replace(model, watched=True)
    booked = replace(model, booked=True)
    names = ("", "", "", "", "", " (wall forces recorded)", "")
    discs = zip(names, (model, rolling, pulling, sizes, shaken, recording, booked), strict=True)
    return [*discs, *((SPHERES, model) for model in scenes_of_spheres())]


def scenes_of_spheres() -> list[Model]:
    """A bin of spheres with friction, and with each family of laws that may act besides."""
    model = bin_of_spheres(Bin(count=2000, wide=0.03))
    more = {"rolling": constant_torque.ROW, "cohesion": jkr.ROW, "twisting": marshall.ROW}
    values = {"rolling_friction": 0.05, "work_of_adhesion": 1e-3}
    bare = [model, replace(model, watched=True)]
    return [*bare, *(_with_law(model, family, law, values) for family, law in more.items())]


def _with_law(model: Model, family: str, law, values: dict[str, float]) -> Model:
    pair, wall = (
        Contact.taking(replace(contact.laws, **{family: law}), contact.coefficients | values)
        for contact in (model.between(0, 0), model.at_wall(0, 0))
    )
    return replace(model, pair_contact=pair, wall_contact=wall)


def _rolling(contact: Contact) -> Contact:
    more = {"rolling_stiffness": 10.0, "rolling_friction": 0.1}
    return Contact(replace(contact.laws, rolling=spring_slider.ROW), contact.coefficients | more)


def _pulling(contact: Contact) -> Contact:
    return Contact(replace(contact.laws, cohesion=constant_pull.ROW), contact.coefficients | {"pull": 1.0})


def counted_work() -> dict[str, Callable[[], None]]:
    """Steps with each effect and without it, for the counter of instructions."""
    measured: dict[str, Callable[[], None]] = {}
    for note, model in full_scenes():
        for name, pair in without(still(model)).items():
            for end, priced in zip(("with", "without"), pair, strict=True):
                measured.setdefault(f"{end} {_label(name, note)}", _steps(Engine(priced)))
    return measured


def _steps(engine: Engine) -> Callable[[], None]:
    return lambda: engine.step_to(engine.step + STEPS)


def _label(name: str, note: str) -> str:
    return name + (note if note == SPHERES or name.startswith("friction") else "")


def instruction_shares() -> tuple[dict[str, float], str]:
    """Share of a step's instructions by effect, or none and why they cannot be counted here."""
    if missing():
        return {}, missing()
    try:
        counted = count(f"{__name__}:counted_work")
    except RuntimeError as reason:
        return {}, str(reason)
    names = [name.removeprefix("with ") for name in counted if name.startswith("with ")]
    return {name: 1.0 - counted[f"without {name}"] / counted[f"with {name}"] for name in names}, ""


def price_variables(repeats: int, tell: Callable[[str], None]) -> dict[str, np.ndarray]:
    """Columns of the cube's price list by the names of the contract."""
    rows: dict[str, tuple[str, Price]] = {}
    for note, model in full_scenes():
        for name, measured in prices(model)[1].items():
            rows.setdefault(_label(name, note), (DISCS, measured))
        tell(f"prices: {', '.join(rows)}")
    shares, uncounted = instruction_shares()
    tell(f"instructions: {uncounted or 'counted'}")
    for part in PARTS:
        rows[part.name] = (part.room, part_price(part, repeats))
        tell(f"price of {part.name}: {rows[part.name][1].time:.0%}")
    listed = [price for _, price in rows.values()]
    return {
        "effect": np.array(list(rows)),
        "effect_room": np.array([room for room, _ in rows.values()]),
        "effect_time_share": np.array([price.time for price in listed]),
        "effect_time_share_low": np.array([price.low for price in listed]),
        "effect_time_share_high": np.array([price.high for price in listed]),
        "effect_instruction_share": np.array([shares.get(name, nan) for name in rows]),
        "effect_uncounted": np.array([uncounted if room == DISCS else OTHERS for room, _ in rows.values()]),
        "effect_memory_share": np.array([price.memory if price.memory is not None else nan for price in listed]),
    }
