"""A grains study: discs in a box that is shaken, and what walls and floor have to carry of them."""

from typing import ClassVar, Literal, Self, TypeAlias

from pydantic import Field, model_validator

from silostudy.config.fields import Strict, described
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
from silostudy.tables.records import RECORDS

RecordKey: TypeAlias = Literal[tuple(RECORDS)]  # type: ignore[valid-type]
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


class Shaking(Strict):
    """Horizontal acceleration of the box: a sine, or a record."""

    amplitude_gal: float = described("amplitude of the sine, or peak of the record", "gal", gt=0)
    frequency_Hz: float | None = described("frequency of the sine", "Hz", gt=0, default=None)
    record: RecordKey | None = described("a record at hand, in place of frequency_Hz", "", default=None)
    time_compression: float = described("how many times as fast to run the record", gt=0, default=1.0)

    @model_validator(mode="after")
    def _one(self) -> Self:
        if (self.frequency_Hz is None) == (self.record is None):
            raise ValueError("give either frequency_Hz or record, and not both")
        return self


class GrainsScene(Strict):
    """One filled box and its shaking."""

    box: Box = described("the box", "")
    packing: Packing = described("how it is filled: rows of the source's packings, or rained in at random", "")
    grains: Grains = described("the discs", "", default=Grains())
    wall_friction: float = described("friction at walls and floor", ge=0)
    shaking: Shaking = described("horizontal acceleration of the box", "")


class GrainsStudy(BaseStudy):
    """Effective mass of shaken discs, with its spread over fillings."""

    unasked: ClassVar[str] = "no front is measured for shaken discs"

    kind: Literal["grains"] = described("grains: effective mass of discs in a shaken box", "")
    scene: GrainsScene = described("the base scene", "")
    fillings: int = described("fillings of each case, which differ by their seed", ge=1, le=1000, default=3)
    cycles: int = described("cycles of a sine that count", ge=1, default=5)
    waited_cycles: int = described("cycles before them that do not", ge=0, default=3)
    samples_per_cycle: int = described("samples of the forces in a cycle, each a mean of all steps in it", ge=8, default=64)
    record_sample_s: float = described("the same for a record", "s", gt=0, default=0.00125)
    rest_limit_s: float = Field(default=2.0, gt=0, description="longest time for a filling to come to rest (s)")

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the fillings."""
        return tuple(range(1, self.fillings + 1))
