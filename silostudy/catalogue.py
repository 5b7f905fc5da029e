"""The one registry: a family of methods is a mapping from keys to rows, gathered from the modules that hold them."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from pkgutil import iter_modules
from typing import Generic, TypeVar

from silostudy.errors import BadInput, unknown

LAST = 1000  # rank of a row that names none: behind all that do


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One member of a family: its key, and a title for people.

    rank: where it stands among the others, lowest first; members of one rank stand in the order of their modules' names.
    """

    key: str
    title: str
    rank: int = LAST


@dataclass(frozen=True, kw_only=True)
class Row(Entry):
    """A member of a family that a source defines.

    origin: name and hash of the user's own file that it comes from; empty for a row of the package.
    """

    source: str  # a key of tables/references.bib, or a citation in words
    locator: str  # chapter, equation, table or figure in that source
    origin: str = ""

    def faults(self) -> Iterator[str]:
        """Faults of the row, in words: none of a sound one.  A family's own class adds to it."""
        for name in ("key", "title", "source", "locator"):
            text = getattr(self, name)
            if not isinstance(text, str) or not text.strip():
                yield f"{name} = {text!r}: must be a text, and not empty"
        if isinstance(self.key, str) and not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", self.key):
            yield f"key = {self.key!r}: must be of letters, digits, _ and - only"


R = TypeVar("R", bound=Entry)


class Family(Mapping[str, R], Generic[R]):
    """Rows by key, in the order given.  An unknown key raises BadInput and lists the known ones.

    takes: whether a row of a user's own file may join; by default none may.
    """

    def __init__(self, name: str, rows: Iterable[R], takes: Callable[[Row], bool] = lambda row: False):
        self.name, self.takes = name, takes
        self._rows: dict[str, R] = {}
        for row in rows:
            if row.key in self._rows:
                raise BadInput(name, row.key, "this key is already taken by another row")
            self._rows[row.key] = row

    def joined(self, rows: Iterable[R]) -> "Family[R]":
        """A family of these rows and further ones; this one stays as it is."""
        return Family(self.name, [*self.values(), *rows], self.takes)

    def __getitem__(self, key: str) -> R:
        if key not in self._rows:
            raise unknown(self.name, key, self._rows)
        return self._rows[key]

    def __contains__(self, key: object) -> bool:
        return isinstance(key, str) and key in self._rows

    def __iter__(self) -> Iterator[str]:
        return iter(self._rows)

    def __len__(self) -> int:
        return len(self._rows)


def members(room: str, kind: type[R]) -> list[R]:
    """Rows of a kind that the modules of a package declare as ROW or ROWS, by their ranks.

    A module takes part by lying in the folder; `stamp` counts them all behind whatever calls this.
    """
    names = sorted(module.name for module in iter_modules(import_module(room).__path__))
    rows = [row for name in names for row in declared(vars(import_module(f"{room}.{name}"))) if isinstance(row, kind)]
    return sorted(rows, key=lambda row: row.rank)


def declared(module: Mapping[str, object]) -> tuple:
    """Rows under a module's names ROW and ROWS."""
    row, many = module.get("ROW"), module.get("ROWS", ())
    return (*(() if row is None else (row,)), *many)  # type: ignore[misc]
