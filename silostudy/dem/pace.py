"""Pace of a run: so many ticks of its clock make a step, always as many or as many as its contacts bear."""

from dataclasses import dataclass

TICKS = 16  # in the step that a run begins with whose steps follow its contacts
LONGEST = 4  # times that step
SHARE = 0.9  # of what the contacts bear: they may be a fifth stiffer before they are looked at anew
RISE = 1.05  # a step grows by a twentieth at least, so that it does not change at every look


@dataclass(frozen=True)
class Pace:
    """Ticks in the first step and in the longest; share of the step that the contacts bear, 0: the first step stays."""

    share: float = 0.0
    ticks: int = 1
    longest: int = 1

    @property
    def kind(self) -> str:
        """Whether steps follow the contacts or stay."""
        return "follow" if self.share else "fixed"

    @property
    def factor(self) -> float:
        """Step over that which follows freely (1); 0: steps stay."""
        return self.share / SHARE

    def after(self, ticks: int, borne: float, filling: bool = False) -> int:
        """Ticks of the steps that follow on steps of so many, where the contacts bear a step of `borne` ticks.

        No longer than the first while a silo is filled: what comes in makes other contacts before they are looked at anew.
        """
        allowed = min(self.ticks if filling else self.longest, max(1, int(self.share * borne)))
        return allowed if allowed < ticks or allowed >= RISE * ticks else ticks


FIXED = Pace()


def following(factor: float = 1.0) -> Pace:
    """Pace that follows the contacts, of steps that are a factor shorter."""
    return Pace(factor * SHARE, TICKS, LONGEST * TICKS)
