"""Small pieces that every configuration model shares: strict frozen models, units, and lists of values."""

from collections.abc import Iterator
from functools import cache, reduce
from operator import or_
from types import NoneType
from typing import Annotated, Any, Literal, get_args, get_origin

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, create_model, model_validator

from silostudy.catalogue import Family

# of a discriminator: what is said where a section is none
SECTION = "must hold `key: value` lines"
NO_SECTION: Any = {"custom_error_type": "no_section", "custom_error_message": SECTION}


def chosen_by(key: str, *known: str) -> Any:
    """Error of a discriminator that gives None: the key of the section is missing or none of the known ones."""
    told = {"discriminator": key, "expected_tags": ", ".join(known)}
    return {"custom_error_type": "union_tag_unknown", "custom_error_message": SECTION, "custom_error_context": told}


class KeyMistake(ValueError):
    """A mistake in the value of a key below the section whose model finds it."""

    def __init__(self, key: str, allowed: str):
        self.key = key
        super().__init__(allowed)


class Strict(BaseModel):
    """A frozen model that refuses unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    @model_validator(mode="before")
    @classmethod
    def _switches_are_no_numbers(cls, content: Any) -> Any:
        """Refuse true and false where numbers are asked for, and numbers where they are, which they would be taken as: 1, 0."""
        for name, value in content.items() if isinstance(content, dict) else ():
            kinds = kinds_of_fields(cls).get(name, set())
            if {int, float} & kinds and bool not in kinds:
                for key in switches(value, name):
                    raise KeyMistake(key, "must be a number")
            if kinds in ({bool}, {bool, NoneType}) and isinstance(value, int | float) and not isinstance(value, bool):
                raise KeyMistake(name, "must be true or false")
        return content


@cache
def kinds_of_fields(model: type[BaseModel]) -> dict[str, set[Any]]:
    """The plain types of each field of a model, and of its items."""
    return {name: kinds_in(field.annotation) for name, field in model.model_fields.items()}


def kinds_in(annotation: Any) -> set[Any]:
    """The plain types that a type is of, and those of its items."""
    parts = get_args(annotation)[:1] if get_origin(annotation) is Annotated else get_args(annotation)
    return set[Any]().union(*map(kinds_in, parts)) if parts else {annotation}


def switches(value: Any, key: str) -> Iterator[str]:
    """Keys at which a value is true or false, or an item of a list or mapping is."""
    if isinstance(value, bool):
        yield key
    items = enumerate(value) if isinstance(value, list | tuple) else value.items() if isinstance(value, dict) else ()
    for name, item in items:
        yield from switches(item, f"{key}.{name}")


def described(text: str, unit: str = "1", **constraints):
    """A field with its description and unit, both in the JSON schema."""
    return Field(description=text, json_schema_extra={"unit": unit}, **constraints)


def section_of(row: Any, name: str = "") -> Any:
    """Model of a section whose `kind` chooses a row of a family, with the fields that the row asks for; name: of the model."""
    fields: dict[str, Any] = {"kind": (Literal[row.key], described(f"{row.key}: {row.title}", ""))}
    for field in row.asks:
        fields[field.name] = field.kind, described(field.text, field.unit, default=field.default, **field.bounds)
    return create_model(f"{row.key.capitalize()}{name}Config", __base__=Strict, __doc__=f"{row.title}.", **fields)


def one_of(family: Family, name: str = "") -> Any:
    """Type of a section that chooses a row of a family by its `kind`."""
    return Annotated[reduce(or_, (section_of(row, name) for row in family.values())), Field(discriminator="kind")]


class ValueRange(Strict):
    """Evenly spaced values, both ends included."""

    start: float = described("first value")
    stop: float = described("last value")
    count: int = described("how many values", ge=2, le=1_000_000)
    spacing: Literal["linear", "log"] = described("linear: equal steps; log: equal ratios", default="linear")

    @model_validator(mode="after")
    def _log_needs_positive(self):
        if self.spacing == "log" and not (self.start > 0 and self.stop > 0):
            raise KeyMistake("spacing", "log needs start and stop above 0")
        return self

    def expand(self) -> list[float]:
        space = np.linspace if self.spacing == "linear" else np.geomspace
        return [float(value) for value in space(self.start, self.stop, self.count)]


Numbers = Annotated[tuple[float, ...], Field(min_length=1)]


def expand(values: "Numbers | ValueRange | tuple") -> list:
    """The plain list behind a list or a range."""
    return values.expand() if isinstance(values, ValueRange) else list(values)
