"""Codes that are timed beside each other, each in a process of its own: several in one process slow each other down."""

import time
from collections.abc import Callable
from multiprocessing import get_context
from multiprocessing.connection import Connection
from typing import Any


class OwnProcess:
    """A code, made by a function of a module and its arguments, in a process of its own; its names are called there."""

    def __init__(self, make: Callable, *args):
        self.pipe, theirs = get_context("spawn").Pipe()
        self.process = get_context("spawn").Process(target=_serve, args=(theirs, make, args), daemon=True)
        self.process.start()
        theirs.close()
        self._answer()

    def call(self, name: str, *args) -> tuple[Any, float]:
        """Result of a method or property, and the CPU time (s) that it took."""
        self.pipe.send((name, args))
        return self._answer()

    def _answer(self) -> tuple[Any, float]:
        value, seconds = self.pipe.recv()
        if isinstance(value, Exception):
            raise value
        return value, seconds

    def get(self, name: str) -> Any:
        """A property of the code."""
        return self.call(name)[0]

    @property
    def grains(self) -> int:
        return self.get("grains")

    def step(self, steps: int) -> float:
        """Step the code; gives the CPU time (s) of all threads of its process."""
        return self.call("step", steps)[1]

    def close(self) -> None:
        self.pipe.close()
        self.process.join()


def _serve(pipe: Connection, make: Callable, args: tuple) -> None:
    try:
        code = make(*args)
        pipe.send((None, 0.0))
    except Exception as error:
        pipe.send((error, 0.0))
        return
    while True:
        try:
            name, given = pipe.recv()
        except EOFError:
            return
        start = time.process_time()
        try:
            value = getattr(code, name)
            value = value(*given) if callable(value) else value
        except Exception as error:
            value = error
        pipe.send((value, time.process_time() - start))
