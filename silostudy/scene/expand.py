"""Expands a study into its cases, once: every combination of the axes, each a frozen scene with an id of its own."""

import copy
import hashlib
import itertools
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from silostudy.config.fields import expand as listed
from silostudy.config.load import read_yaml, validated
from silostudy.config.scene import SceneConfig
from silostudy.config.study import Study
from silostudy.errors import BadInput
from silostudy.scene.build import build
from silostudy.scene.scene import Scene
from silostudy.tables.solids import SOLIDS, read_solids


@dataclass(frozen=True)
class Case:
    """One scene of a study: a short hash of its canonical JSON, what its axes set, and the scene itself."""

    id: str
    settings: dict[str, Any]
    scene: Scene


@dataclass(frozen=True)
class Expansion:
    """A study with its cases in the order of the axes (last axis fastest); shape holds the axes' lengths."""

    study: Study
    name: str
    shape: tuple[int, ...]
    cases: tuple[Case, ...]

    @property
    def depths(self) -> list[float]:
        """The depth axis: metres, or relative depths."""
        depths = self.study.depth_m if self.study.depth_m is not None else self.study.relative_depth
        assert depths is not None  # the model asks for one of the two
        return listed(depths)


def expand_file(path: Path) -> Expansion:
    """The cases of a study file; BadInput names file, key, value and what is allowed."""
    return expand(read_yaml(path), path.stem, str(path), path.parent)


def expand(content: dict[str, Any], name: str, where: str, folder: Path) -> Expansion:
    """The cases of a study's content; `where` names it in errors, and files it names are looked for in `folder`."""
    study = validated(Study, content, where)
    solids = read_solids(folder / study.materials, SOLIDS) if study.materials else SOLIDS
    cases = []
    for combination in itertools.product(*(axis.settings() for axis in study.sweep)):
        settings = {key: value for part in combination for key, value in part.items()}
        config = validated(SceneConfig, _applied(content["scene"], settings, where), f"{where} (scene)")
        cases.append(Case(_identity(config), settings, build(config, solids, where)))
    expansion = Expansion(study, name, tuple(len(axis.settings()) for axis in study.sweep), tuple(cases))
    _check_depths(expansion, where)
    return expansion


def _identity(config: SceneConfig) -> str:
    return hashlib.sha256(config.model_dump_json().encode()).hexdigest()[:10]


def _applied(scene: dict[str, Any], settings: dict[str, Any], where: str) -> dict[str, Any]:
    """The raw scene with dotted keys replaced; keys that name one choice of two drop the other."""
    changed = copy.deepcopy(scene)
    for dotted, value in settings.items():
        *parents, last = dotted.split(".")
        node = changed
        for parent in parents:
            if not isinstance(node.setdefault(parent, {}), dict):
                raise BadInput("sweep", dotted, f"{parent} is no group of keys in the scene", where)
            node = node[parent]
        node.pop({"slenderness": "cylinder_depth_m", "cylinder_depth_m": "slenderness"}.get(last, ""), None)
        node[last] = value
    return changed


def _check_depths(expansion: Expansion, where: str) -> None:
    if expansion.study.depth_m is None:
        return
    for case in expansion.cases:
        if expansion.depths[-1] > case.scene.silo.cylinder_depth * (1 + 1e-12):
            allowed = f"the transition lies at {case.scene.silo.cylinder_depth:g} m"
            if case.settings:
                allowed += f" in the case {json.dumps(case.settings)}; use relative_depth where heights differ"
            raise BadInput("depth_m", expansion.depths[-1], allowed, where)
