"""The cases of a study that holds scenes of grains against published numbers."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from silostudy.config.published import PublishedScene, PublishedStudy
from silostudy.dem.outcomes import OUTCOMES
from silostudy.errors import BadInput
from silostudy.scene.scenes import SceneCase, scene_in
from silostudy.tables.published_cases import PublishedNumber, published_numbers, published_of


@dataclass(frozen=True)
class PublishedCase(SceneCase):
    """One filling of a published case: its scene with the filling's seed, and the file that it is in."""

    path: Path = Path()

    @property
    def files(self) -> tuple[Path, ...]:
        """The scene file, and the user's own files that it is made from."""
        return (self.path, *super().files)


def published_builder(study: PublishedStudy, folder: Path, where: str) -> Callable[[PublishedScene, dict], PublishedCase]:
    """Builds the cases; BadInput for a scene that the table has no numbers of, or others than the scene expects."""

    def build_one(config: PublishedScene, settings: dict[str, Any]) -> PublishedCase:
        path = folder / config.file
        scene = scene_in(path)
        check_numbers(scene.expected, config.case, where)
        return PublishedCase(scene.model_copy(update={"seed": config.seed}), path.parent, path)

    return build_one


def check_numbers(expected: tuple[Any, ...], case: str, where: str) -> None:
    """BadInput where a scene does not expect what the table says of the case, number by number."""
    numbers = published_of(case)
    if not numbers:
        known = ", ".join(dict.fromkeys(number.case for number in published_numbers()))
        raise BadInput("file", case, f"no published numbers of it; known: {known}", where)
    if [_told(asked) for asked in expected] != [_printed(number) for number in numbers]:
        raise BadInput("file", case, "its scene expects other numbers than tables/published_cases.csv has", where)


def _told(asked: Any) -> tuple[str, float, float]:
    """Quantity, value and tolerance that a scene expects."""
    suffix = OUTCOMES[asked.kind].suffix
    return asked.kind, getattr(asked, f"value_{suffix}"), getattr(asked, f"tolerance_{suffix}")


def _printed(number: PublishedNumber) -> tuple[str, float, float]:
    return number.quantity, number.value, number.tolerance
