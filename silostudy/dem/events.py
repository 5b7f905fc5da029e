"""Events of a scene while it runs, the triggers they wait for, and what they do."""

from dataclasses import dataclass, field

from silostudy.catalogue import Entry, Family
from silostudy.errors import BadInput

ACTIONS = (
    "open",
    "open holes",
    "take away",
    "remove",
    "gravity",
    "friction",
    "lower",
    "press",
    "move",
    "turn",
    "run",
    "feed",
    "stop",
)


@dataclass(frozen=True, kw_only=True)
class Trigger(Entry):
    """Condition that an event waits for. takes_value: whether it has a value; most: the largest one, where there is one.

    scale: SI units in one of the value's; of_lid: whether it is a lid's.
    """

    takes_value: bool = True
    scale: float = 1.0
    of_lid: bool = False
    most: float | None = None


TRIGGERS: Family[Trigger] = Family(
    "trigger",
    [
        Trigger(key="time", title="s from the start"),
        Trigger(key="after", title="s from the event before"),
        Trigger(key="rest", title="at rest, by the scene's criterion", takes_value=False),
        Trigger(key="discharged", title="share of the mass that has left through the slit", most=1.0),
        Trigger(key="lid_stress", title="kPa of mean pressure on the lid, or more", scale=1e3, of_lid=True),
        Trigger(key="lid_rests", title="the lid has stopped, or bears its load", takes_value=False, of_lid=True),
    ],
)


@dataclass(frozen=True)
class Event:
    """One event: it waits for its turn, then for its trigger, then acts.

    trigger: a key of TRIGGERS; value: its seconds, share or Pa.
    action: open (wall, walls that replace it), open holes (wall, names of its holes, speed), take away (walls), remove (label
    or place), gravity (vector), friction (pair, wall, names of walls; none: all), stop; of walls that move lower (),
    press (load, mass, speed, lowest), move (speed, force, height), turn (spin, walls), run (speed or velocity, walls);
    feed (rate).
    said: what it does, on what and with which values, in the words of a scene's file; "": action has no others.
    """

    trigger: str
    value: float
    action: str
    what: tuple = ()
    said: str = field(default="", compare=False)

    def __post_init__(self):
        most = TRIGGERS[self.trigger].most
        if most is not None and self.value > most:
            raise BadInput("value", self.value, f"must be a share, {most:g} or less, for the trigger {self.trigger}")
        if self.action not in ACTIONS:
            raise BadInput("action", self.action, f"unknown; known: {', '.join(ACTIONS)}")

    def __str__(self) -> str:
        value = f" {self.value:g}" if self.value else ""
        return f"{self.trigger}{value}: {self.told()}"

    def told(self, on: str = "") -> str:
        """Words on what it does, on what, and with which values; on: what it found there, where that is known by then."""
        does, _, values = (self.said or self.action).partition(": ")
        if on:
            does = f"{does.partition(' ')[0] if self.said else does} {on}"
        return f"{does}: {values}" if values else does


def acted_at(run) -> int:
    """Tick from which the next event counts: when this one was due, where a step went over it, so that times add up."""
    due, step = run.due(), run.engine.step
    return due if due > step - run.engine.past else step
