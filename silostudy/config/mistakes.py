"""Words on what pydantic finds wrong with one value."""

from typing import Any

from silostudy.config.fields import SECTION, KeyMistake

NUMBER = "must be a number"
WHOLE = "must be a whole number"
SWITCH = "must be true or false"
WORDS = {  # type of a mistake -> what is said of it
    "tuple_type": "must be a list", "list_type": "must be a list", "string_type": "must be text",
    "dict_type": SECTION, "model_type": SECTION, "model_attributes_type": SECTION,
    "float_type": NUMBER, "float_parsing": NUMBER, "bool_type": SWITCH, "bool_parsing": SWITCH,
    "string_too_short": "must not be empty", "int_type": WHOLE, "int_parsing": WHOLE, "int_from_float": WHOLE,
}  # fmt: skip


def message_of(item: Any) -> str:
    """Words on a mistake, without its key and value."""
    if item["type"] == "too_short":
        return f"must hold {item['ctx']['min_length']} or more"
    if item["type"] == "too_long":
        return f"must hold {item['ctx']['max_length']} at most"
    return WORDS.get(item["type"]) or item["msg"].removeprefix("Value error, ").replace("Input should be", "must be")


def below(item: Any) -> list[str]:
    """Keys from the section that a mistake was found in to the value that it is of; none where it is of the whole section."""
    error = item.get("ctx", {}).get("error")
    return error.key.split(".") if isinstance(error, KeyMistake) else []
