"""Choice of settings for an accuracy, and how a cube tells it."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Choice:
    """Errors asked for by quantity, settings by dotted key, the errors expected of them, where and when they were measured."""

    asked: dict[str, float]
    settings: dict[str, Any]
    expected: dict[str, float]
    measured: str


def promises(choices: Iterable[Choice]) -> dict[str, str]:
    """Attributes of a cube: everything asked, chosen and measured, and the worst error expected; none without a choice."""
    made = list(choices)
    worst: dict[str, float] = {}
    for choice in made:
        worst |= {name: max(error, worst.get(name, 0.0)) for name, error in choice.expected.items()}
    texts_by_name = {
        "accuracy_asked": [_listed(choice.asked) for choice in made],
        "accuracy_settings": [", ".join(f"{key} = {value}" for key, value in choice.settings.items()) for choice in made],
        "accuracy_expected": [_listed(worst)] if made else [],
        "accuracy_measured": [choice.measured for choice in made],
    }
    told = {name: "; ".join(dict.fromkeys(filter(None, texts))) for name, texts in texts_by_name.items()}
    return {name: text for name, text in told.items() if text}


def _listed(errors: dict[str, float]) -> str:
    return ", ".join(f"{name} {error:.3g}" for name, error in errors.items())
