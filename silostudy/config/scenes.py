"""A sweep of discrete-element scenes: the content of a scene file, and axes over its keys."""

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, TypeAlias

from pydantic import Discriminator, Tag, model_validator

from silostudy.config.fields import NO_SECTION, Strict, described
from silostudy.config.grain_scenes import SCENES, AnyScene, scene_class
from silostudy.config.run import MEANS
from silostudy.config.study import FILLING, SweepStudy
from silostudy.tables.asked import quantities
from silostudy.tables.outputs import OUTPUTS


def _model_of(scene: Any) -> str:
    """Name of the model that a scene, or its content, is of: no key of a scene, so that mistakes are told by their keys."""
    return (scene_class(scene, "") if isinstance(scene, dict) else type(scene)).__name__


if TYPE_CHECKING:
    BaseScene: TypeAlias = AnyScene
else:
    _either = reduce(or_, (Annotated[model, Tag(model.__name__)] for model in SCENES.values()))
    BaseScene = Annotated[_either, Discriminator(_model_of, **NO_SECTION)]


# dimensions of its cubes that no axis may be named after
OWN = ("body", "wall_level", "wall_turn", "flow_window", "flow_share", "averaging")


class CodesConfig(Strict):
    """Theories and codes that are computed for the same silos, to stand beside the grains."""

    study: str = described(
        "name of a study of pressures of the same silos and solid, in a file beside this one; its axes are among this one's", ""
    )


def _walls_are_kept(scene: Any) -> bool:
    """Whether a sweep keeps the pressures on the walls of a scene, level by level."""
    round_or_wedge = scene.silo.hopper_half_angle_deg is not None if scene.grains == "discs" else scene.silo.plan == "circular"
    return bool(round_or_wedge and scene.record.wall_force_window_s)


class ScenesStudy(SweepStudy):
    """Forces on walls and floor in each of many scenes of grains, and what leaves through the outlet."""

    unasked: ClassVar[str] = "its scenes do: write scene.accuracy"

    kind: Literal["scenes"] = described("scenes: a sweep of discrete-element scenes", "")
    scene: BaseScene = described("the base scene: what a file of config/scenes holds", "")
    codes: CodesConfig | None = described(
        "set the walls of round silos of spheres, or of plane ones of discs over a wedge, beside theories and codes; null: do "
        "not",
        "",
        default=None,
    )

    @model_validator(mode="after")
    def _grains_that_are_drawn(self) -> Self:
        for key in self.outputs:
            for grains in SCENES:
                if f"only_{grains}" in OUTPUTS[key].demands and self.scene.grains != grains:
                    raise ValueError(f"output {key} needs scene.grains: {grains}")
            if "means" in OUTPUTS[key].demands and not self.of_fillings:
                raise ValueError(f"output {key} needs scene.accuracy of {' or '.join(quantities((MEANS,)))}")
        return self

    @model_validator(mode="after")
    def _free_names(self) -> Self:
        for axis in self.sweep:
            if axis.axis in OWN:
                raise ValueError(f"an axis cannot be named {axis.axis}: the cube has a dimension of this name")
        return self

    @model_validator(mode="after")
    def _walls_to_compare(self) -> Self:
        if self.codes is None:
            return self
        if not _walls_are_kept(self.scene):
            raise ValueError(
                "codes needs scene.record.wall_force_window_s, and scene.silo.plan: circular of spheres, "
                "scene.silo.hopper_half_angle_deg of discs"
            )
        swept = {key for axis in self.sweep for key in axis.settings()[0]}
        if wide := swept & {"silo.diameter_m", "silo.width_m"}:
            raise ValueError(f"codes needs one {wide.pop()}, not a sweep of it")
        if self.fillings is None:
            raise ValueError(
                "codes needs an axis of the key seed alone, with two fillings at least: without, no scatter is known"
            )
        if self.fillings != FILLING and FILLING in [axis.axis for axis in self.sweep]:
            raise ValueError(f"codes needs the name {FILLING} for the axis of seeds: name the other axis otherwise")
        return self

    @property
    def fillings(self) -> str | None:
        """Name of the axis of fillings: the one that sets nothing but the seed; None where there is none of two or more."""
        named = [axis.axis for axis in self.sweep if [*axis.settings()[0]] == ["seed"] and len(axis.settings()) > 1]
        return named[0] if named else None

    @property
    def silo_width(self) -> float:
        """Diameter of the scene's round silo, or width of its plane one (m)."""
        silo: Any = self.scene.silo
        return silo.width_m if self.scene.grains == "discs" else silo.diameter_m

    @property
    def of_fillings(self) -> tuple[str, ...]:
        """Quantities whose means over fillings an accuracy is asked of, by the scene or by an axis."""
        swept = [key.removeprefix("accuracy.") for axis in self.sweep for key in axis.settings()[0]]
        known = quantities((MEANS,))
        return tuple(dict.fromkeys(name for name in (*(self.scene.accuracy or ()), *swept) if name in known))

    @property
    def settings(self) -> str:
        """Settings that a case's numbers depend on besides its scene: not what it is compared with (canonical JSON)."""
        return self.model_dump_json(exclude={*SweepStudy.model_fields, "codes"})

    @classmethod
    def scene_model(cls, scene: dict[str, Any], where: str) -> type:
        """The model of the content of its scene."""
        return scene_class(scene, where)
