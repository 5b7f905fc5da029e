"""Measures the fronts behind `accuracy:`, and how their choices do on other scenes: by fronts_KIND, one for each kind.

Each offers measured_fronts(tell) -> rows of tables/fronts.csv, and trials(tell) -> trials of the shipped rows.
"""

from collections.abc import Callable, Iterable
from importlib import import_module
from importlib.util import find_spec

from threadpoolctl import threadpool_limits

from silostudy.accuracy.measure import machine
from silostudy.accuracy.trial import Trial
from silostudy.choice.fronts import COLUMNS
from silostudy.stages import FILE_KINDS

KINDS = tuple(kind for kind in FILE_KINDS if find_spec(f"{__package__}.fronts_{kind}"))  # whose errors are measured


@threadpool_limits.wrap(limits=1)  # threads of the linear algebra that wait for each other spend CPU time
def measured_fronts(tell: Callable[[str], None], kinds: Iterable[str] = KINDS) -> list[dict]:
    """Rows of tables/fronts.csv, measured here and now."""
    about = {name: machine()[name] for name in ("machine", "measured_on")}
    rows = [row for kind in kinds for row in _of(kind).measured_fronts(tell)]
    return [{name: (row | about)[name] for name in COLUMNS} for row in rows]


@threadpool_limits.wrap(limits=1)
def trials(tell: Callable[[str], None], kinds: Iterable[str] = KINDS) -> list[Trial]:
    """Trials of the shipped fronts' choices on scenes that they were not measured on."""
    return [trial for kind in kinds for trial in _of(kind).trials(tell)]


def _of(kind: str):
    return import_module(f"silostudy.accuracy.fronts_{kind}")
