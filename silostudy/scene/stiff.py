"""Cautions on springs and dashpots of rolling and twisting that shorten the longest stable step of a scene."""

from collections.abc import Iterator

from silostudy.dem.contacts import Contact
from silostudy.dem.model import Model
from silostudy.dem.packed import least_of_kind, packed
from silostudy.dem.stability import longest_step
from silostudy.scene.coefficients import named_contacts

TURNING = ("rolling", "twisting")
SHORTER = 3.0  # times, from which it is told
NEXT_TO_NOTHING = 1e-9  # of a coefficient: some laws refuse none
CLOSE = 1e-2  # of a step, as closely as the ratio is asked for


def shortened_steps(model: Model, kinds: tuple[str, ...]) -> Iterator[str]:
    """A caution for each coefficient of a law of rolling or twisting without which steps could be SHORTER times as long."""
    for name, contact, kind, _ in named_contacts(model, kinds):
        body = least_of_kind(model, model.radius, kind)
        bound = _step(model, body, contact)
        for coefficient in (c for family in TURNING for c in getattr(contact.laws, family).coefficients):
            value, unit = contact.coefficients[coefficient.name], coefficient.unit
            times = _step(model, body, contact.changed({coefficient.name: NEXT_TO_NOTHING * value})) / bound
            if times > SHORTER:
                yield f"{name}: {coefficient.name} {value:g} {unit}: without it steps could be {times:.2g} times as long"


def _step(model: Model, body: int, contact: Contact) -> float:
    return longest_step(packed(model, body, contact, contact), close=CLOSE)
