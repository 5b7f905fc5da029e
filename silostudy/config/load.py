"""Reads YAML files into models and turns every mistake into one line: file, key, value, what is allowed."""

from collections.abc import Collection, Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeVar

import yaml
from pydantic import BaseModel, ValidationError

from silostudy.config.fields import SECTION, Strict, described
from silostudy.config.mistakes import WORDS, below, message_of
from silostudy.config.own import OwnMethods
from silostudy.config.own_rows import Families, joined
from silostudy.config.places import keys_at
from silostudy.config.retired import RETIRED_KEYS
from silostudy.config.study import BaseStudy
from silostudy.errors import BadInput, unknown
from silostudy.stages import FILE_KINDS, KINDS, borrowed
from silostudy.tables.units import SUFFIXES

M = TypeVar("M", bound=BaseModel)
MANY = 12  # names that are listed in full


class Project(Strict):
    """File config.yaml: which studies and scenes the pipeline builds."""

    studies: tuple[str, ...] = described("names of files in config/studies, without .yaml", "", default=())
    scenes: tuple[str, ...] = described("names of discrete-element scenes in config/scenes, without .yaml", "", default=())


class _NoTwins(yaml.SafeLoader):
    """A safe loader that refuses a key written twice, which YAML readers otherwise drop in silence."""

    def construct_mapping(self, node, deep=False):
        keys: list[Any] = []
        for key, _ in node.value:
            if key.value in keys:
                raise yaml.constructor.ConstructorError(None, None, f"key {key.value!r} is written twice", key.start_mark)
            keys.append(key.value)
        return super().construct_mapping(node, deep)


def read_yaml(path: Path) -> dict[str, Any]:
    """The mapping in a YAML file; BadInput when it cannot be read."""
    try:
        with path.open(encoding="utf-8") as stream:
            content = yaml.load(stream, _NoTwins)
    except FileNotFoundError:
        others = sorted(file.stem for file in path.parent.glob("*.yaml"))
        raise BadInput("file", str(path), f"is not there; {path.parent} holds {likest(path.stem, others)}") from None
    except Exception as error:  # dates and tags that are none come out of yaml as any error
        raise BadInput("file", str(path), "must be readable YAML: " + " ".join(str(error).split())) from None
    if not isinstance(content, dict):
        raise BadInput("file", str(path), "must hold `key: value` lines")
    return content


def likest(name: str, others: Sequence[str]) -> str:
    """Names of YAML files in words: all of a few, of many those most like a name and how many there are."""
    if len(others) <= MANY:
        return ", ".join(others) or "no YAML files"
    like = get_close_matches(name, others, cutoff=0.5)
    return f"{len(others)} YAML files" + (f", {', '.join(like)} among them" if like else "")


def validated(model: type[M], content: Any, where: str, families: Families | None = None) -> M:
    """The content as a model, its keys of the families given where rows of the user's own joined them.

    BadInput with one line for each mistake.
    """
    try:
        return model.model_validate(content, context={"families": families or {}})
    except ValidationError as error:
        items = error.errors()
        raise Mistakes(_joined([_line(item, content, where, model) for item in items if not _follows(item, items)])) from None


def _joined(lines: list[str]) -> list[str]:
    """The lines, in which those of a value that may be a list or a section are one."""
    either = [f": {words}" for words in dict.fromkeys((SECTION, WORDS["tuple_type"]))]
    joined: dict[str, str] = {}
    for line in lines:
        key = next((line.removesuffix(words) for words in either if line.endswith(words)), line)
        joined[key] = f"{joined[key]} or {line.removeprefix(key + ': must ')}" if key in joined else line
    return list(joined.values())


def _follows(item: Any, items: list[Any]) -> bool:
    """Whether a list is called too short only because of the mistakes in it, or a section no list because of those in it."""
    place = item["loc"] if item["type"] == "too_short" else item["loc"][:-1]
    other_branch = {"tuple_type": dict, "model_type": list}.get(item["type"], ())
    follows = item["type"] == "too_short" or isinstance(item["input"], other_branch)
    inner = (error["loc"] for error in items if error is not item and error["type"] != "tuple_type")
    return follows and any(len(loc) > len(place) and loc[: len(place)] == place for loc in inner)


class Mistakes(BadInput):
    """All mistakes of one file, a line each."""

    def __init__(self, lines: list[str]):
        self.lines = lines
        ValueError.__init__(self, "\n".join(lines))

    def __reduce__(self):
        return type(self), (self.lines,)

    def placed(self, where: str, keys: Mapping[str, str]) -> None:
        """Each line names its file and keys as it is."""


def _line(item: Any, content: Any, where: str, model: type[BaseModel]) -> str:
    """Line `file: key = value: what is allowed`, without the names that pydantic gives to branches of a union."""
    further = below(item)
    path, held = _placed([*item["loc"], *further], content, len(further) or item["type"] == "missing")
    key, value = ".".join(path), held if further else item["input"]
    if not key:
        return f"{where}: {message_of(item)}"
    if item["type"].startswith("union_tag") and isinstance(value, dict):
        return _untold(item, [*path, item["ctx"]["discriminator"].strip("'")], where, model)
    if item["type"] == "missing":
        return f"{where}: {key}: is missing{_unit_hint(str(item['loc'][-1]), value)}"
    shown = f" = {value!r}" if not isinstance(value, dict) and len(repr(value)) <= 80 else ""
    extra = item["type"] == "extra_forbidden"
    told = _unknown_key(str(item["loc"][-1]), keys_at(model, item["loc"][:-1])) if extra else message_of(item)
    if told.startswith("unknown key"):
        told += _elsewhere(model, item["loc"], path)
    elif told.startswith("unknown") or item["type"] == "literal_error":
        told += _elsewhere(model, item["loc"], path, value)
    return f"{where}: {key}{shown}: {told}"


def _placed(parts: list[Any], content: Any, always: int) -> tuple[list[str], Any]:
    """Keys on the way to a value in a content, without the names of branches of unions, and that value; {} where it has none.

    always: so many of the last keys are told though the content does not hold them.
    """
    path, node = [], content
    for number, part in enumerate(parts):
        last, branch = number >= len(parts) - always, isinstance(node, dict) and node.get("kind") == part != parts[-1]
        part = int(part) if isinstance(node, list) and str(part).isdecimal() else part
        if _holds(node, part) and not branch:
            node = node[part]
        elif last:
            node = {}
        else:
            continue
        path.append(str(part))
    return path, node


def _unknown_key(key: str, known: list[str]) -> str:
    """Message on a key that its place does not take: what took its place in a later version, or the known ones."""
    if key in RETIRED_KEYS:
        since, write = RETIRED_KEYS[key]
        return f"is no key any more since version {since}: write {write}"
    return f"unknown key; known here: {', '.join(known)}"


def _untold(item: Any, path: list[str], where: str, model: type[BaseModel]) -> str:
    """The line for a section whose kind is missing or unknown."""
    key, tag = ".".join(path), item["input"].get(path[-1])
    if tag is None:
        return f"{where}: {key}: is missing"
    told = unknown(key, tag, (known.strip("'") for known in item["ctx"]["expected_tags"].split(", "))).reason
    return f"{where}: {told}{_elsewhere(model, item['loc'], path, tag)}"


def _elsewhere(model: type[BaseModel], loc: Sequence[Any], path: list[str], choice: Any = None) -> str:
    """Words on where a key or a choice is known that its place does not take."""
    from silostudy.config.alone import where_known  # it reads scenes of grains, which nothing else needs

    return where_known(model, loc, path, choice)


def _holds(node: Any, part: Any) -> bool:
    in_list = isinstance(node, list) and isinstance(part, int) and part < len(node)
    return in_list or (isinstance(node, dict) and part in node)


def _unit_hint(key: str, siblings: Any) -> str:
    """Hint where a key differs from a known one only by its unit."""
    if isinstance(siblings, dict):
        bare = next((key.removesuffix(suffix) for suffix in SUFFIXES if key.endswith(suffix)), key)
        if bare != key and bare in siblings:
            return f" (the unit belongs to the name: write {key} in place of {bare})"
    return ""


def study_of(content: dict[str, Any], where: str, folder: Path = Path()) -> BaseStudy:
    """A study as asked, from the content of its file; files that it names are in `folder`.  BadInput lists every mistake."""
    if content.get("kind") not in KINDS:
        raise other_file(content, where)
    return own_validated(KINDS[content["kind"]].study, content, where, folder)


def own_validated(model: type[M], content: Any, where: str, folder: Path) -> M:
    """The content as a model, with the rows of the files of the user's own that it and its scene name."""
    families = own_families(model, content, where, folder)
    if issubclass(model, BaseStudy) and isinstance(scene := content.get("scene"), dict):
        within = f"{where} (scene)"
        families = families | own_families(model.scene_model(scene, within), scene, within, folder)
    return validated(model, content, where, families)


def own_families(model: Any, content: dict[str, Any], where: str, folder: Path) -> Families:
    """The families that a content may choose from, where it names a file of the user's own; empty where it does not."""
    named = content.get("methods_from")
    if not (isinstance(model, type) and issubclass(model, OwnMethods) and isinstance(named, str)):
        return {}  # pydantic says what is wrong with it
    return joined(model.joins, folder / named, where)


def read_study(path: Path) -> BaseStudy:
    """The study in a file, as asked; BadInput lists every mistake."""
    return study_of(read_yaml(path), str(path), path.parent)


def load_project(path: Path) -> tuple[dict[str, Path], dict[str, Path]]:
    """Study name -> file and scene name -> file, for those that config.yaml names; BadInput for a file that is not there."""
    project = validated(Project, read_yaml(path), str(path))
    if not project.studies and not project.scenes:
        raise BadInput("studies", [], "neither studies nor scenes are named: nothing to build", str(path))
    return _files(path, "studies", project.studies), _files(path, "scenes", project.scenes)


def is_project(content: dict[str, Any]) -> bool:
    """Whether a file's content names studies and scenes, and is none itself."""
    return "kind" not in content and not content.keys().isdisjoint(Project.model_fields)


def other_file(content: dict[str, Any], where: str) -> BadInput:
    """The error for a file of another sort than is asked for: a project, a study, a scene; else of an unknown kind."""
    kind = content.get("kind")
    if is_project(content):
        told = f"is a project, which names studies and scenes: `silostudy check {where}` looks at each, and "
        return BadInput("file", where, f"{told}`snakemake --config project={where}` computes them")
    if kind in KINDS:
        return BadInput("kind", kind, f"is a study: `silostudy check {where}` looks at it", where)
    if kind in FILE_KINDS:
        return BadInput("kind", kind, f"is a scene: `silostudy explain {where}` looks at it, `silostudy dem` runs it", where)
    return unknown("kind", kind, FILE_KINDS, where)


def check_lenders(name: str, study: BaseStudy, studies: Collection[str], project: Path) -> None:
    """BadInput where a study takes a cube from one that its project does not name."""
    for section, other, _ in borrowed(study):
        if other not in studies:
            raise BadInput(f"{section}.study", other, f"must be named in {project} too", name)


def _files(path: Path, kind: str, names: tuple[str, ...]) -> dict[str, Path]:
    folder = path.parent / kind
    known = sorted(file.stem for file in folder.glob("*.yaml"))
    for name in names:
        if name not in known:
            raise BadInput(kind, name, f"unknown; known: {', '.join(known)}", str(path))
    return {name: folder / f"{name}.yaml" for name in names}
