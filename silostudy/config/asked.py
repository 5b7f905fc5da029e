"""A study may ask for an accuracy in place of settings: the cheapest settings on the measured fronts are put in for it."""

import copy
from typing import Any, ClassVar

from pydantic import model_validator

from silostudy.config.fields import Strict, described
from silostudy.errors import BadInput
from silostudy.tables.fronts import choose


class Asked(Strict):
    """What may ask for an accuracy; the settings that are chosen then stand in the model as if they had been given."""

    front: ClassVar[str]  # kind of the fronts to choose from

    accuracy: dict[str, float] | None = described(
        "largest relative error by quantity, in place of the settings that decide it: the cheapest measured ones are chosen",
        default=None,
    )

    @model_validator(mode="before")
    @classmethod
    def _settings_for_accuracy(cls, content: Any) -> Any:
        asked = content.get("accuracy") if isinstance(content, dict) else None
        if not isinstance(asked, dict) or not all(isinstance(error, (int, float)) for error in asked.values()):
            return content  # pydantic says what is wrong with it
        try:
            settings = choose(cls.front, asked).settings
        except BadInput as error:
            raise ValueError(error.reason) from None
        content = copy.deepcopy(content)
        for dotted, value in settings.items():
            _put(content, dotted, value)
        return content

    @property
    def promise(self) -> dict[str, str]:
        """Attributes for a cube: what was asked, what was chosen for it, and the error expected; empty where nothing was."""
        if self.accuracy is None:
            return {}
        choice = choose(self.front, self.accuracy)
        return {
            "accuracy_asked": _listed(self.accuracy),
            "accuracy_settings": ", ".join(f"{key} = {value}" for key, value in choice.settings.items()),
            "accuracy_expected": _listed(choice.expected),
            "accuracy_measured": choice.measured,
        }


def _listed(errors: dict[str, float]) -> str:
    return ", ".join(f"{name} {error:g}" for name, error in errors.items())


def _put(content: dict[str, Any], dotted: str, value: Any) -> None:
    """Set a dotted key; ValueError where it is given already."""
    *parents, last = dotted.split(".")
    node = content
    for parent in parents:
        node = node.setdefault(parent, {})
        if not isinstance(node, dict):
            return  # pydantic says what is wrong with it
    given = node.get(last)
    if given is not None and given != value:
        raise ValueError(f"give either accuracy or {dotted}, and not both: it would be {value!r}")
    node[last] = value
