"""How discs leave a scene: through its opening, over its walls, or taken out by an event; each counts for itself."""

import numpy as np

from silostudy.dem.lanes import X, Y

DISCHARGED, SPILT, REMOVED = WAYS = ("discharged", "spilt", "removed")


def outside(model) -> tuple[np.ndarray, np.ndarray]:
    """Lowest and highest place (m) of a model's walls, x and y; without walls nothing is outside."""
    ends = np.array([end for wall in model.walls for end in (wall.start, wall.end)]).reshape(-1, 2)
    if not len(ends):
        return np.full(2, -np.inf), np.full(2, np.inf)
    return ends.min(axis=0), ends.max(axis=0)


def below(engine, floor: float) -> np.ndarray:
    """Which discs are wholly below the floor (m) and touch no other disc any more."""
    place, radius = engine.bodies.rows[: engine.n, :2], engine.radius
    gone = np.zeros(engine.n, bool)
    for i in np.flatnonzero(engine.column(Y) < floor - radius):
        gap = np.hypot(*(place - place[i]).T) - radius - radius[i]
        gap[i] = np.inf
        gone[i] = not (gap <= 0.0).any()
    return gone


def spilt(engine, low: float, high: float) -> np.ndarray:
    """Which discs are beside the silo (x outside low ... high, m): they went over its walls."""
    x = engine.column(X)
    return (x < low) | (x > high)
