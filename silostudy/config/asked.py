"""A study may ask for an accuracy in place of settings: the cheapest settings on the measured fronts are put in for it.

What an error is in a scene hangs on the scene.  Where its configuration tells, it is asked at once; else the finest settings
stand in until the scenes are built, and the study is read once more with their traits as the context.
"""

import copy
from collections.abc import Iterable, Mapping
from typing import Any, ClassVar

from pydantic import PrivateAttr, model_validator

from silostudy.config.fields import Strict, described
from silostudy.errors import BadInput
from silostudy.tables.fronts import Choice, choose, finest


class Asked(Strict):
    """What may ask for an accuracy; the settings that are chosen then stand in the model as if they had been given."""

    front: ClassVar[str]  # kind of the fronts to choose from

    accuracy: dict[str, float] | None = described(
        "largest relative error by quantity, in place of the settings that decide it: the cheapest measured ones are chosen",
        default=None,
    )
    _choice: Choice | None = PrivateAttr(default=None)

    @model_validator(mode="wrap")
    @classmethod
    def _settings_for_accuracy(cls, content: Any, handler, info):
        asked = content.get("accuracy") if isinstance(content, dict) else None
        if not isinstance(asked, dict) or not all(isinstance(error, (int, float)) for error in asked.values()):
            return handler(content)  # pydantic says what is wrong with it
        try:
            choice = choose(cls.front, asked, info.context) if info.context else finest(cls.front, asked)
            model = handler(_with(content, choice.settings))
            if not info.context and model.traits is not None:
                choice = choose(cls.front, asked, [model.traits])
                model = handler(_with(content, choice.settings))
        except BadInput as error:
            raise ValueError(error.reason) from None
        model._choice = choice
        return model

    @property
    def traits(self) -> Mapping[str, float] | None:
        """What the errors of this scene hang on, by name; None where only the built scenes of a study tell."""
        return None

    @property
    def promise(self) -> dict[str, str]:
        """Attributes for a cube: what was asked, what was chosen for it, and the error expected; empty where nothing was."""
        return promises([self])


def promises(scenes: Iterable[Asked]) -> dict[str, str]:
    """The attributes of many scenes in one cube: everything asked, chosen and measured, and the worst error expected."""
    each = [(one.accuracy, one._choice) for one in scenes if one.accuracy is not None and one._choice is not None]
    worst: dict[str, float] = {}
    for _, choice in each:
        worst |= {name: max(error, worst.get(name, 0.0)) for name, error in choice.expected.items()}
    found = {
        "accuracy_asked": [_listed(asked) for asked, _ in each],
        "accuracy_settings": [", ".join(f"{key} = {value}" for key, value in choice.settings.items()) for _, choice in each],
        "accuracy_expected": [_listed(worst)] if each else [],
        "accuracy_measured": [choice.measured for _, choice in each],
    }
    return {name: "; ".join(dict.fromkeys(texts)) for name, texts in found.items() if texts}


def _listed(errors: dict[str, float]) -> str:
    return ", ".join(f"{name} {error:.3g}" for name, error in errors.items())


def _with(content: dict[str, Any], settings: dict[str, Any]) -> dict[str, Any]:
    content = copy.deepcopy(content)
    for dotted, value in settings.items():
        _put(content, dotted, value)
    return content


def _put(content: dict[str, Any], dotted: str, value: Any) -> None:
    """Set a dotted key; ValueError where it is given already."""
    *parents, last = dotted.split(".")
    node = content
    for parent in parents:
        node = node.setdefault(parent, {})
        if not isinstance(node, dict):
            return  # pydantic says what is wrong with it
    if node.get(last) is not None:
        raise ValueError(f"give either accuracy or {dotted}, and not both: it would be {value!r}")
    node[last] = value
