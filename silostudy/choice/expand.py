"""Expands a study into its cases with every setting chosen: the one way from a study's file to what is computed.

A study that asks for no accuracy does not hang on the measured fronts: what chooses is imported when it is asked for.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from silostudy.choice.promise import Choice, promises
from silostudy.scene.expand import Expansion, as_asked, file_as_asked


@dataclass(frozen=True)
class Resolved(Expansion):
    """An expansion whose study and scenes have the settings chosen for the accuracy that they ask for, and the choices."""

    choices: tuple[Choice, ...] = ()

    @property
    def promise(self) -> dict[str, str]:
        """Attributes for a cube: what was asked, what was chosen for it, and the error expected; empty where nothing was."""
        return promises(self.choices)


def expand_file(path: Path, positions: Sequence[int] | None = None) -> Resolved:
    """The cases of a study file, or those at some positions; BadInput names file, key, value and what is allowed."""
    return resolved(file_as_asked(path, positions), str(path))


def expand(content: dict[str, Any], name: str, where: str, folder: Path, positions: Sequence[int] | None = None) -> Resolved:
    """The cases of a study's content; `where` names it in errors, and files it names are looked for in `folder`."""
    return resolved(as_asked(content, name, where, folder, positions), where)


def resolved(expansion: Expansion, where: str) -> Resolved:
    """The expansion with its settings chosen; BadInput where no measured settings reach what is asked."""
    whole = Resolved(expansion.study, expansion.name, expansion.shape, expansion.cases, expansion.named)
    if not expansion.asks:
        return whole
    study, cases, choices = resolve_name("silostudy.choice.settle:settled_study")(expansion, where)
    return replace(whole, study=study, cases=cases, choices=choices)
