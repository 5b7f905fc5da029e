"""Contacts that are not like the others of their section, as a user writes them: coefficients of their own."""

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Self, TypeVar

from pydantic import ConfigDict, ValidationError, ValidationInfo, create_model, model_validator

from silostudy.catalogue import Family
from silostudy.config.contact import LawsConfig, own_coefficients, own_fields
from silostudy.config.fields import KeyMistake, Strict, described
from silostudy.config.mistakes import below, message_of
from silostudy.config.own import families_of

S = TypeVar("S", bound=LawsConfig)


def _with_own_fields(schema: dict[str, Any], model: Any) -> None:
    """Schema for editors: fields that laws bring along, without defaults; where nothing is said the section's values hold."""
    own = own_fields(own_coefficients(model.choices)).model_json_schema()["properties"]
    schema["properties"] |= {
        name: {key: value for key, value in field.items() if key != "default"} for name, field in own.items()
    }
    schema["additionalProperties"] = {"type": "number"}


class Apart(Strict):
    """Differences from a section of laws: its fields but for the laws; null: as the section says."""

    model_config = ConfigDict(extra="allow", json_schema_extra=_with_own_fields)
    choices: ClassVar[Mapping[str, Family]]

    @property
    def given(self) -> dict[str, Any]:
        """Values by field, of those that are given."""
        return {name: value for name, value in self.model_dump().items() if value is not None}

    @model_validator(mode="after")
    def _known_fields(self, info: ValidationInfo) -> Self:
        families = families_of(info)
        own = own_coefficients({name: families.get(family.name, family) for name, family in self.choices.items()})
        known = [*type(self).model_fields, *(coefficient.field for coefficient in own)]
        for name in self.__pydantic_extra__ or ():
            if name not in known:
                raise KeyMistake(name, f"unknown key; known: {', '.join(known)}; laws are those of the section")
        return self


def apart_from(name: str, text: str, *sections: type[Strict]) -> Any:
    """Model, under a name and with a text, of what differs from sections, the last of which has laws."""
    choices = sections[-1].choices  # type: ignore[attr-defined]
    every = (field for section in sections for field in section.model_fields.items())
    fields: dict[str, Any] = {key: (_nullable(field), _null(field)) for key, field in every if key not in choices}
    made = create_model(name, __base__=Apart, __doc__=text, **fields)
    made.choices = choices
    return made


def _nullable(field: Any) -> Any:
    """The field's type with its bounds, or nothing."""
    return Annotated[(field.annotation | None, *field.metadata)] if field.metadata else field.annotation | None


def _null(field: Any) -> Any:
    """The same field without a default."""
    return described(field.description, field.json_schema_extra["unit"], default=None)


def in_place(section: S, values: Mapping[str, Any], key: str) -> S:
    """The section with what differs from it in its place; KeyMistake where the whole is not sound."""
    try:
        return section.with_values(values)
    except ValidationError as error:
        first = error.errors()[0]
        raise KeyMistake(".".join((key, *map(str, first["loc"]), *below(first))), message_of(first)) from None
