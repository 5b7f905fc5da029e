"""The arch over a slit: the shortest chain of touching discs from one half of the floor to the other."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import shortest_path

from silostudy.dem.engine import Engine
from silostudy.dem.snapshot import pair_contacts, wall_contacts
from silostudy.scene.plane_silo import HALVES


@dataclass(frozen=True)
class Arch:
    """An arch. discs: labels from left foot to right; span: distance (m) of the feet; height (m) and label of the roof."""

    discs: tuple[int, ...]
    span: float
    height: float
    roof: int


def find_arch(engine: Engine) -> Arch | None:
    """The chain of fewest discs in touch with one another from the left half of the floor to the right; None without one."""
    pairs, walls = pair_contacts(engine), wall_contacts(engine)
    left, right = (walls.first[walls.second == engine.model.wall_number(name)] for name in HALVES)
    n = engine.most
    first = np.concatenate([pairs.first, np.full(len(left), n), right])
    second = np.concatenate([pairs.second, left, np.full(len(right), n + 1)])
    graph = coo_matrix((np.ones(len(first)), (first, second)), shape=(n + 2, n + 2)).tocsr()
    length, before = shortest_path(graph, directed=False, unweighted=True, indices=n, return_predecessors=True)
    if not np.isfinite(length[n + 1]):
        return None
    chain, link = [], before[n + 1]
    while link != n:
        chain.append(int(link))
        link = before[link]
    places = engine.places[chain[::-1]]
    highest = int(np.argmax(places[:, 1]))
    span = float(np.hypot(*(places[-1] - places[0])))
    return Arch(tuple(chain[::-1]), span, float(places[highest, 1]), chain[::-1][highest])
