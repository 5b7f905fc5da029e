"""Names that a scene gives to surfaces: of one of them, or of all that are its parts."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, TypeVar

from silostudy.config.grain_scenes import AnyScene
from silostudy.config.mixture import GRAIN, WALLS
from silostudy.errors import BadInput, unknown

T = TypeVar("T")
PART = "_"  # between the name of a surface and that of its part: hopper_left, wall_3


def known_names(names: Sequence[str]) -> list[str]:
    """Names that a scene may give: those of surfaces, and of what has several of them as parts."""
    wholes = [name.partition(PART)[0] for name in names]
    return list(dict.fromkeys([*(whole for whole in wholes if wholes.count(whole) > 1), *names]))


def parts_of(given: str, names: Sequence[str], field: str, where: str = "", others: Iterable[str] = ()) -> tuple[str, ...]:
    """Names of the surfaces that a name given in a scene stands for; BadInput where it stands for none.

    others: what else might have been named.
    """
    parts = tuple(name for name in names if name == given or name.startswith(given + PART))
    if not parts:
        raise unknown(field, given, (*others, *known_names(names)), where)
    return parts


def by_surface(given: Mapping[str, T], names: Sequence[str], others: T, where: str = "") -> list[T]:
    """Values for each surface: under its own name, else under that of the whole that it is a part of, else the others'."""
    values = dict.fromkeys(names, others)
    for name in sorted(given, key=len):
        values |= dict.fromkeys(parts_of(name, names, "surfaces", where), given[name])
    return [values[name] for name in names]


def check_names(scene: AnyScene, kinds: Collection[str], names: Sequence[str], where: str = "") -> None:
    """BadInput for a kind of grains that is called as a surface, and for a pair of a name that neither has."""
    for kind in kinds:
        if any(name == kind or name.startswith(kind + PART) for name in names):
            told = "is a kind of grains and a surface of the silo: it must be one of them"
            raise BadInput("inserts" if kind == GRAIN else "other_grains", kind, told, where)
    pairs: Sequence[Any] = scene.pairs
    for number, pair in enumerate(pairs):
        for name in pair.between:
            if name not in (*kinds, *scene.surfaces, WALLS):
                parts_of(name, names, f"pairs.{number}.between", where, kinds)
