"""Contact of two bodies as a user writes it: laws, and the fields that their coefficients come from."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any, ClassVar, Literal, Self, TypeAlias

from pydantic import (
    BaseModel,
    ConfigDict,
    PrivateAttr,
    SerializationInfo,
    ValidationInfo,
    create_model,
    model_serializer,
    model_validator,
)

from silostudy.catalogue import Family
from silostudy.config.fields import KeyMistake, Strict, described
from silostudy.config.own import Families, families_of, key_of
from silostudy.contact import DEFAULTS, LAWS, Law
from silostudy.contact.coefficient import Coefficient
from silostudy.contact.curve import PRINTED_CONSTANTS

NormalKey: TypeAlias = key_of(LAWS["normal"])  # type: ignore[valid-type]
TangentialKey: TypeAlias = key_of(LAWS["tangential"])  # type: ignore[valid-type]
RollingKey: TypeAlias = key_of(LAWS["rolling"])  # type: ignore[valid-type]
CohesionKey: TypeAlias = key_of(LAWS["cohesion"])  # type: ignore[valid-type]
ConstantKey: TypeAlias = Literal[tuple(PRINTED_CONSTANTS)]  # type: ignore[valid-type]


class LineContactConfig(Strict):
    """The elastic line contact from which a stiffness follows, Kiyama & Fujimura (1983), eqs. (22), (23)."""

    youngs_modulus_Pa: float = described("Young's modulus of the discs", "Pa", gt=0)
    poissons_ratio: float = described("Poisson's ratio of the discs", gt=-1, le=0.5)
    load_N_m: float = described("load at which the stiffness is taken", "N m-1", gt=0)
    constant: ConstantKey = described("constant of eq. (23), 1.5, or of eq. (22a), 2/3", default="1.5")


def own_coefficients(families: Mapping[str, Family]) -> tuple[Coefficient, ...]:
    """Coefficients that come from fields of their own, of all laws."""
    rows = (row for family in families.values() for row in family.values())
    return tuple(dict.fromkeys(coefficient for row in rows for coefficient in row.coefficients if coefficient.own))


def _fields(laws: Iterable[Law]) -> Iterator[str]:
    """Fields that coefficients of laws come from."""
    return (field for law in laws for coefficient in law.coefficients for group in coefficient.fields for field in group)


@cache
def own_fields(coefficients: tuple[Coefficient, ...]) -> type[BaseModel]:
    """Model of the fields that laws bring along."""
    fields: dict[str, Any] = {}
    for coefficient in coefficients:
        bound = {"gt" if coefficient.positive else "ge": 0}
        fields[coefficient.field] = (
            float | None if coefficient.default is None else float,
            described(coefficient.text, coefficient.unit, default=coefficient.default, **bound),
        )
    return create_model("OwnFields", __base__=Strict, **fields)


def _with_own_fields(schema: dict[str, Any], model: Any) -> None:
    """Schema for editors: the fields of the package's laws; any other number may be of a user's own law."""
    schema["properties"] |= own_fields(own_coefficients(model.choices)).model_json_schema()["properties"]
    schema["additionalProperties"] = {"type": "number"}


class LawsConfig(Strict):
    """A law of each family, whose own fields join the section."""

    model_config = ConfigDict(extra="allow", json_schema_extra=_with_own_fields)

    choices: ClassVar[Mapping[str, Family]] = LAWS
    normal: str
    tangential: str
    rolling: str
    cohesion: str
    _families: Families = PrivateAttr(default_factory=dict)

    @property
    def laws(self) -> dict[str, Any]:
        """The laws by the names of their families here."""
        return {name: self._families.get(family.name, family)[getattr(self, name)] for name, family in self.choices.items()}

    @property
    def _own(self) -> tuple[Coefficient, ...]:
        return own_coefficients({name: self._families.get(family.name, family) for name, family in self.choices.items()})

    @property
    def untaken(self) -> dict[str, tuple[str, str]]:
        """Fields of numbers, neither zero nor the default, that no law here takes: whose family does, and its law here."""
        taken: set[str] = set(_fields(self.laws.values()))
        families: dict[str, tuple[str, str]] = {}
        for name, family in self.choices.items():
            for field in _fields(self._families.get(family.name, family).values()):
                value, usual = getattr(self, field, None), self._usual.get(field)
                if field not in taken and isinstance(value, float) and value not in (0.0, usual):
                    families.setdefault(field, (name, getattr(self, name)))
        return families

    @property
    def _usual(self) -> dict[str, Any]:
        """Defaults by field."""
        declared = {name: field.default for name, field in type(self).model_fields.items()}
        return declared | {coefficient.field: coefficient.default for coefficient in self._own}

    def with_values(self, values: Mapping[str, Any]) -> Self:
        """The section with other values, sound as a whole; one of fields that stand for each other drops those it replaces."""
        groups = [group for law in self.laws.values() for coefficient in law.coefficients for group in coefficient.fields]
        dropped = {field for group in groups if any(field in values for field in group) for field in group}
        staying = {name: value for name, value in self.model_dump().items() if name not in dropped}
        return type(self).model_validate(staying | dict(values), context={"families": self._families})

    @model_validator(mode="after")
    def _fields_of_laws(self, info: ValidationInfo) -> Self:
        self._families = families_of(info)
        extra: dict[str, Any] = self.__pydantic_extra__  # type: ignore[assignment]  # a dict, extras being allowed
        checked = own_fields(self._own).model_validate(extra).model_dump()
        extra.clear()
        extra.update(checked)
        return self

    @model_serializer(mode="wrap")
    def _own_defaults_left_out(self, handler, info: SerializationInfo) -> dict[str, Any]:
        """Fields of laws count as fields where only what differs from the defaults is asked for."""
        content = handler(self)
        if info.exclude_defaults:
            unchanged = [
                coefficient.field
                for coefficient in self._own
                if content.get(coefficient.field, coefficient.default) == coefficient.default
            ]
            content = {name: value for name, value in content.items() if name not in unchanged}
        return content


class ContactConfig(LawsConfig):
    """Contact of two bodies: a law of each family and its coefficients, per metre thickness."""

    normal: NormalKey = described("law of the normal force", "", default=DEFAULTS["normal"])
    tangential: TangentialKey = described("law of the tangential force", "", default=DEFAULTS["tangential"])
    rolling: RollingKey = described("law of rolling resistance", "", default=DEFAULTS["rolling"])
    cohesion: CohesionKey = described("law of cohesion", "", default=DEFAULTS["cohesion"])
    normal_stiffness_N_m2: float | None = described("normal stiffness", "N m-2", gt=0, default=None)
    line_contact: LineContactConfig | None = described(
        "elastic line contact, of radius_m where discs differ in size, in place of normal_stiffness_N_m2",
        "",
        default=None,
    )
    normal_damping_N_s_m2: float | None = described("normal dashpot", "N s m-2", ge=0, default=None)
    damping_ratio: float | None = described(
        "normal dashpot over the critical one 2 sqrt(m K) of a disc's mass and stiffness, in place of normal_damping_N_s_m2; "
        "m is each disc's own at a wall, and between discs of several sizes twice the pair's reduced mass",
        ge=0,
        default=None,
    )
    restitution: float | None = described(
        "speed after over speed before a head-on impact, of every pair and at walls, in place of normal_damping_N_s_m2",
        gt=1e-3,
        le=1,
        default=None,
    )
    stiffness_ratio: float = described("s, tangential over normal stiffness; dashpots have its root", ge=0, default=0.25)
    sliding_friction: float = described("friction coefficient", ge=0, default=0.0)

    @model_validator(mode="after")
    def _what_the_laws_need(self) -> Self:
        for law in self.laws.values():
            for group in (group for coefficient in law.coefficients for group in coefficient.fields):
                given = sum(getattr(self, field) is not None for field in group)
                if len(group) > 1 and given != 1:
                    raise ValueError(
                        f"give either {' or '.join(group)}, and not {'both' if len(group) == 2 else 'more than one'}"
                    )
                if not given:
                    raise KeyMistake(group[0], f"must be given: the law {law.key} needs it")
        if self.restitution is not None and self.laws["normal"].damped is None:
            raise KeyMistake("restitution", f"differs with the speed under the law {self.normal}: give damping_ratio instead")
        return self
