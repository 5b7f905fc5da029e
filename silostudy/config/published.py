"""Scenes of grains held against published numbers, over several fillings, as a user writes them."""

from pathlib import Path
from typing import Literal, Self

from pydantic import model_validator

from silostudy.config.fields import Strict, described
from silostudy.config.study import FILLING, SweepStudy

CASE = "published_case"  # axis of every such study, beside that of fillings


class PublishedScene(Strict):
    """A scene file with one filling of it."""

    file: str = described("scene file, relative to the study; its name is that of the case in tables/published_cases.csv", "")
    seed: int = described("seed of the filling, in place of the scene's", ge=0, le=2**53, default=0)

    @property
    def case(self) -> str:
        """The name of the case."""
        return Path(self.file).stem


class PublishedStudy(SweepStudy):
    """Results of published cases over several fillings, beside the published numbers and their tolerances."""

    kind: Literal["published"] = described("published: scenes of grains held against published numbers", "")
    scene: PublishedScene = described("a case and a filling", "")

    @model_validator(mode="after")
    def _cases_and_fillings(self) -> Self:
        keys = {axis.axis: [*axis.settings()[0]] for axis in self.sweep}
        if keys != {CASE: ["file"], FILLING: ["seed"]}:
            raise ValueError(f"sweep must have the axes {CASE}, of file, and {FILLING}, of seed, and no other")
        if self._without_scatter():
            raise ValueError(f"sweep needs two values at least on the axis {FILLING}: of one no scatter is known")
        return self

    @property
    def cases(self) -> tuple[str, ...]:
        """Names of its cases in their order."""
        (axis,) = (axis for axis in self.sweep if axis.axis == CASE)
        return tuple(self.scene.model_copy(update=setting).case for setting in axis.settings())
