"""An accuracy study: which problems to set against their cost, and how carefully to measure."""

from typing import ClassVar, Literal, Self, TypeAlias

from pydantic import model_validator

from silostudy.config.fields import Strict, described
from silostudy.config.study import BaseStudy
from silostudy.tables.outputs import OUTPUTS
from silostudy.tables.problems import PROBLEMS

ProblemKey: TypeAlias = Literal[tuple(PROBLEMS)]  # type: ignore[valid-type]


class Measuring(Strict):
    """Settings of a measurement of accuracy: what is measured, and how carefully."""

    problems: tuple[ProblemKey, ...] | Literal["all"] = described("problems (`silostudy list problems`), or all", "")
    repeats: int = described("readings of the cost of every setting; their median counts", ge=1, le=1000, default=5)
    members: int = described("members of the ensembles of chaotic problems", ge=3, le=10_000, default=24)
    ladders: int | None = described("only the first so many ladders of each problem; null: all", ge=1, default=None)
    rungs: int | None = described("only the coarsest so many settings of each ladder; null: all", ge=1, default=None)
    prices: bool = described("whether effects and optional parts are priced as well", "", default=False)


class AccuracyStudy(BaseStudy):
    """Error against CPU time of every numerical method."""

    unasked: ClassVar[str] = "it measures what accuracy costs"

    kind: Literal["accuracy"] = described("accuracy: error against CPU time, measured on this machine", "")
    scene: Measuring = described("what is measured", "")

    @model_validator(mode="after")
    def _no_axes(self) -> Self:
        if self.sweep:
            raise ValueError("an accuracy study takes no sweep: its ladders are its axes")
        for key in self.outputs:
            if "prices" in OUTPUTS[key].demands and not self.scene.prices:
                raise ValueError(f"output {key} needs scene.prices: true")
        return self

    @property
    def problem_keys(self) -> tuple[str, ...]:
        """The problems asked for, in order."""
        return tuple(PROBLEMS) if self.scene.problems == "all" else self.scene.problems
