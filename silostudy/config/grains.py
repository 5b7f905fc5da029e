"""A grains study: discs or spheres in a box that is shaken, and what walls and floor have to carry of them."""

from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from pydantic import Discriminator, Field, Tag

from silostudy.config.fields import Strict, chosen_by, described
from silostudy.config.grains_spheres import ShakenSpheres
from silostudy.config.shaking import Shaking
from silostudy.config.study import BaseStudy
from silostudy.tables.kiyama_1983 import (
    DENSITY,
    DISC_FRICTION,
    NORMAL_DAMPING,
    NORMAL_STIFFNESS,
    RADIUS,
    SILO_WIDTH,
    STIFFNESS_RATIO,
)

Packing = Literal["rows_17_18", "rows_11_12", "loose"]


class Box(Strict):
    """A plane box with a flat floor."""

    width_m: float = described("inner width", "m", gt=0, default=SILO_WIDTH)
    slenderness: float = described("height of the fill before it settles, over the width", gt=0, le=10)


class Grains(Strict):
    """The discs, by default those of Kiyama and Fujimura (1983); walls are twice as stiff."""

    radius_m: float = described("radius", "m", gt=0, default=RADIUS)
    radius_spread: float = described("relative half-width of the radii of a loose packing", ge=0, lt=1, default=0.2)
    density_kg_m3: float = described("density of a disc", "kg m-3", gt=0, default=DENSITY)
    normal_stiffness_N_m2: float = described("normal stiffness per metre thickness", "N m-2", gt=0, default=NORMAL_STIFFNESS)
    normal_damping_N_s_m2: float = described("normal damping per metre thickness", "N s m-2", gt=0, default=NORMAL_DAMPING)
    stiffness_ratio: float = described("tangential over normal stiffness", gt=0, default=STIFFNESS_RATIO)
    sliding_friction: float = described("friction between discs", ge=0, default=DISC_FRICTION)


class GrainsScene(Strict):
    """One filled box and its shaking."""

    box: Box = described("the box", "")
    packing: Packing = described("how it is filled: rows of the source's packings, or rained in at random", "")
    grains: Grains = described("the discs", "", default=Grains())
    wall_friction: float = described("friction at walls and floor", ge=0)
    shaking: Shaking = described("horizontal acceleration of the box", "")


def _model_of(scene: Any) -> str | None:
    """Name of the model that a scene, or its content, is of: the key `grains` is a word for spheres, a section for discs."""
    if not isinstance(scene, dict):
        return type(scene).__name__
    if not isinstance(word := scene.get("grains"), str):
        return GrainsScene.__name__
    return ShakenSpheres.__name__ if word == "spheres" else None


AnyBox: TypeAlias = Annotated[
    Annotated[GrainsScene, Tag(GrainsScene.__name__)] | Annotated[ShakenSpheres, Tag(ShakenSpheres.__name__)],
    Discriminator(_model_of, **chosen_by("grains", "spheres", "a section for discs")),
]


class GrainsStudy(BaseStudy):
    """Effective mass of shaken grains, with its spread over fillings."""

    unasked: ClassVar[str] = "no front is measured for shaken grains"

    kind: Literal["grains"] = described("grains: effective mass of discs or spheres in a shaken box", "")
    scene: AnyBox = described("the base scene", "")
    fillings: int = described("fillings of each case, which differ by their seed", ge=1, le=1000, default=3)
    cycles: int = described("cycles of a sine that count", ge=1, default=5)
    waited_cycles: int = described("cycles before them that do not", ge=0, default=3)
    samples_per_cycle: int = described("samples of the forces in a cycle, each a mean of all steps in it", ge=8, default=64)
    record_sample_s: float = described("the same for a record", "s", gt=0, default=0.00125)
    rest_limit_s: float = Field(default=2.0, gt=0, description="longest time for a filling, once it is in, to come to rest (s)")

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the fillings."""
        return tuple(range(1, self.fillings + 1))
