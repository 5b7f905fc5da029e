"""A scene file is of discs or of spheres, as its key `grains` says; discs where it says nothing."""

from typing import Any, TypeAlias

from silostudy.config.dem import DemScene
from silostudy.config.spheres import SphereScene
from silostudy.errors import unknown

AnyScene: TypeAlias = DemScene | SphereScene
SCENES: dict[str, type[AnyScene]] = {"discs": DemScene, "spheres": SphereScene}


def scene_class(content: dict[str, Any], where: str) -> type[AnyScene]:
    """The model of a scene file's content."""
    grains = content.get("grains", "discs")
    if grains not in SCENES:
        raise unknown("grains", grains, SCENES, where)
    return SCENES[grains]
