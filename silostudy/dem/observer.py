"""Observers: what is read of a run every so many steps without a bit of it changing, each off unless asked for."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Observer:
    """Reading at every multiple of so many steps, once a body is there. read(engine) -> a tuple of arrays or numbers."""

    name: str
    every: int
    read: Callable[[Any], tuple]

    def after(self, step: int) -> int:
        """The next step at which it reads."""
        return (step // self.every + 1) * self.every


def read_due(observers: tuple[Observer, ...], engine, readings: dict[str, list[tuple[float, tuple]]]) -> None:
    """Keep what those observers read that are due at the engine's step, each with the time (s)."""
    for observer in observers:
        if engine.step % observer.every == 0 and engine.n:
            readings.setdefault(observer.name, []).append((engine.time, observer.read(engine)))
