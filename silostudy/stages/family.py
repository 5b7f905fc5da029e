"""Declarations of kinds of study and of stages; functions are named `module:name` and loaded when asked for."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pkgutil import resolve_name
from typing import Any

from silostudy.catalogue import Entry
from silostudy.stamp import stamp


@dataclass(frozen=True, kw_only=True)
class Parts:
    """Functions of a stage whose costly cases are computed in parts and merged.

    measure(study, scene) -> numbers by variable; coordinates(study) -> the dimensions of their own; sources(study) ->
    references; cost(scene) -> seconds.
    """

    measure: str
    coordinates: str
    sources: str
    cost: str

    def call(self, name: str, *arguments: Any) -> Any:
        """Result of one of the four functions."""
        return resolve_name(getattr(self, name))(*arguments)

    @property
    def stamp(self) -> str:
        """Hash of the sources that compute a case."""
        return stamp(place_of(self.measure))


@dataclass(frozen=True, kw_only=True)
class Stage(Entry):
    """One cube of a study: results/<study>/<key>.nc, made by the sub-command of that name.

    compute: function of the expansion and the cubes it reads (of the expansion and a way to tell its progress, where `tells`)
    section: key of the study without which the stage is not called for; none: it always is
    reads: stages of the same study whose cubes it takes; borrows: section of the study that names another study -> the
    stage of that other study whose cube it takes
    alone: whether it takes all cores of the pipeline; threads: else how many
    rooms: further rooms or files that its numbers come from, besides what `compute` imports
    """

    compute: str = ""
    tells: bool = False
    parts: Parts | None = None
    section: str = ""
    reads: tuple[str, ...] = ()
    borrows: Mapping[str, str] = field(default_factory=dict, hash=False)
    threads: int = 1
    alone: bool = False
    rooms: tuple[str, ...] = ()

    @property
    def references(self) -> tuple[str, ...]:
        """The functions that this row names."""
        return tuple(vars(self.parts).values()) if self.parts else (self.compute,)

    def cube(self, expansion: Any, tell: Any, cubes: tuple) -> Any:
        """The cube of an expanded study, from the cubes that the stage reads and borrows (None where none is borrowed)."""
        return resolve_name(self.compute)(expansion, *([tell] if self.tells else []), *cubes)


@dataclass(frozen=True, kw_only=True)
class Kind(Entry):
    """A kind of study: what the key `kind` of a file says.

    model: the configuration; builder(study, folder, where) -> build(configuration, settings) -> scene, frozen; none: the
    file is no study with cases but a single scene
    variants: further configurations that files of the kind may hold, as one of their keys says
    traits(asking, scenes): what its errors hang on, for a kind that may ask for an accuracy, or whose scenes may
    about: functions of an expansion that give the lines which `silostudy check` says of it; timed: further ones, which
    measure something first; seconds: function of an expansion that gives about its computing time (s)
    table: function of an expansion without sweep that gives the lines which `silostudy compare` prints of it
    """

    model: str
    builder: str = ""
    stages: tuple[Stage, ...]
    traits: str = ""
    about: tuple[str, ...] = ()
    timed: tuple[str, ...] = ()
    seconds: str = ""
    table: str = ""
    variants: tuple[str, ...] = ()

    @cached_property
    def parts(self) -> Parts | None:
        """Functions of a kind whose cases are computed in parts."""
        return next((stage.parts for stage in self.stages if stage.parts), None)

    @cached_property
    def study(self) -> Any:
        """The configuration model of a study file."""
        return resolve_name(self.model)

    @cached_property
    def models(self) -> tuple[Any, ...]:
        """All configuration models of its files."""
        return (self.study, *map(resolve_name, self.variants))

    def scene_builder(self, study: Any, folder: Any, where: str) -> Any:
        """The function that builds the scenes of a study."""
        return resolve_name(self.builder)(study, folder, where)

    def stamp(self, stage: Stage | None = None) -> str:
        """Hash of the sources behind a stage of this kind of study, or behind its cases alone."""
        return stamp(*self.places(stage))

    def places(self, stage: Stage | None = None) -> tuple[str, ...]:
        """The files and rooms at which the work of a stage begins."""
        named = (self.model, *self.variants, self.builder, self.traits, *(stage.references if stage else ()))
        files = tuple(place_of(reference) for reference in named if reference)
        chosen = ["choice/settle"] if self.traits else []
        return (*(["choice/expand"] if self.builder else []), *chosen, *files, *(stage.rooms if stage else ()))


def place_of(reference: str) -> str:
    """The file in the package that holds what `module:name` names."""
    return reference.partition(":")[0].partition(".")[2].replace(".", "/")
