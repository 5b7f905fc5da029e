"""Observers: what is read of a run every so many steps without a bit of it changing, each off unless asked for."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Observer:
    """read(engine) -> a tuple of arrays or numbers, at every multiple of so many steps, as soon as a body is there."""

    name: str
    every: int
    read: Callable[[Any], tuple]

    def due(self, step: int) -> bool:
        """Whether it reads at a step."""
        return step % self.every == 0

    def after(self, step: int) -> int:
        """The next step at which it reads."""
        return (step // self.every + 1) * self.every
