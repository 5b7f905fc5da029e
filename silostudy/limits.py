"""Limits of a method's range, each said once: the mask, the words of `explain` and the tests all follow from it."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from inspect import signature
from math import inf

import numpy as np

INSIDE = "within all limits"  # what a cube says where no limit is broken
ROUNDING = 1e-12  # relative: how far beyond a closed end still counts as on it


@dataclass(frozen=True)
class Measure:
    """A number that limits are set on: its symbol, its SI unit, and function([z,] *, parameters) that gives it."""

    symbol: str
    unit: str
    of: Callable

    def value(self, z, parameters: Mapping) -> np.ndarray:
        """The number in SI; a measure of the depth asks for z (m)."""
        names = signature(self.of).parameters
        handed = {name: parameters[name] for name in names if name != "z"}
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            return np.asarray(self.of(z, **handed) if "z" in names else self.of(**handed), dtype=float)

    @property
    def of_depth(self) -> bool:
        """Whether it is a number of each depth."""
        return "z" in signature(self.of).parameters


@dataclass(frozen=True, kw_only=True)
class Limit:
    """Limit of a method's range: least <= measure <= most, above < measure < below, and not within the open gap.

    why: whose limit it is; phases and quantities: where it holds, empty everywhere; part: the quantities in one word;
    tolerance: relative, of the closed ends.
    """

    measure: Measure
    why: str
    least: float = -inf
    most: float = inf
    above: float = -inf
    below: float = inf
    gap: tuple[float, float] = (inf, inf)
    phases: tuple[str, ...] = ()
    quantities: tuple[str, ...] = ()
    part: str = ""
    tolerance: float = ROUNDING

    def holds_for(self, quantity: str, phase: str) -> bool:
        """Whether the limit concerns a quantity in a phase."""
        return (not self.phases or phase in self.phases) and (not self.quantities or quantity in self.quantities)

    def broken(self, z, parameters: Mapping) -> np.ndarray:
        """Mask of places where the measure lies beyond the limit; a number that is not known breaks none."""
        value = self.measure.value(z, parameters)
        least, most = self.least - self.tolerance * abs(self.least), self.most + self.tolerance * abs(self.most)
        with np.errstate(invalid="ignore"):
            inside = (value >= least) & (value <= most) & (value > self.above) & (value < self.below)
            return ~inside & ~np.isnan(value) | (value > self.gap[0]) & (value < self.gap[1])

    def words(self) -> str:
        """The limit in words, with where it holds and whose it is."""
        where = ", ".join((*self.phases, *((self.part,) if self.part else self.quantities)))
        return f"{where + ': ' if where else ''}{self.range_words()} ({self.why})"

    def range_words(self) -> str:
        """The limit itself: symbol, ends, unit."""
        signs = ((self.least, ">="), (self.above, ">"), (self.most, "<="), (self.below, "<"))
        ends = [f"{sign} {self._end(end)}" for end, sign in signs if np.isfinite(end)]
        if self.least == self.most:
            ends = [f"= {self._end(self.least)}"]
        if np.isfinite(self.gap[0]):
            ends.append(f"not between {self._end(self.gap[0])} and {self._end(self.gap[1])}")
        return f"{self.measure.symbol} {' and '.join(ends)}"

    def _end(self, end: float) -> str:
        return f"{end:.6g}" + ("" if self.measure.unit == "1" else f" {self.measure.unit}")


def broken(limits: Iterable[Limit], quantity: str, phase: str, z, parameters: Mapping) -> np.ndarray:
    """Mask of places where a limit of a quantity in a phase is broken; without a place (z None) those of depth are left out."""
    outside = np.zeros((), dtype=bool)
    for limit in limits:
        if limit.holds_for(quantity, phase) and not (z is None and limit.measure.of_depth):
            outside = outside | limit.broken(z, parameters)
    return outside
