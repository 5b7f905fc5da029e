"""The row of an effective mass rule: a function and what it needs."""

from collections.abc import Callable
from dataclasses import dataclass

from silostudy.catalogue import Row


@dataclass(frozen=True, kw_only=True)
class MassRule(Row):
    """One way to the share of the contents' mass that an earthquake moves with the wall."""

    function: Callable
    formula: str
    needs: tuple[str, ...]
    validity: str
