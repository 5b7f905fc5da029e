"""Expands a study into its cases, as asked: every combination of the axes, each a frozen scene with an id of its own.

What is computed comes from choice/expand.py, where settings are chosen for an accuracy that is asked for.
"""

import copy
import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any

from silostudy.config.fields import Strict
from silostudy.config.load import Mistakes, own_validated, read_yaml, study_of
from silostudy.config.mistakes import WHOLE
from silostudy.config.sample import SampledRange
from silostudy.errors import BadInput
from silostudy.stages import KINDS

MOST = 1_000_000  # cases of a study


@dataclass(frozen=True)
class Case:
    """One scene of a study: a short hash of its canonical JSON, what its axes set, and the scene itself."""

    id: str
    settings: dict[str, Any]
    scene: Any


@dataclass(frozen=True)
class Expansion:
    """A study with its cases in the order of the axes (last axis fastest); shape holds the axes' lengths."""

    study: Any  # a study of the kind that its `kind` names
    name: str
    shape: tuple[int, ...]
    cases: tuple[Case, ...]
    named: tuple[Path, ...] = ()  # files of the user's own that the study itself names

    @property
    def size(self) -> int:
        """Cases of the whole study, also where only some are here."""
        return prod(self.shape)

    @property
    def files(self) -> tuple[Path, ...]:
        """The user's own files that study and scenes were made from."""
        of_scenes = (file for case in self.cases for file in getattr(case.scene, "files", ()))
        return tuple(dict.fromkeys((*self.named, *of_scenes)))

    @property
    def asks(self) -> bool:
        """Whether the study, its scene or an axis asks for an accuracy in place of settings."""
        swept = {key.split(".")[0] for axis in self.study.sweep for key in axis.settings()[0]}
        return "accuracy" in swept or any(getattr(asking, "accuracy", None) for asking in (self.study, self.study.scene))


def file_as_asked(path: Path, positions: Sequence[int] | None = None) -> Expansion:
    """The cases of a study file as asked, or those at some positions; BadInput names file, key, value and what is allowed."""
    return as_asked(read_yaml(path), path.stem, str(path), path.parent, positions)


def as_asked(content: dict[str, Any], name: str, where: str, folder: Path, positions: Sequence[int] | None = None) -> Expansion:
    """The cases of a study's content; `where` names it in errors, and files it names are looked for in `folder`."""
    study: Any = study_of(content, where, folder)
    build = KINDS[study.kind].scene_builder(study, folder, where)
    cases, axes = [], [axis.settings() for axis in study.sweep]
    shape = tuple(map(len, axes))
    if prod(shape) > MOST:
        raise BadInput("sweep", prod(shape), f"makes more cases than a study may have, {MOST:,}", where)
    for position in range(prod(shape)) if positions is None else positions:
        settings = _settings_at(axes, position, where)
        try:
            config = own_validated(type(study.scene), _applied(content["scene"], settings, where), f"{where} (scene)", folder)
        except Mistakes as mistakes:
            raise Mistakes([_of_sample(line, study) for line in mistakes.lines]) from None
        cases.append(Case(identity(config), settings, build(config, settings)))
    return Expansion(study, name, shape, tuple(cases), study.named_files(folder))


def _settings_at(axes: list[list[dict[str, Any]]], position: int, where: str) -> dict[str, Any]:
    """Settings of the axes at a position, counted with the last axis fastest."""
    parts: list[dict[str, Any]] = []
    left = position
    for axis in reversed(axes):
        left, place = divmod(left, len(axis))
        parts.append(axis[place])
    if left:
        raise BadInput("position", position, "is beyond the cases of the study", where)
    return {key: value for part in reversed(parts) for key, value in part.items()}


def _of_sample(line: str, study: Any) -> str:
    """A mistake in a case; where a sampled range gave a fraction to a key of whole numbers, with what to write instead."""
    ranges = {key: values for axis in study.sweep if axis.sample for key, values in axis.sample.ranges.items()}
    drawn = [key for key, values in ranges.items() if isinstance(values, SampledRange) and f": {key} = " in line]
    return (
        f"{line}: a sampled range gives fractions, list whole numbers in its place" if drawn and line.endswith(WHOLE) else line
    )


def identity(config: Strict) -> str:
    """Short hash of a scene's canonical JSON."""
    return hashlib.sha256(config.model_dump_json(exclude={"methods_from"}).encode()).hexdigest()[:16]  # known by its content


def _applied(scene: dict[str, Any], settings: dict[str, Any], where: str) -> dict[str, Any]:
    """The raw scene with dotted keys replaced, a number for an entry of a list; one choice of two drops the other."""
    changed = copy.deepcopy(scene)
    for dotted, value in settings.items():
        *parents, last = dotted.split(".")
        node: Any = changed
        for parent in parents:
            node = _within(node, parent)
            if not isinstance(node, dict | list):
                raise BadInput("sweep", dotted, f"{parent} is no group of keys in the scene", where)
        if not isinstance(node, dict):
            raise BadInput("sweep", dotted, f"{last} is no key of the scene: it stands in a list", where)
        node.pop({"slenderness": "cylinder_depth_m", "cylinder_depth_m": "slenderness"}.get(last, ""), None)
        node[last] = value
    return changed


def _within(node: dict | list, key: str) -> Any:
    """Entry of a group of keys, made where there is none, or of a list by its number; None where there is no such entry."""
    if isinstance(node, dict):
        return node.setdefault(key, {})
    return node[int(key)] if key.isdecimal() and int(key) < len(node) else None
