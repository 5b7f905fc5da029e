"""The row of a packing: a function that lays the discs, and the fields that its section in a scene takes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from silostudy.catalogue import Row


@dataclass(frozen=True, kw_only=True)
class PackingField:
    """Field of a packing's section in a scene file, and the argument of `place` that it becomes.

    bounds: ge, gt, le, lt; without a default the field must be given.
    """

    name: str
    text: str
    argument: str = ""
    unit: str = "1"
    kind: Any = float
    default: Any = ...
    bounds: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True)
class Packing(Row):
    """Arrangement of discs. place(**needs) -> x, y (m) and radius (m).

    asks: fields of a scene's section `packing`; the other needs come from the scene (width, radius and seed).
    count: about how many discs there will be, from the radius (m) and the arguments; spread: argument above 0 of which the
    radii differ; from_file: the field `file` names a netCDF file that holds all needs.
    """

    place: Callable
    needs: tuple[str, ...]
    asks: tuple[PackingField, ...]
    count: Callable[..., float] | None = None
    spread: str = ""
    from_file: bool = False

    def arguments(self, section: Any) -> dict[str, Any]:
        """The arguments of `place` that a section gives."""
        return {field.argument: getattr(section, field.name) for field in self.asks if field.argument}

    def uneven(self, section: Any) -> bool:
        """Whether the discs may be of several sizes."""
        return self.from_file or bool(self.spread and self.arguments(section)[self.spread] > 0)
