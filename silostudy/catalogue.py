"""The one registry: a family of methods is a mapping from keys to rows."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Generic, TypeVar

from silostudy.errors import BadInput, unknown


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One member of a family: its key, and a title for people."""

    key: str
    title: str


@dataclass(frozen=True, kw_only=True)
class Row(Entry):
    """A member of a family that a source defines."""

    source: str  # a key of tables/references.bib
    locator: str  # chapter, equation, table or figure in that source


R = TypeVar("R", bound=Entry)


class Family(Mapping[str, R], Generic[R]):
    """Rows by key, in the order given.  An unknown key raises BadInput and lists the known ones."""

    def __init__(self, name: str, rows: Iterable[R]):
        self.name = name
        self._rows: dict[str, R] = {}
        for row in rows:
            if row.key in self._rows:
                raise BadInput(name, row.key, "this key is already taken by another row")
            self._rows[row.key] = row

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
