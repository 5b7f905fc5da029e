"""Ways in which bodies leave a scene: through its opening, over its walls, or taken out by an event; each is counted apart."""

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from silostudy.dem.snapshot import length

# places (n, d) at the outlets' level -> numbers of their outlets; None: there is one
OutletAt: TypeAlias = Callable[[np.ndarray], np.ndarray] | None
WAYS = ("discharged", "spilt", "removed")  # in which bodies leave
DISCHARGED, SPILT, REMOVED = WAYS


def lowest(model, walls: Sequence) -> float:
    """Height (m) of the lowest place of walls; without walls nothing is below."""
    return min((float(ends[:, -1].min()) for ends in model.space.extents(walls)), default=-np.inf)


def below(engine, floor: float) -> np.ndarray:
    """Bodies that are wholly below the floor (m) and touch no other body any more; of cohesive ones, clumps that are."""
    height, largest = engine.bodies.rows[: engine.n, engine.space.place[-1]], engine.bodies.radius[: engine.n].max(initial=0.0)
    low = np.flatnonzero(height < floor + largest)  # none higher touches one that is wholly below
    place, radius = engine.bodies.rows[low][:, engine.space.place], engine.radius[low]
    gone, sunk = np.zeros(engine.n, bool), place[:, -1] < floor - radius
    if sunk.any():
        i, j = cKDTree(place).query_pairs(2.0 * largest, output_type="ndarray").T
        touch = length(place[i] - place[j]) <= radius[i] + radius[j]
        if engine.model.pair_contact.laws.cohesion.acts:
            sunk = whole_clumps(sunk, i[touch], j[touch])
        else:
            sunk[i[touch]] = sunk[j[touch]] = False
        gone[low[sunk]] = True
    return gone


def whole_clumps(sunk: np.ndarray, i: np.ndarray, j: np.ndarray) -> np.ndarray:
    """Mask of the bodies in clumps, held together by the pairs (i, j), that have sunk as a whole."""
    pairs = coo_array((np.ones(len(i)), (i, j)), shape=(len(sunk), len(sunk)))
    count, clump = connected_components(pairs, directed=False)
    return np.bincount(clump, ~sunk, count)[clump] == 0


def number_of(engine, what: tuple) -> int | None:
    """The engine's number of a body given by its label, or by a place (m) that it is nearest to; None: it is gone."""
    if len(what) == 1:
        places = np.flatnonzero(engine.labels == what[0])
        return int(places[0]) if len(places) else None
    place = engine.bodies.rows[: engine.n, engine.space.place]
    return int(np.argmin(length(place - np.asarray(what)))) if len(place) else None


class Over:
    """Bodies that went over a silo's walls, by label.

    It is told when a body is first seen below the silo: a base or a chute below may carry it anywhere afterwards.
    """

    def __init__(self, engine):
        self.level = lowest(engine.model, own_walls(engine.model))
        self.seen, self.went = np.zeros((2, engine.most), bool)

    def look(self, engine) -> None:
        """Tell of the bodies that have come below the silo since the last look."""
        height = engine.bodies.rows[: engine.n, engine.space.place[-1]]
        new = (height < self.level) & ~self.seen[engine.labels]
        if new.any():
            self.seen[engine.labels[new]] = True
            self.went[engine.labels[new]] = spilt(engine)[new]


def own_walls(model) -> list:
    """Walls of a silo's own body: inserts and free lines have two faces, or a front alone."""
    return [wall for wall in model.walls if wall.faces == 1]


def spilt(engine) -> np.ndarray:
    """Bodies that came below the outlet beside the silo: they went over its walls."""
    return engine.space.beside(own_walls(engine.model), at_level(engine))


def at_level(engine) -> np.ndarray:
    """Places (n, d; m) where bodies came below the outlet: where they would have come from without a contact below it."""
    rows, space = engine.bodies.rows[: engine.n], engine.space
    return rows[:, space.place] - rows[:, space.velocity] * ticks_below(engine)[:, None] * engine.model.dt


def ticks_below(engine) -> np.ndarray:
    """Ticks for which bodies have been below the outlet; none where they are not counted."""
    counted = engine.bodies.rows[: engine.n, list(engine.space.passed)]
    return np.rint(engine.ticks * counted.sum(axis=1))


def passing(engine, which: np.ndarray, outlet_at: OutletAt, since: int) -> list[tuple[float, float, int]]:
    """Times (s) from a tick on at which bodies among those left came below the outlet, each with mass and outlet's number."""
    ticks = ticks_below(engine)
    times = (engine.step - ticks) * engine.model.dt
    return _listed(engine, which & (ticks > 0.0) & (engine.step - ticks >= since), times, at_level(engine), outlet_at)


def drawn(engine, which: np.ndarray, outlet_at: OutletAt) -> list[tuple[float, float, int]]:
    """The same of bodies that a feeder takes now."""
    place = engine.bodies.rows[: engine.n, engine.space.place]
    return _listed(engine, which, np.full(engine.n, engine.time), place, outlet_at)


def _listed(engine, which, times, places, outlet_at: OutletAt) -> list[tuple[float, float, int]]:
    outlet = outlet_at(places) if outlet_at else np.zeros(engine.n, int)
    return [(float(times[i]), float(engine.mass[i]), int(outlet[i])) for i in np.flatnonzero(which)]
