"""Sizes of grains: a family of distributions that diameters are drawn from."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from silostudy.catalogue import Entry, Family
from silostudy.errors import BadInput
from silostudy.packing.family import PackingField

MM = 1e-3  # m
DRAWS = 1000  # rounds of draws after which a cut-off counts as leaving nothing


@dataclass(frozen=True, kw_only=True)
class Sizes(Entry):
    """Distribution of sizes. draw(random, count, **arguments) -> diameters (mm); asks: fields of a scene's section `sizes`.

    widest: name of the field that bounds the largest diameter.
    """

    draw: Callable[..., np.ndarray]
    asks: tuple[PackingField, ...]
    widest: str = "largest_mm"

    def radii(self, random: np.random.Generator, count: int, section: Any) -> np.ndarray:
        """Radii (m) of so many grains."""
        asked = {field.argument: getattr(section, field.name) for field in self.asks}
        return 0.5 * MM * self.draw(random, count, **asked)


def equal(random, count, *, diameter):
    """Diameters (mm) that are all the same."""
    return np.full(count, float(diameter))


def uniform(random, count, *, least, largest):
    """Diameters (mm), as many of any size between two."""
    _ordered(least, largest)
    return random.uniform(least, largest, count)


def normal(random, count, *, mean, deviation, least, largest):
    """Diameters (mm) of a normal distribution by number, cut off at both ends."""
    return _cut(lambda many: random.normal(mean, deviation, many), count, least, largest)


def lognormal(random, count, *, median, spread, least, largest):
    """Diameters (mm) whose logarithm is normal by number, cut off at both ends; spread: geometric standard deviation (1)."""
    return _cut(lambda many: median * np.exp(np.log(spread) * random.standard_normal(many)), count, least, largest)


def sieved(random, count, *, openings, passing):
    """Diameters (mm) of a sieve curve: the share of mass (1) that passes each opening (mm), even by number between two.

    A class of sizes from a to b has numbers by its share of mass over its mean cube (b^4 - a^4)/(4 (b - a)).
    """
    edges, share = np.asarray(openings, float), np.asarray(passing, float)
    if len(edges) < 2 or len(edges) != len(share) or (np.diff(edges) <= 0.0).any() or edges[0] <= 0.0:
        raise BadInput("sizes.openings_mm", tuple(openings), "must rise from above 0, as many as in passing, two or more")
    if share[0] != 0.0 or share[-1] != 1.0 or (np.diff(share) < 0.0).any():
        raise BadInput("sizes.passing", tuple(passing), "must rise from 0 at the smallest opening to 1 at the largest")
    low, high = edges[:-1], edges[1:]
    numbers = np.diff(share) / ((high**4 - low**4) / (4.0 * (high - low)))
    which = random.choice(len(low), count, p=numbers / numbers.sum())
    return random.uniform(low[which], high[which])


def _ordered(least: float, largest: float) -> None:
    if not least <= largest:
        raise BadInput("sizes.largest_mm", largest, f"must not be below least_mm, {least:g}")


def _cut(draw: Callable[[int], np.ndarray], count: int, least: float, largest: float) -> np.ndarray:
    """Draws that lie between two ends, as many as asked for."""
    _ordered(least, largest)
    radii = np.empty(0)
    for _ in range(DRAWS):
        drawn = draw(count)
        radii = np.append(radii, drawn[(drawn >= least) & (drawn <= largest)])
        if len(radii) >= count:
            return radii[:count]
    raise BadInput("sizes.least_mm", least, f"next to nothing of this distribution lies between it and {largest:g} mm")


def _mm(name: str, text: str, **bounds: float) -> PackingField:
    return PackingField(name=f"{name}_mm", argument=name, text=text, unit="mm", bounds={"gt": 0} | bounds)


_ENDS = (_mm("least", "smallest diameter"), _mm("largest", "largest diameter"))
SIZES: Family[Sizes] = Family(
    "sizes",
    [
        Sizes(key="equal", title="All of one size", draw=equal, asks=(_mm("diameter", "diameter"),), widest="diameter_mm"),
        Sizes(key="uniform", title="As many of any size between two", draw=uniform, asks=_ENDS),
        Sizes(
            key="normal",
            title="Normal by number, cut off at both ends",
            draw=normal,
            asks=(_mm("mean", "mean diameter"), _mm("deviation", "standard deviation"), *_ENDS),
        ),
        Sizes(
            key="lognormal",
            title="Logarithm normal by number, cut off at both ends",
            draw=lognormal,
            asks=(
                _mm("median", "median diameter"),
                PackingField(name="spread", argument="spread", text="geometric standard deviation", bounds={"gt": 1}),
                *_ENDS,
            ),
        ),
        Sizes(
            key="sieve",
            title="Sieve curve: shares of mass by size",
            draw=sieved,
            widest="openings_mm",
            asks=(
                PackingField(
                    name="openings_mm", argument="openings", text="openings, rising", unit="mm", kind=tuple[float, ...]
                ),
                PackingField(
                    name="passing",
                    argument="passing",
                    text="share of mass that passes each, from 0 to 1; between two openings sizes are even by number",
                    kind=tuple[float, ...],
                ),
            ),
        ),
    ],
)
