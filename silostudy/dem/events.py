"""What happens to a scene while it runs: events, the triggers they wait for, and what they do."""

from dataclasses import dataclass

from silostudy.catalogue import Entry, Family
from silostudy.errors import BadInput

ACTIONS = ("open", "open holes", "remove", "gravity", "friction", "stop")


@dataclass(frozen=True, kw_only=True)
class Trigger(Entry):
    """takes_value: whether it waits for a value; most: the largest one, where there is one."""

    takes_value: bool = True
    most: float | None = None


TRIGGERS: Family[Trigger] = Family(
    "trigger",
    [
        Trigger(key="time", title="s from the start"),
        Trigger(key="after", title="s from the event before"),
        Trigger(key="rest", title="at rest, by the scene's criterion", takes_value=False),
        Trigger(key="discharged", title="share of the mass that has left through the slit", most=1.0),
    ],
)


@dataclass(frozen=True)
class Event:
    """One event: it waits for its turn, then for its trigger, then acts.

    trigger: a key of TRIGGERS; value: its seconds or share.
    action: open (wall, walls that replace it), open holes (wall, names of its holes), remove (label or x, y), gravity (x, y),
    friction (pair, wall), stop.
    """

    trigger: str
    value: float
    action: str
    what: tuple = ()

    def __post_init__(self):
        most = TRIGGERS[self.trigger].most
        if most is not None and self.value > most:
            raise BadInput("value", self.value, f"must be a share, {most:g} or less, for the trigger {self.trigger}")
        if self.action not in ACTIONS:
            raise BadInput("action", self.action, f"unknown; known: {', '.join(ACTIONS)}")

    def __str__(self) -> str:
        value = f" {self.value:g}" if self.value else ""
        return f"{self.trigger}{value}: {self.action}"
