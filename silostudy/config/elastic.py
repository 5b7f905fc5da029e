"""Materials of spheres and walls as a user writes them, and the contacts between them."""

from collections.abc import Mapping
from typing import ClassVar, Literal, Self, TypeAlias

from pydantic import model_validator

from silostudy.catalogue import Family
from silostudy.config.contact import LawsConfig
from silostudy.config.fields import KeyMistake, Strict, described
from silostudy.config.own import key_of
from silostudy.contact import NO_COHESION, NO_ROLLING, NO_TWISTING, SPHERE_LAWS, Law
from silostudy.contact.normal import hertz
from silostudy.contact.tangential import mindlin
from silostudy.tables.materials import MATERIALS

LAWS: Mapping[str, Family] = SPHERE_LAWS
OF_PAIR = ("materials", "restitution", "sliding_friction")  # what the pair of materials says where a section does not
MaterialKey: TypeAlias = Literal[tuple(MATERIALS)]  # type: ignore[valid-type]
NormalKey: TypeAlias = key_of(LAWS["normal"])  # type: ignore[valid-type]
TangentialKey: TypeAlias = key_of(LAWS["tangential"])  # type: ignore[valid-type]
RollingKey: TypeAlias = key_of(LAWS["rolling"])  # type: ignore[valid-type]
CohesionKey: TypeAlias = key_of(LAWS["cohesion"])  # type: ignore[valid-type]
TwistingKey: TypeAlias = key_of(LAWS["twisting"])  # type: ignore[valid-type]


class MaterialConfig(Strict):
    """An elastic material: from the table, with values that replace the table's, or all of them one's own."""

    material: MaterialKey | None = described("key of the material (`silostudy list materials`); null: none", "", default=None)
    youngs_modulus_MPa: float | None = described("Young's modulus", "MPa", gt=0, default=None)
    poissons_ratio: float | None = described("Poisson's ratio", gt=-1, lt=0.5, default=None)

    @model_validator(mode="after")
    def _whole(self) -> Self:
        if self.material is None and None in (self.youngs_modulus_MPa, self.poissons_ratio):
            raise KeyMistake("material", "must be given, or youngs_modulus_MPa and poissons_ratio")
        return self


class GrainConfig(MaterialConfig):
    """The material of the spheres."""

    density_kg_m3: float | None = described("density of a sphere", "kg m-3", gt=0, default=None)
    softened_modulus_MPa: float | None = described(
        "Young's modulus that is computed with in place of the material's: steps grow with the root of the ratio, overlaps by "
        "its power 2/3 (`silostudy explain SCENE` tells both)",
        "MPa",
        gt=0,
        default=None,
    )


class TouchConfig(LawsConfig):
    """Contact of two spheres, or of spheres with walls: laws, and values that the pair of materials does not give."""

    choices: ClassVar[Mapping[str, Family]] = LAWS

    normal: NormalKey = described("law of the normal force", "", default=hertz.ROW.key)
    tangential: TangentialKey = described("law of the tangential force", "", default=mindlin.ROW.key)
    rolling: RollingKey = described("law of rolling resistance", "", default=NO_ROLLING)
    cohesion: CohesionKey = described("law of cohesion", "", default=NO_COHESION)
    twisting: TwistingKey = described("law of resistance to twisting about the normal", "", default=NO_TWISTING)
    restitution: float | None = described(
        "speed after over speed before a head-on impact; null: of the pair of materials", gt=1e-3, le=1, default=None
    )
    sliding_friction: float | None = described("friction coefficient; null: of the pair of materials", ge=0, default=None)
    normal_stiffness_N_m: float | None = described(
        "normal stiffness of laws with linear springs, of any two bodies; materials say nothing of it",
        "N m-1",
        gt=0,
        default=None,
    )
    stiffness_ratio: float = described(
        "tangential over normal stiffness of linear springs; dashpots have its root", ge=0, default=0.25
    )

    @model_validator(mode="after")
    def _what_the_laws_need(self) -> Self:
        laws = list(self.laws.values())
        taken = [
            (field, law) for law in laws for coefficient in law.coefficients for group in coefficient.fields for field in group
        ]
        given = self.model_dump()  # with the fields that laws bring along
        for field, law in taken:
            if field not in OF_PAIR and given.get(field, law) is None:
                raise KeyMistake(field, f"must be given: the law {law.key} needs it")
        if self.normal_stiffness_N_m is not None and "normal_stiffness_N_m" not in dict(taken):
            told = f"no law here has linear springs: {self.normal} takes the materials' moduli"
            raise KeyMistake("normal_stiffness_N_m", told)
        return self

    @model_validator(mode="after")
    def _dashpots_of_one_spring(self) -> Self:
        """Dashpots that follow from a restitution do so for one kind of normal spring."""
        normal, springs = self.laws["normal"], _behind_dashpots(self.laws["normal"])
        for name, law in self.laws.items():
            if _behind_dashpots(law) and springs - _behind_dashpots(law):
                fitting = [row.key for row in self.choices[name].values() if not springs - (_behind_dashpots(row) or springs)]
                raise KeyMistake(name, f"the law {law.key} does not go with {normal.key}: take {' or '.join(fitting)}")
        return self


def _behind_dashpots(law: Law) -> set[str]:
    """Fields that a law's dashpots follow from, where they follow from a restitution; none where they do not."""
    groups = (coefficient.fields for coefficient in law.coefficients if ("restitution",) in coefficient.fields)
    return {field for fields in groups for group in fields for field in group}
