"""A study may name a Python file of the user's own, whose rows join the families for that study alone."""

from typing import Annotated, Any, ClassVar, Self, TypeVar

from pydantic import AfterValidator, Discriminator, PrivateAttr, Tag, ValidationInfo, WithJsonSchema, model_validator

from silostudy.catalogue import Family, Row
from silostudy.config.fields import Strict, described
from silostudy.config.own_rows import Families

R = TypeVar("R", bound=Row)
ALL = "all"


class OwnMethods(Strict):
    """Base of files that may name a user's own methods; the rows come with the context of the validation (see `load`)."""

    joins: ClassVar[tuple[Family, ...]]  # families that the rows may join

    methods_from: str | None = described(
        "Python file with methods of your own, relative to this file (silostudy/README.md, Your own method)",
        "",
        default=None,
    )
    _families: Families = PrivateAttr(default_factory=dict)

    @model_validator(mode="after")
    def _with_families(self, info: ValidationInfo) -> Self:
        self._families = families_of(info)
        return self

    @property
    def families(self) -> Families:
        """The families that the user's rows joined, by name; empty where none did."""
        return self._families

    def family(self, shipped: Family[R]) -> Family[R]:
        """A family of the package with the rows of the user's own."""
        return self._families.get(shipped.name, shipped)

    @property
    def own_methods(self) -> dict[str, str]:
        """Attributes for a cube: name and hash of the file whose rows joined; empty where none did."""
        origins = {row.origin for family in self._families.values() for row in family.values() if row.origin}
        return {"own_methods": ", ".join(origins)} if origins else {}


def families_of(info: ValidationInfo) -> Families:
    """The families with the user's rows that a content is validated with."""
    return (info.context or {}).get("families", {})


def key_of(family: Family) -> Any:
    """Type of a key of a family, of the package or the user's own; editors complete the package's."""

    def known(key: str, info: ValidationInfo) -> str:
        here = families_of(info).get(family.name, family)
        if key not in here:
            raise ValueError(f"unknown; known: {', '.join(here)}")
        return key

    schema = {"anyOf": [{"enum": list(family), "type": "string"}, {"type": "string"}]}
    return Annotated[str, AfterValidator(known), WithJsonSchema(schema)]


def keys_of(family: Family) -> Any:
    """Type of several keys of a family, or the word all."""
    several = Annotated[tuple[key_of(family), ...], Tag("keys")]  # type: ignore[misc, valid-type]

    def known(word: str, info: ValidationInfo) -> str:
        if word != ALL:
            here = ", ".join(families_of(info).get(family.name, family))
            raise ValueError(f"must be all, or a list of keys; known: {here}")
        return word

    whole = Annotated[str, AfterValidator(known), WithJsonSchema({"const": ALL, "type": "string"})]
    return Annotated[several | Annotated[whole, Tag("all")], Discriminator(_which)]


def _which(value: Any) -> str:
    return "all" if isinstance(value, str) else "keys"
