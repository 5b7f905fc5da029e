"""Prices of effects and of optional parts: engines with each effect and without it, stages with and without a part."""

from collections.abc import Callable
from math import nan

import numpy as np

from silostudy.accuracy import optional_discs, optional_formulas, optional_spheres
from silostudy.accuracy.instructions import count, missing
from silostudy.accuracy.optional_parts import part_price
from silostudy.accuracy.priced_effects import SPHERES, priced_effects
from silostudy.accuracy.prices import Price, prices_of
from silostudy.dem.engine import Engine

COUNTED = (*optional_discs.SCENES, *optional_spheres.PARTS)  # parts whose instructions are counted
PARTS = (*optional_discs.PARTS, *optional_spheres.PARTS, *optional_formulas.PARTS)
STEPS = 500  # whose instructions are counted
ROOMS = {False: "discs", True: "spheres"}  # of the effects of the engine
UNCOUNTED = "not counted"  # what is said of other parts


def counted_work() -> dict[str, Callable[[], object]]:
    """Steps with each effect and without it, and optional parts of grains, for the counter of instructions."""
    measured: dict[str, Callable[[], object]] = {}
    for name, (whole, less) in priced_effects().items():
        measured |= {f"with {name}": _steps(Engine(whole)), f"without {name}": _steps(Engine(less))}
    for part in COUNTED:
        measured |= {f"with {part.name}": part.whole(), f"without {part.name}": part.less()}
    return measured


def _steps(engine: Engine) -> Callable[[], None]:
    return lambda: engine.step_to(engine.step + STEPS)


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
    effects = prices_of(priced_effects())
    rows: dict[str, tuple[str, Price]] = {name: (ROOMS[name.endswith(SPHERES)], measured) for name, measured in effects.items()}
    tell(f"prices: {', '.join(rows)}")
    shares, uncounted = instruction_shares()
    tell(f"instructions: {uncounted or 'counted'}")
    for part in PARTS:
        rows[part.name] = (part.room, part_price(part, repeats))
        tell(f"price of {part.name}: {rows[part.name][1].time:.0%}")
    listed, others = [price for _, price in rows.values()], {part.name for part in PARTS if part not in COUNTED}
    return {
        "effect": np.array(list(rows)),
        "effect_room": np.array([room for room, _ in rows.values()]),
        "effect_time_share": np.array([price.time for price in listed]),
        "effect_time_share_low": np.array([price.low for price in listed]),
        "effect_time_share_high": np.array([price.high for price in listed]),
        "effect_instruction_share": np.array([shares.get(name, nan) for name in rows]),
        "effect_uncounted": np.array([UNCOUNTED if name in others else uncounted for name in rows]),
        "effect_memory_share": np.array([price.memory for price in listed]),
    }
