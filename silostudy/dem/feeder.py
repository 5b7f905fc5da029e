"""A feeder under a closed outlet: it takes bodies away at a rate of mass, one at a time, the lowest over the outlet first.

It has no parts of its own: a body that has come down onto the plug of the outlet is taken when its mass is due.  Where none has
come down, the feeder waits, and what it could not take then it does not make up for.
"""

from collections.abc import Callable

import numpy as np

SLACK = 0.005  # of the mass that was due: what is missed by chance
DOWN = 0.05  # of its radius: a body whose gap to the plug is smaller has come down


class Feeder:
    """Feeder under an outlet, still until its rate (kg/s) is set. mouth(places) -> mask of places (n, d; m) over it."""

    def __init__(self, mouth: Callable[[np.ndarray], np.ndarray], plug: float = 0.0):
        self.mouth, self.plug = mouth, plug  # plug: its height, m
        self.rate, self.owed = 0.0, 0.0  # owed: mass that is due, kg
        self.asked, self.missed = 0.0, 0.0  # mass that was due, and of that what had not come down in time, kg

    @property
    def stand(self) -> tuple[float, ...]:
        """Rate (kg/s), then masses (kg) owed, asked for and missed: all that going on depends on."""
        return self.rate, self.owed, self.asked, self.missed

    @stand.setter
    def stand(self, held: tuple[float, ...]) -> None:
        self.rate, self.owed, self.asked, self.missed = held

    def take(self, engine, seconds: float) -> np.ndarray:
        """Bodies that it takes within some seconds more."""
        self.owed += self.rate * seconds
        self.asked += self.rate * seconds if engine.n else 0.0
        place, radius, mass = engine.bodies.rows[: engine.n, engine.space.place], engine.radius, engine.mass
        gap = place[:, -1] - radius - self.plug
        ready = np.flatnonzero((gap < DOWN * radius) & self.mouth(place)) if self.rate > 0.0 else np.zeros(0, int)
        ready = ready[np.argsort(gap[ready], kind="stable")]
        count = int(np.searchsorted(np.cumsum(mass[ready]), self.owed, side="right"))
        self.owed -= float(mass[ready[:count]].sum())
        if count == len(ready):
            most = min(self.owed, float(mass.max(initial=0.0)))
            self.missed += self.owed - most if engine.n else 0.0
            self.owed = most
        return np.isin(np.arange(engine.n), ready[:count])


def shortfall(run) -> str:
    """Mass that a run's feeder was to take and could not, in words; empty where it kept its rate."""
    feeder = run.feeder
    if feeder is None or feeder.missed <= SLACK * feeder.asked:
        return ""
    share, unit = 100.0 * feeder.missed / feeder.asked, "kg/m" if run.engine.space.ways == 2 else "kg"
    return f"the feeder took {share:.2g} % less than the {feeder.asked:.3g} {unit} asked for: no more grains came down in time"
