"""Names that a scene gives to surfaces: of one of them, or of all that are its parts."""

from collections.abc import Mapping, Sequence
from typing import TypeVar

from silostudy.errors import unknown

T = TypeVar("T")
PART = "_"  # between the name of a surface and that of its part: hopper_left, wall_3


def known_names(names: Sequence[str]) -> list[str]:
    """Names that a scene may give: those of surfaces, and of what has several of them as parts."""
    wholes = [name.partition(PART)[0] for name in names]
    return list(dict.fromkeys([*(whole for whole in wholes if wholes.count(whole) > 1), *names]))


def parts_of(given: str, names: Sequence[str], field: str, where: str = "") -> tuple[str, ...]:
    """Names of the surfaces that a name given in a scene stands for; BadInput where it stands for none."""
    parts = tuple(name for name in names if name == given or name.startswith(given + PART))
    if not parts:
        raise unknown(field, given, known_names(names), where)
    return parts


def by_surface(given: Mapping[str, T], names: Sequence[str], others: T, where: str = "") -> list[T]:
    """Values for each surface: under its own name, else under that of the whole that it is a part of, else the others'."""
    values = dict.fromkeys(names, others)
    for name in sorted(given, key=len):
        values |= dict.fromkeys(parts_of(name, names, "surfaces", where), given[name])
    return [values[name] for name in names]
