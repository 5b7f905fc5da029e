"""Rain: bodies that come in on a level plane, so many a second, each where it touches nothing."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from silostudy.dem.change import add_bodies
from silostudy.dem.snapshot import length

TRIES = 60  # spots that are looked at for a body before it waits for the next turn
WAITS = 5.0  # times that a body needs to fall by its diameter: after so long without room the plane is buried


@dataclass(frozen=True)
class Rain:
    """Bodies that rain in: rate (1/s), velocity (m/s) and level (m) of those that come; spots(random, radius, count) -> places
    (count, d) on that level.

    seed: with the step it gives the spots, so that they are the same wherever a run is cut.
    """

    rate: float
    velocity: tuple[float, ...]
    level: float
    spots: Callable[[np.random.Generator, float, int], np.ndarray]
    seed: int = 0

    def due(self, time: float) -> float:
        """Number of bodies that should have come at a time (s)."""
        return 1.0 + self.rate * time

    def fall(self, engine) -> float:
        """Time (s) that the largest body needs to fall by its diameter; infinite without gravity."""
        pull = float(np.hypot.reduce(engine.gravity))
        return float(np.sqrt(4.0 * float(engine.model.radius.max()) / pull)) if pull else np.inf

    def patience(self, engine) -> float:
        """Time (s) without room after which the plane counts as buried."""
        return WAITS * self.fall(engine)


def pour(engine, rain: Rain, first: int, last: int) -> int:
    """Let the bodies with labels from first to before last in, in order, as far as there is room; gives how many came."""
    random = np.random.default_rng([rain.seed, engine.step])
    radius = engine.model.radius
    place = engine.bodies.rows[: engine.n, engine.space.place]
    near = np.abs(place[:, -1] - rain.level) < engine.radius + radius[first:last].max(initial=0.0)
    taken, reach = place[near], engine.radius[near]
    spots: list[np.ndarray] = []
    for label in range(first, last):
        spot = _free(rain.spots(random, radius[label], TRIES), radius[label], taken, reach)
        if spot is None:
            break
        spots.append(spot)
        taken, reach = np.vstack([taken, spot]), np.append(reach, radius[label])
    if spots:
        add_bodies(engine, np.arange(first, first + len(spots)), np.array(spots), rain.velocity)
    return len(spots)


def delay(run) -> str:
    """Lateness of the last body that a run's rain let in, in words; empty where the rain kept its rate."""
    engine, rain = run.engine, run.rain
    if rain is None or run.began:
        return ""
    came = run.came * engine.model.dt
    late = came - (run.come - 1) / rain.rate
    if late <= rain.fall(engine):
        return ""
    return f"{engine.space.body} {run.come} came in at {came:.3g} s, {late:.3g} s late: no room for the filling's rate"


def _free(spots: np.ndarray, radius: float, taken: np.ndarray, reach: np.ndarray) -> np.ndarray | None:
    """The first spot at which a body touches no other; None where there is none."""
    for spot in spots:
        if (length(taken - spot) >= radius + reach).all():
            return spot
    return None
