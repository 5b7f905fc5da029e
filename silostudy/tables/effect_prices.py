"""Measured prices of effects of the engine and of optional parts, by name."""

from dataclasses import dataclass
from math import nan

from silostudy.tables.read import HERE, rows

TEXT = ("effect", "room", "uncounted")


@dataclass(frozen=True)
class ListedPrice:
    """Shares (1) of CPU time, of instructions (NaN: not counted) and of memory that go without the effect."""

    room: str
    time: float
    instructions: float
    memory: float


EFFECT_PRICES = {
    raw["effect"]: ListedPrice(raw["room"], raw["time_share"], raw.get("instruction_share", nan), raw["memory_share"])
    for raw in rows(HERE / "effect_prices.csv", text=TEXT)
}
