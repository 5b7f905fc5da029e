"""Keys that a place of a file takes, and where others stand, for the message about one that it does not."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pydantic import BaseModel

Schema = Mapping[str, Any]


def keys_at(model: type[BaseModel], path: Iterable[str | int]) -> list[str]:
    """Keys of the section that a path leads to; the path may name branches of unions, as pydantic's errors do."""
    whole: Schema = model.model_json_schema()
    nodes: list[Schema] = [whole]
    for part in path:
        nodes = list(_below(list(_plain(nodes, whole)), part, whole))
    return list(dict.fromkeys(key for node in _plain(nodes, whole) for key in node.get("properties", ())))


def keys_within(nodes: Iterable[Schema], whole: Schema, above: str = "") -> Iterator[tuple[str, Schema]]:
    """Every key of sections and further in, by its path, with its schema; * stands for a place in a list or a table."""
    for node in _plain(nodes, whole):
        for name, field in node.get("properties", {}).items():
            yield above + name, field
            yield from keys_within([field], whole, f"{above}{name}.")
        yield from keys_within(_parts(node), whole, f"{above}*.")


def choices_of(nodes: Iterable[Schema], whole: Schema) -> list[Any]:
    """Values that a key may have, or the parts of its list, where they are listed."""
    listed = []
    for node in _plain(nodes, whole):
        listed += [*node.get("enum", ()), *([node["const"]] if "const" in node else ()), *choices_of(_parts(node), whole)]
    return listed


def _parts(node: Schema) -> list[Schema]:
    """Schemas of the parts of a list, or of the values of a table."""
    inner = [node[name] for name in ("items", "additionalProperties") if isinstance(node.get(name), Mapping)]
    return [*inner, *node.get("prefixItems", ())]


def _plain(nodes: Iterable[Schema], whole: Schema) -> Iterator[Schema]:
    """The schemas themselves behind references and unions."""
    for node in nodes:
        branches = [*node.get("anyOf", ()), *node.get("oneOf", ())]
        if "$ref" in node:
            branches.append(whole["$defs"][node["$ref"].split("/")[-1]])
        yield from _plain(branches, whole) if branches else [node]


def _below(nodes: list[Schema], part: str | int, whole: Schema) -> Iterator[Schema]:
    """Content at a key or a place in a list; the chosen branches where the part names one, all where it names nothing."""
    further = [node["properties"][part] for node in nodes if part in node.get("properties", ())]
    if isinstance(part, int):
        further += [node["items"] for node in nodes if "items" in node]
        further += [node["prefixItems"][part] for node in nodes if part < len(node.get("prefixItems", ()))]
    named = [node for node in nodes if part in (node.get("title"), *_tags(node))]
    tables = [node["additionalProperties"] for node in nodes if isinstance(node.get("additionalProperties"), Mapping)]
    yield from further or named or tables or nodes


def _tags(node: Schema) -> Iterator[str]:
    """Values of the fields that a section has one value for, by which unions tell it."""
    for field in node.get("properties", {}).values():
        if "const" in field:
            yield field["const"]
