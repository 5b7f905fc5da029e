"""Sections for the checks of the steel as a user writes them: wind, hopper, ring, columns, anchors, and `checks`."""

from re import fullmatch
from typing import Literal, Self, TypeAlias

from pydantic import Field, field_validator, model_validator

from silostudy.checks import CHECKS
from silostudy.config.fields import Strict, described
from silostudy.config.study import distinct
from silostudy.tables.combinations import ACTIONS, CONTENTS, SIDES

ONE_SOURCE = tuple(row.key for row in CHECKS.values() if row.one_source)
OneSource: TypeAlias = Literal[ONE_SOURCE]  # type: ignore[valid-type]


class Wind(Strict):
    """Wind and suction on the wall, characteristic values, and how the wall's edges are held."""

    pressure_kPa: float = described(
        "wind pressure at the stagnation line (pressure coefficient 1), even over the wall's height; legs and roof are left "
        "out",
        "kPa",
        ge=0,
        le=10,
    )
    force_coefficient: float = described("c_f, drag over pressure, diameter and height", ge=0, le=2)
    suction_kPa: float = described(
        "pressure inside below that outside, by wind on an open top or by emptying", "kPa", ge=0, le=50, default=0.0
    )
    upper_edge: Literal["free", "pinned", "clamped"] = described(
        "free: open top; pinned: held round, by a roof; clamped: held against moving along the wall too", ""
    )
    lower_edge: Literal["pinned", "clamped"] = described("clamped: anchored, so that the wall cannot lift anywhere", "")

    @model_validator(mode="after")
    def _held_somewhere(self) -> Self:
        if self.upper_edge == "free" and self.lower_edge == "pinned":
            raise ValueError("a free upper_edge needs a clamped lower_edge: else the wall deforms without strain")
        return self


class HopperShell(Strict):
    """The steel wall of the conical hopper, of the cylinder's steel."""

    thickness_mm: float = described("wall thickness", "mm", gt=0, le=200)
    joint_efficiency: float = described("strength of its welds over that of the plate", gt=0, le=1, default=1.0)
    ultimate_stress_MPa: float | None = described(
        "tensile strength f_u, for the joint across the meridian; null: it is not checked", "MPa", gt=0, le=3000, default=None
    )


class TransitionRing(Strict):
    """The ring where cylinder and hopper meet."""

    area_cm2: float = described("area of its section, beside the plates of cylinder and hopper; 0: none", "cm2", ge=0)
    second_moment_cm4: float | None = described(
        "second moment of area of the ring with its parts of the plates, for bending in the ring's plane; null: its buckling "
        "is not checked",
        "cm4",
        gt=0,
        default=None,
    )


class ColumnSupport(Strict):
    """Columns at equal distances under a ring beam that carries wall and hopper."""

    count: int = described("number of columns", ge=3, le=100)
    section_modulus_cm3: float = described(
        "of the ring beam, for bending about its horizontal axis, least of the fibres", "cm3", gt=0
    )


class Anchors(Strict):
    """Anchors at the foot of the wall."""

    count: int = described("number of anchors", ge=1, le=1000)
    circle_diameter_m: float = described("diameter of the circle that they stand on", "m", gt=0)
    resistance_kN: float = described("tension that one anchor bears, design value", "kN", gt=0)


class CheckedEarthquake(Strict):
    """Values that the checks take of the earthquake's elastic demand; none of them has a default."""

    behaviour_factor: float = described("q, by which the elastic demand is divided; 1.5 is usual on ground", ge=1, le=8)
    solids_factor: float = described("psi_2 of the stored solid; 0.8 by one source", ge=0, le=1)
    overstrength: float = described("factor on the earthquake's tension in the anchors", ge=1, le=3)


class OwnCombination(Strict):
    """One combination of actions."""

    combination: str = described("its name: letters, digits, _ and -, 20 at most", "")
    title: str = described("in words", "", default="")
    leading: Literal[ACTIONS] = described(  # type: ignore[valid-type]
        "the action that leads it: without it the combination is not checked", ""
    )
    contents: Literal[CONTENTS] = described(  # type: ignore[valid-type]
        "full: the worst of the study's phases; filling: that phase; empty", ""
    )
    side: Literal[SIDES] = described("side of a wall that an earthquake bends", "", default="none")  # type: ignore[valid-type]
    permanent: float = described("factor on steel and roof where they press", ge=0, le=5)
    permanent_favourable: float = described("factor on steel and roof where they hold down", ge=0, le=5, default=1.0)
    solids: float = described("factor on the stored solid's force and pressure", ge=0, le=5, default=0.0)
    wind: float = described("factor on the wind", ge=0, le=5, default=0.0)
    snow: float = described("factor on the snow", ge=0, le=5, default=0.0)
    suction: float = described("factor on the suction", ge=0, le=5, default=0.0)
    earthquake: float = described("factor on the earthquake", ge=0, le=5, default=0.0)

    @field_validator("combination")
    @classmethod
    def _is_a_word(cls, name):
        if not fullmatch("[A-Za-z0-9_-]{1,20}", name):
            raise ValueError("must be of letters, digits, _ and -, 1 to 20 of them")
        return name

    @model_validator(mode="after")
    def _agrees(self) -> Self:
        if getattr(self, self.leading) == 0:
            raise ValueError(f"the leading action {self.leading} needs a factor above 0")
        if (self.solids == 0) != (self.contents == "empty"):
            wanted = "solids 0" if self.solids else "a factor on solids above 0"
            raise ValueError(f"contents {self.contents} with solids {self.solids:g}: {self.contents} needs {wanted}")
        if (self.earthquake == 0) != (self.side == "none"):
            wanted = "side pressed or lifted" if self.earthquake else "side none"
            raise ValueError(f"side {self.side} with earthquake {self.earthquake:g}: such a combination needs {wanted}")
        if self.earthquake and self.contents == "empty":
            raise ValueError("an earthquake shakes the silo with its contents: a seismic study has no demand of the empty one")
        return self


class Checks(Strict):
    """Every check of the steel under combinations of actions: a stage of its own."""

    combinations: tuple[OwnCombination, ...] | None = Field(
        default=None,
        min_length=1,
        max_length=100,
        description="combinations of actions with partial factors, in place of the package's (`silostudy list combinations`)",
    )
    one_source: tuple[OneSource, ...] = described("checks that a single public source has, to be made too", "", default=())
    gamma_M0: float = described("partial factor on yielding", ge=1, le=3, default=1.0)
    gamma_M1: float = described("partial factor on buckling", ge=1, le=3, default=1.1)
    gamma_M2: float = described("partial factor on joints", ge=1, le=3, default=1.25)
    earthquake: CheckedEarthquake | None = described(
        "how the study's earthquake enters; null: combinations with an earthquake are not checked", "", default=None
    )

    @field_validator("combinations")
    @classmethod
    def _distinct(cls, combinations):
        distinct(tuple(choice.combination for choice in combinations or ()))
        return combinations

    @field_validator("one_source")
    @classmethod
    def _no_twin(cls, keys):
        return distinct(keys)
