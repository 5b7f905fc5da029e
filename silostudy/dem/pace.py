"""Pace of a run: so many ticks of its clock make a step, always as many, as many as its contacts bear, or more at rest."""

from dataclasses import dataclass

TINY = 1e-12  # slower than this is at rest
TICKS = 16  # in the step that a run begins with whose steps change
LONGEST = 4  # times that step, of steps that follow the contacts
SHARE = 0.9  # of what the contacts bear: they may be a fifth stiffer before they are looked at anew
RISE = 1.05  # a step grows by a twentieth at least, so that it does not change at every look
LIVELY = 0.1  # fastest body over the speed of a fall by its radius: while it is slower, little error of forces at rest comes in
OF_LARGEST = 0.3  # fastest body over the fastest since the last event: the same, where small gaps let none fall far


@dataclass(frozen=True)
class Pace:
    """Ticks in the first step and in the longest; share of the step that the contacts bear, 0: they are not asked.

    lively: speed over that of a fall by the radius (1) that the fastest body has below which steps get longer; 0: never.
    """

    share: float = 0.0
    ticks: int = 1
    longest: int = 1
    lively: float = 0.0

    @property
    def kind(self) -> str:
        """Word of a scene for how its steps change."""
        return "follow" if self.share else "longer_at_rest" if self.lively else "fixed"

    @property
    def changes(self) -> bool:
        """Whether steps change."""
        return self.kind != "fixed"

    @property
    def factor(self) -> float:
        """Step over that which follows freely or is made at rest (1); 0: steps stay."""
        return self.ticks / self.longest if self.lively else self.share / SHARE

    @property
    def usual(self) -> int:
        """Ticks of the step that looks at rest, discharge and drop-outs are counted in."""
        return self.longest if self.lively else self.ticks

    def after(self, ticks: int, borne: float, filling: bool = False) -> int:
        """Ticks of the steps that follow on steps of so many, where the contacts bear a step of `borne` ticks.

        No longer than the first while a silo is filled: what comes in makes other contacts before they are looked at anew.
        """
        allowed = min(self.ticks if filling else self.longest, max(1, int(self.share * borne)))
        return _changed(ticks, allowed)

    def at_speed(self, ticks: int, speed: float, largest: float) -> int:
        """Ticks of the steps that follow on steps of so many, where the fastest body has this speed over that of a fall (1).

        It moves no further in a step than in the first step at the speed `lively`, or at a share of the largest since an event.
        """
        lively = min(self.lively, OF_LARGEST * largest)
        allowed = min(self.longest, max(self.ticks, int(self.ticks * lively / max(speed, TINY))))
        return allowed if allowed == self.longest else _changed(ticks, allowed)


def _changed(ticks: int, allowed: int) -> int:
    """Ticks of a step where so many are allowed: fewer at once, more where they are a twentieth more."""
    return allowed if allowed < ticks or allowed >= RISE * ticks else ticks


FIXED = Pace()


def following(factor: float = 1.0) -> Pace:
    """Pace that follows the contacts, of steps that are a factor shorter."""
    return Pace(factor * SHARE, TICKS, LONGEST * TICKS)


def longer_at_rest(factor: float) -> Pace:
    """Pace of steps that are a factor shorter (1) while bodies move, and as long as the step that is chosen at rest."""
    return Pace(ticks=TICKS, longest=int(TICKS / factor), lively=LIVELY)
