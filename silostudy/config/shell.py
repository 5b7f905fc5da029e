"""A shell study: a silo's wall pressures by theories and codes, and what they ask of its steel wall by buckling rules."""

from typing import Literal

from silostudy.config.buckling import RuleChoice
from silostudy.config.fields import described
from silostudy.config.pressure import PressureStudy
from silostudy.config.scene import CircularSilo, SceneConfig
from silostudy.config.steel import SiloWall


class SteelSilo(SceneConfig):
    """One circular silo with a steel wall, and its contents."""

    silo: CircularSilo = described("shape and size", "")
    shell: SiloWall = described("the steel wall of the cylinder", "")


class ShellStudy(PressureStudy, RuleChoice):
    """A pressure study that goes on to the shell."""

    kind: Literal["shell"] = described("shell: wall pressures, and the steel wall that carries them", "")  # type: ignore[assignment]
    scene: SteelSilo = described("the base scene", "")

    @property
    def stages(self) -> tuple[str, ...]:
        """The pressures first, then the shell under them."""
        return ("pressure", "shell")
