"""Events of any grains that put down, press or move a lid, or start a feeder under the outlet."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, Self

from pydantic import model_validator

from silostudy.config.fields import KeyMistake, described
from silostudy.config.run import Waiting
from silostudy.dem.events import TRIGGERS

OF_LID = ("lower_lid", "press_lid", "move_lid")
EITHER_WAY = ("move_lid", "run_belt")  # whose speed may be 0 or less
ABOUT = ("surfaces", "outlets", "sphere", "disc")  # keys that say on what an event acts


@dataclass(frozen=True)
class Takes:
    """Title of something to do, the fields that it needs, and those that it may have beside them."""

    title: str
    needs: tuple[str, ...] = ()
    may: tuple[str, ...] = ()


class MovingEvent(Waiting):
    """One event: it waits for the event before it, then for its trigger, then acts."""

    takes: ClassVar[Mapping[str, Takes]] = {
        "lower_lid": Takes("the lid comes down to the highest grain"),
        "press_lid": Takes("the lid is pressed onto the grains", ("stress_kPa",), ("speed_m_s", "lid_mass_kg")),
        "move_lid": Takes("the lid moves at a speed", ("speed_m_s",), ("until_stress_kPa", "until_height_m")),
        "feed": Takes("a feeder takes grains at a rate", ("rate_kg_s",)),
        "stop": Takes("the run ends"),
    }
    if TYPE_CHECKING:
        do: Any  # each kind of grains does its own

    stress_kPa: float | None = described(
        "press_lid: mean pressure that the lid comes to rest under, its own weight included; it bears down as a body of "
        "lid_mass_kg in a drag of load over speed_m_s, until its load is borne",
        "kPa",
        gt=0,
        default=None,
    )
    speed_m_s: float | None = described(
        "move_lid: downward, negative lifts the lid, 0 stops it; press_lid: speed where nothing resists, null: 0.1",
        "m s-1",
        default=None,
    )
    lid_mass_kg: float | None = described(
        "press_lid: inertia of the lid (of discs a metre thickness); null: the mass of all grains", "kg", gt=0, default=None
    )
    until_stress_kPa: float | None = described(
        "move_lid: it stops in the step in which the grains press it with this mean pressure", "kPa", gt=0, default=None
    )
    until_height_m: float | None = described(
        "move_lid: it stops at this height above the outlet; null: where the vertical walls begin or end",
        "m",
        ge=0,
        default=None,
    )
    rate_kg_s: float | None = described(
        "feed: a feeder under the closed outlet takes grains so fast, the lowest first (of discs a metre thickness); 0: none",
        "kg s-1",
        ge=0,
        default=None,
    )

    @property
    def of_lid(self) -> bool:
        """Whether it needs a lid."""
        return self.do in OF_LID or TRIGGERS[self.when].of_lid

    @property
    def asks_for_lid(self) -> str:
        """The key by which an event asks for a lid: what it does, what it waits for, or else the surfaces that it is about."""
        return "do" if self.do in OF_LID else "when" if TRIGGERS[self.when].of_lid else "surfaces"

    @property
    def given(self) -> dict[str, Any]:
        """Values by key that say on what it acts and how."""
        own = self.model_fields_set - {"do", "when", "value"}
        values = {name: getattr(self, name) for name in type(self).model_fields if name in own}
        return {name: value for name, value in values.items() if value not in (None, ())}

    @property
    def said(self) -> str:
        """Words of the scene on what it does, on what, and with which values."""
        on = [text_of(value, ", ") for name, value in self.given.items() if name in ABOUT]
        values = [f"{name} {text_of(value, ' ')}" for name, value in self.given.items() if name not in ABOUT]
        return " ".join([self.do, *on]) + (f": {', '.join(values)}" if values else "")

    @model_validator(mode="after")
    def _has_what_it_takes(self) -> Self:
        taken = self.takes[self.do]
        for name in taken.needs:
            if name not in self.given:
                raise KeyMistake(name, f"must be given where do is {self.do}")
        for name in sorted(self.given.keys() - {*taken.needs, *taken.may}):
            raise KeyMistake(name, f"{self.do} takes no {name}; it takes {', '.join((*taken.needs, *taken.may)) or 'nothing'}")
        if self.do not in EITHER_WAY and self.speed_m_s is not None and not self.speed_m_s > 0.0:
            raise KeyMistake("speed_m_s", f"must be above 0 where do is {self.do}")
        return self


def text_of(value: Any, between: str) -> str:
    """A value of a key in words; between: what stands between those of a list."""
    return between.join(map(str, value)) if isinstance(value, tuple) else str(value)
