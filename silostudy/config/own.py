"""A study may bring rows of the user's own, which join the families for that study alone."""

from typing import Annotated, Any

from pydantic import AfterValidator, ValidationInfo, WithJsonSchema

from silostudy.catalogue import Family

Families = dict[str, Family]  # by the name of the family


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
