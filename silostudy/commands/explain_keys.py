"""Lines of `silostudy explain KIND`: every key that a file of a kind of study or scene takes; and of `explain KEY`."""

from collections.abc import Iterator, Mapping
from typing import Any


def explanation(kind) -> list[str]:
    """The keys of a kind's files, those of a section further in: name, unit, whether it must be given, what it is."""
    lines = [f"{kind.title} (kind: {kind.key}); of one key alone: silostudy explain KEY"]
    for model in kind.models:
        schema = model.model_json_schema()
        told = [f" {schema['description'].splitlines()[0]}"] if kind.variants else []
        lines += [*told, *_keys(schema, schema.get("$defs", {}), "  ")]
    return lines


def key_explanation(key: str) -> list[str]:
    """Lines on a key of studies and scenes: where it stands in files of which kinds, what it is, and its own keys."""
    from silostudy.stages import FILE_KINDS

    places: dict[tuple[str, ...], dict[str, dict[str, None]]] = {}  # what is told -> path -> kinds, in order
    for kind in FILE_KINDS.values():
        for schema in (model.model_json_schema() for model in kind.models):
            for path, lines in _places(key, schema, schema.get("$defs", {})):
                places.setdefault(tuple(lines), {}).setdefault(path, {})[kind.key] = None
    told = {
        lines: "; ".join(f"{path} of kind {', '.join(kinds)}" for path, kinds in where.items())
        for lines, where in places.items()
    }
    return [line for lines, where in told.items() for line in (f"key {where}", *lines)]


def _places(key: str, section: Mapping[str, Any], known: Mapping[str, Any], above: str = "") -> Iterator[tuple[str, list[str]]]:
    """The places of a key in a section and further in, by the path to it, each with its lines."""
    for name, field in section.get("properties", {}).items():
        if name == key:
            yield above + name, list(_key(name, section, known, "  "))
        for part in _sections(field, known):
            yield from _places(key, part, known, f"{above}{name}.")


def _keys(section: Mapping[str, Any], known: Mapping[str, Any], margin: str) -> Iterator[str]:
    for name in section.get("properties", {}):
        yield from _key(name, section, known, margin)


def _key(name: str, section: Mapping[str, Any], known: Mapping[str, Any], margin: str) -> Iterator[str]:
    field = section["properties"][name]
    unit = f" ({field['unit']})" if field.get("unit", "1") not in ("", "1") else ""
    must = section.get("required", ())
    yield f"{margin}{name}{unit}: {field.get('description', '')}{_preset(name, field, must)}{_choices(field)}"
    for part in _sections(field, known):
        if part.get("description"):
            yield f"{margin}  - {part['description'].splitlines()[0]}"
        yield from _keys(part, known, f"{margin}    ")


def _preset(name: str, field: Mapping[str, Any], must) -> str:
    if name in must:
        return " [must be given]"
    value = field.get("default")
    return "" if isinstance(value, dict) or value in (None, "", []) else f" [{value}]"


def _choices(field: Mapping[str, Any]) -> str:
    choices = [str(value) for branch in _branches(field) for value in branch.get("enum", ())]
    return f" {{{', '.join(choices)}}}" if choices else ""


def _branches(field: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """A field's schema, and those that it is a union, a list or a table of."""
    yield field
    nested = (field[name] for name in ("items", "additionalProperties") if isinstance(field.get(name), Mapping))
    for inner in (*field.get("anyOf", ()), *field.get("oneOf", ()), *nested):
        yield from _branches(inner)


def _sections(field: Mapping[str, Any], known: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The sections that a field may hold."""
    named = (known[branch["$ref"].split("/")[-1]] for branch in _branches(field) if "$ref" in branch)
    return [part for part in named if part.get("properties")]
