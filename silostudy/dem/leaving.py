"""How bodies leave a scene: through its opening, over its walls, or taken out by an event; each counts for itself."""

import numpy as np

from silostudy.dem.snapshot import length

DISCHARGED, SPILT, REMOVED = WAYS = ("discharged", "spilt", "removed")


def lowest(model) -> float:
    """Height (m) of the lowest place of a model's walls; without walls nothing is below."""
    return min((float(ends[:, -1].min()) for ends in model.space.extents(model.walls)), default=-np.inf)


def below(engine, floor: float) -> np.ndarray:
    """Which bodies are wholly below the floor (m) and touch no other body any more."""
    place, radius = engine.bodies.rows[: engine.n, engine.space.place], engine.radius
    gone = np.zeros(engine.n, bool)
    for i in np.flatnonzero(place[:, -1] < floor - radius):
        gap = length(place - place[i]) - radius - radius[i]
        gap[i] = np.inf
        gone[i] = not (gap <= 0.0).any()
    return gone


def spilt(engine) -> np.ndarray:
    """Which bodies are beside the silo: they went over its walls."""
    return engine.space.beside(engine.model.walls, engine.bodies.rows[: engine.n, engine.space.place])
