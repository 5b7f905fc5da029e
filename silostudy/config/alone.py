"""Keys and choices that stand elsewhere, or that scenes of other grains know, told where a file asks for them."""

from collections.abc import Sequence
from typing import Any

from pydantic import BaseModel

from silostudy.config.grain_scenes import SCENES
from silostudy.config.places import choices_of, keys_within


def where_known(model: type[BaseModel], loc: Sequence[Any], path: Sequence[str], choice: Any = None) -> str:
    """Words on a key that its place does not take, or on a choice of its, where others take it; none where none do.

    loc: the place as pydantic tells it, in which a study's scene is named by its model; path: as the file writes it.
    """
    named = {scene.__name__: scene for scene in SCENES.values()}
    depth, own = next(((depth, named[part]) for depth, part in enumerate(loc) if part in named), (0, model))
    here = ".".join("*" if part.isdecimal() else part for part in path[depth:]).removesuffix(".*")
    above, name, mine = "".join(f"{part}." for part in path[:depth]), path[-1], _places(own, here, choice)
    others = {
        grains: theirs for grains, scene in SCENES.items() if scene is not own and (theirs := _places(scene, here, choice))
    }
    if others and (not mine or any(here in places for places in others.values())):
        places = next(iter(others.values()))
        told = "" if here in places else f", as {above}{min(places, key=lambda place: place.count('*'))}"
        if choice is None and len(mine) == 1 and "*" not in mine[0]:  # a list's parts have keys of their own
            name, told = f"{above}{here}", f", here it is {above}{mine[0]}"
        return f"; {choice or name} is of scenes of {' and '.join(others)}{' alone' * (len(others) == 1)}{told}"
    return f"; {name} is known as {above}{mine[0]}" if choice is None and len(mine) == 1 else ""


def _places(model: type[BaseModel], path: str, choice: Any) -> list[str]:
    """Paths to a model's keys that are called as the last of a path, of those that may hold a choice where one is given."""
    whole, name = model.model_json_schema(), path.rpartition(".")[2]
    called = ((place, field) for place, field in keys_within([whole], whole) if place.rpartition(".")[2] == name)
    return [place for place, field in called if choice is None or choice in choices_of([field], whole)]
