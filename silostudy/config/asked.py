"""A study or scene may ask for an accuracy in place of settings: what that may say.

What is chosen for it hangs on the scenes and is not known here (see choice/): the settings that it decides are None.
"""

import copy
from collections.abc import Iterable
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field, field_validator, model_validator

from silostudy.config.fields import KeyMistake, Strict, described
from silostudy.tables.asked import quantities


class Asked(Strict):
    """Base of studies and scenes that may ask for an accuracy."""

    fronts: ClassVar[tuple[str, ...]]  # the measured fronts whose quantities it may ask for

    accuracy: dict[str, Annotated[float, Field(gt=0, lt=1)]] | None = described(
        "largest relative error by quantity (0.05: 5 %), in place of the settings that decide it: the cheapest measured are "
        "chosen",
        default=None,
    )
    kind: str

    @model_validator(mode="before")
    @classmethod
    def _leave_open(cls, content: Any) -> Any:
        """The content with None for every setting that the accuracy decides; KeyMistake where one is given all the same."""
        asked = content.get("accuracy") if isinstance(content, dict) else None
        if not isinstance(asked, dict):
            return content
        content = copy.deepcopy(content)
        for key in cls._decided(asked):
            put(content, key, None)
        return content

    @field_validator("accuracy")
    @classmethod
    def _known(cls, asked):
        known = quantities(cls.fronts)
        for name in asked or ():
            if name not in known:
                raise KeyMistake(name, f"unknown; known: {', '.join(known)}")
        return asked

    @model_validator(mode="after")
    def _nothing_else_is_open(self) -> Self:
        """None stands for a setting that an accuracy decides, and for that alone."""
        for key in self._decided(quantities(self.fronts)):
            *parents, last = key.split(".")
            node: Any = self
            for name in parents:
                node = getattr(node, name)
            if node is None or self.decides(key):
                continue
            if getattr(node, last) is None and type(node).model_fields[last].default is not None:
                raise KeyMistake(key, "must be given: no accuracy that decides it is asked for")
        return self

    def decides(self, key: str) -> bool:
        """Whether the accuracy asked for decides a setting."""
        return key in self._decided(self.accuracy or ())

    @classmethod
    def _decided(cls, asked: Iterable[str]) -> list[str]:
        """Dotted keys of the settings that the known of some quantities decide."""
        known = quantities(cls.fronts)
        return list(dict.fromkeys(key for name in asked if name in known for key in known[name].decides))


def put(content: dict[str, Any], dotted: str, value: Any) -> None:
    """Sets a dotted key in a content, its parents too; KeyMistake where it has a value already."""
    *parents, last = dotted.split(".")
    node = content
    for parent in parents:
        node = node.setdefault(parent, {})
        if node is None:
            raise KeyMistake(parent, f"is null, but the accuracy asked for decides {dotted}")
        if not isinstance(node, dict):
            return  # the models say what is wrong with it
    if node.get(last) is not None:
        raise KeyMistake(dotted, "give either accuracy or this, and not both: it is chosen for the accuracy")
    node[last] = value
