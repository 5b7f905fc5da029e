"""A sampled plan of a sweep: few cases that are spread evenly over the ranges of several keys at once."""

from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, model_validator

from silostudy.config.fields import Strict, described

DIGITS = 6  # that a sampled number is rounded to: it is to be read and written again

Choices = Annotated[tuple[Any, ...], Field(min_length=2)]


class SampledRange(Strict):
    """A range of numbers that a plan draws from."""

    start: float = described("least value")
    stop: float = described("largest value")
    spacing: Literal["linear", "log"] = described("linear: even in the value; log: even in its logarithm", default="linear")

    @model_validator(mode="after")
    def _rising(self):
        if not self.start < self.stop:
            raise ValueError(f"start = {self.start:g} must be below stop = {self.stop:g}")
        if self.spacing == "log" and not self.start > 0:
            raise ValueError("spacing log needs start above 0")
        return self

    def drawn(self, share: np.ndarray) -> list[float]:
        """Values at shares (1) of the range."""
        log = self.spacing == "log"
        low, high = np.log([self.start, self.stop]) if log else (self.start, self.stop)
        value = low + share * (high - low)
        rounded = [float(f"{number:.{DIGITS}g}") for number in (np.exp(value) if log else value)]
        return [min(max(number, self.start), self.stop) for number in rounded]


class SampleConfig(Strict):
    """A Latin hypercube: of every key each of `count` equal parts of its range is drawn from once, in an order of its own."""

    count: int = described("cases", ge=2, le=1_000_000)
    seed: int = described("seed of the plan", ge=0, le=2**53, default=0)
    ranges: dict[str, SampledRange | Choices] = described(
        "dotted key of the scene -> range of numbers, or values of which each is taken equally often; two keys at least",
        "",
        min_length=2,
    )

    def settings(self) -> list[dict[str, Any]]:
        """The keys and values of each case."""
        random = np.random.default_rng(self.seed)
        columns = {key: _drawn(values, self._shares(random)) for key, values in self.ranges.items()}
        return [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]

    def _shares(self, random: np.random.Generator) -> np.ndarray:
        """Shares (1) of a range, one in each of `count` equal parts, in random order."""
        return (random.permutation(self.count) + random.uniform(size=self.count)) / self.count


def _drawn(values: SampledRange | tuple[Any, ...], share: np.ndarray) -> list[Any]:
    """Values at shares (1) of a range, or of a list."""
    if isinstance(values, SampledRange):
        return values.drawn(share)
    return [values[number] for number in (share * len(values)).astype(int)]
