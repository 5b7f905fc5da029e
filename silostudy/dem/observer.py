"""Observers: what is read of a run every so many steps without a bit of it changing, each off unless asked for."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Observer:
    """Reading at every multiple of so many ticks, once a body is there. read(engine) -> a tuple of arrays or numbers."""

    name: str
    every: int
    read: Callable[[Any], tuple]

    def after(self, step: int) -> int:
        """The next tick at which it reads."""
        return after(step, self.every)


def after(step: int, every: int) -> int:
    """The next multiple of so many ticks after one."""
    return (step // every + 1) * every


def read_due(observers: tuple[Observer, ...], engine, before: int, readings: dict[str, list[tuple[float, tuple]]]) -> None:
    """Keep what those observers read that came due after a tick, each with the time (s)."""
    for observer in observers:
        if observer.after(before) <= engine.step and engine.n:
            readings.setdefault(observer.name, []).append((engine.time, observer.read(engine)))
