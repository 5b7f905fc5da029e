"""Cost of an optional part of a study: the same study with the part and without it, in turn."""

import copy
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from threadpoolctl import threadpool_limits

from silostudy.accuracy.prices import Price, price
from silostudy.choice.expand import expand

Work = Callable[[], object]


@dataclass(frozen=True)
class OptionalPart:
    """A part of a study of some kind, and what makes ready the work with it and without it."""

    name: str
    room: str
    whole: Callable[[], Work]
    less: Callable[[], Work]


def ready(content: dict, *functions: Callable, folder: Path = Path()) -> Callable[[], Work]:
    """Makes ready the cubes that functions of an expanded study give; files that it names are looked for in `folder`."""

    def prepare() -> Work:
        expansion = expand(copy.deepcopy(content), "part", "part", folder)

        def work() -> None:
            for function in functions:
                function(expansion)

        return work

    return prepare


@threadpool_limits.wrap(limits=1)
def part_price(part: OptionalPart, turns: int) -> Price:
    """Share of CPU time and of the largest memory that goes without the part; readings in turn."""
    whole, less = part.whole(), part.less()
    memory = 1.0 - _memory(less) / _memory(whole)
    readings: tuple[list[float], list[float]] = ([], [])
    for _ in range(turns):
        for work, spent in zip((whole, less), readings, strict=True):
            start = time.process_time()
            work()
            spent.append(time.process_time() - start)
    return price(*readings, memory)


def _memory(work: Work) -> int:
    """Largest memory (bytes) that is held at once beyond what was held before."""
    work()  # what is kept for good is kept before
    tracemalloc.start()
    work()
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return most
