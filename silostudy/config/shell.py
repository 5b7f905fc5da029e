"""A shell study: a silo's wall pressures by theories and codes, and what they ask of its steel wall by buckling rules."""

from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from silostudy.catalogue import Family
from silostudy.config.buckling import RuleChoice
from silostudy.config.fields import Strict, described, expand
from silostudy.config.pressure import PressureStudy
from silostudy.config.scene import END_WORDS, FRICTION_ENDS, CircularSilo, SceneConfig
from silostudy.config.steel import SiloWall
from silostudy.config.steelwork import Anchors, Checks, ColumnSupport, HopperShell, TransitionRing, Wind
from silostudy.tables.mass_choices import MASS_CHOICES, USUAL
from silostudy.tables.outputs import OUTPUTS

BOTH = "both"
END_KEY = "wall_friction_end"
HOPPER_PLACES = 21  # least number of places over the hopper, whose forces the checks sum
OF_THE_HOPPER = ("hopper_shell", "transition_ring")
ANCHOR_CIRCLE = 1.25  # of the wall's diameter, or its inverse: farther off it is a slip of the pen
FOR_CHECKS = ("wind", "hopper_shell", "transition_ring", "columns", "anchors")


class SteelSilo(SceneConfig):
    """One circular silo with a steel wall, and its contents."""

    silo: CircularSilo = described("shape and size", "")
    shell: SiloWall = described("the steel wall of the cylinder", "")
    wind: Wind | None = described("wind and suction, for `checks`; null: none", "", default=None)
    hopper_shell: HopperShell | None = described("the hopper's wall, for `checks`; null: not checked", "", default=None)
    transition_ring: TransitionRing | None = described(
        "the ring at the transition, for `checks`; null: not checked", "", default=None
    )
    columns: ColumnSupport | None = described("columns under a ring beam, for `checks`; null: not checked", "", default=None)
    anchors: Anchors | None = described("anchors at the foot, for `checks`; null: not checked", "", default=None)
    wall_friction_end: Literal[(*FRICTION_ENDS, BOTH)] = described(  # type: ignore[valid-type]
        f"{END_WORDS}. both: an axis of lower and upper, and the worst of them in the cube "
        "(`largest_utilisation`, `largest_required_thickness`)",
        "",
        default="mean",
    )

    @model_validator(mode="after")
    def _steel_for_a_hopper(self) -> Self:
        given = [name for name in OF_THE_HOPPER if getattr(self, name) is not None]
        if given and self.silo.hopper is None:
            raise ValueError(f"{given[0]} needs silo.hopper: a silo with a flat bottom has none")
        return self

    @model_validator(mode="after")
    def _joint_no_weaker_than_yield(self) -> Self:
        ultimate = self.hopper_shell.ultimate_stress_MPa if self.hopper_shell else None
        if ultimate is not None and ultimate < self.shell.yield_stress_MPa:
            least = f"shell.yield_stress_MPa, {self.shell.yield_stress_MPa:g}"
            raise ValueError(f"hopper_shell.ultimate_stress_MPa = {ultimate:g}: must not be below {least}")
        return self

    @model_validator(mode="after")
    def _anchors_at_the_wall(self) -> Self:
        wall = self.silo.diameter_m
        circle = self.anchors.circle_diameter_m if self.anchors else wall
        if not 1 / ANCHOR_CIRCLE <= circle / wall <= ANCHOR_CIRCLE:
            allowed = f"must be {wall / ANCHOR_CIRCLE:g} to {wall * ANCHOR_CIRCLE:g}: anchors stand at the foot of the wall"
            raise ValueError(f"anchors.circle_diameter_m = {circle:g}: {allowed}")
        return self


class Earthquake(Strict):
    """The seismic study whose demand is laid on the shell beside the static loads."""

    study: str = described("name of a seismic study of the same silo, in a file beside this one", "")
    mass_choice: Literal[tuple(MASS_CHOICES)] = described(  # type: ignore[valid-type]
        "how much of the contents moves with the wall", "", default=USUAL
    )


class ShellStudy(PressureStudy, RuleChoice):
    """A pressure study that goes on to the shell."""

    fronts: ClassVar[tuple[str, ...]] = ("shell", "pressure")
    joins: ClassVar[tuple[Family, ...]] = (*PressureStudy.joins, *RuleChoice.joins)

    kind: Literal["shell"] = described("shell: wall pressures, and the steel wall that carries them", "")  # type: ignore[assignment]
    scene: SteelSilo = described("the base scene", "")
    earthquake: Earthquake | None = described("check the wall with an earthquake too; null: do not", "", default=None)

    checks: Checks | None = described(
        "make every check of the steel under combinations of actions (a stage of its own); null: do not", "", default=None
    )

    @model_validator(mode="before")
    @classmethod
    def _both_ends(cls, content: Any) -> Any:
        scene = content.get("scene") if isinstance(content, dict) else None
        if not isinstance(scene, dict) or scene.get(END_KEY) != BOTH:
            return content
        ends = {"axis": END_KEY, "values": {END_KEY: ["lower", "upper"]}}
        return {**content, "scene": {**scene, END_KEY: "upper"}, "sweep": [*(content.get("sweep") or ()), ends]}

    @model_validator(mode="after")
    def _checked_parts(self) -> Self:
        given = [name for name in FOR_CHECKS if getattr(self.scene, name) is not None]
        if given and self.checks is None:
            raise ValueError(f"scene.{given[0]} is for checks of the steel: ask for them by `checks: {{}}`")
        return self

    @model_validator(mode="after")
    def _shaken_checks(self) -> Self:
        if self.checks and self.checks.earthquake and self.earthquake is None:
            raise ValueError("checks.earthquake needs the section earthquake, which names the seismic study")
        return self

    @model_validator(mode="after")
    def _whole_hopper(self) -> Self:
        if self.checks and self.scene.hopper_shell and self.hopper_position is not None:
            places = expand(self.hopper_position)
            if (places[0], places[-1]) != (0, 1) or len(places) < HOPPER_PLACES:
                allowed = f"must run from 0 to 1 in {HOPPER_PLACES} places at least: checks sum the hopper's forces over them"
                raise ValueError(f"hopper_position {allowed}")
        return self

    @model_validator(mode="after")
    def _wall_of_outputs(self) -> Self:
        for key in self.outputs:
            if OUTPUTS[key].strakes and not self.scene.shell.strakes:
                raise ValueError(f"output {key} needs scene.shell.strakes")
            if "earthquake" in OUTPUTS[key].demands and self.earthquake is None:
                raise ValueError(f"output {key} needs the section earthquake")
        return self
