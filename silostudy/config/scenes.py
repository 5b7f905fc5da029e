"""A sweep of discrete-element scenes: the content of a scene file, and axes over its keys."""

from typing import ClassVar, Literal

from silostudy.config.dem import DemScene
from silostudy.config.fields import described
from silostudy.config.study import SweepStudy


class ScenesStudy(SweepStudy):
    """What walls and floor carry in each of many discrete-element scenes, and what leaves through the slit."""

    unasked: ClassVar[str] = "its scenes do: write scene.accuracy"

    kind: Literal["scenes"] = described("scenes: a sweep of discrete-element scenes", "")
    scene: DemScene = described("the base scene: what a file of config/scenes holds", "")
