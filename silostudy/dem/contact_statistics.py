"""Statistics of the contacts of an instant: how many a body has, which way they stand, how many slide, how deep they are."""

from typing import NamedTuple

import numpy as np

from silostudy.contact import spring
from silostudy.dem.coarse import branches
from silostudy.dem.snapshot import ContactForces, length, pair_contacts, wall_contacts
from silostudy.dem.varied import set_of_pair

HELD = 2  # contacts that a body needs to be held: one with fewer is a rattler
SLIDING = 0.999  # of friction times normal force: from there on a contact counts as sliding


class Statistics(NamedTuple):
    """Numbers without unit.

    coordination: contacts of a body, walls counted; held_coordination: of those that are held, rattlers and their contacts left
    out; rattlers: share of all bodies; fabric (d, d): mean dyad of the normals of pairs; anisotropy: its largest less its least
    principal value; sliding: share of the pairs; overlaps: over the smaller radius.
    """

    coordination: float
    held_coordination: float
    rattlers: float
    fabric: np.ndarray
    anisotropy: float
    sliding: float
    mean_overlap: float
    deepest_overlap: float


def statistics(engine) -> Statistics:
    """Statistics of the engine's contacts now; NaN where there is nothing to count."""
    pairs, walls = pair_contacts(engine), wall_contacts(engine)
    _, branch, _ = branches(engine, pairs, walls)
    fabric, overlaps = fabric_of(branch[: len(pairs.first)]), overlaps_of(engine, pairs, walls, branch)
    spread = float(np.ptp(np.linalg.eigvalsh(fabric))) if np.isfinite(fabric).all() else np.nan
    mean, deepest = (float(overlaps.mean()), float(overlaps.max())) if len(overlaps) else (np.nan, np.nan)
    sliding = sliding_share(engine, pairs, branch[: len(pairs.first)])
    return Statistics(*coordination(engine, pairs, walls), fabric, spread, sliding, mean, deepest)


def coordination(engine, pairs: ContactForces, walls: ContactForces) -> tuple[float, float, float]:
    """Mean number of contacts of a body, the same without rattlers, and the share of those."""
    ends = np.concatenate([pairs.first, pairs.second, walls.first])
    count = np.bincount(ends, minlength=engine.most)
    held = count >= HELD
    both = held[pairs.first] & held[pairs.second]
    left = 2 * int(both.sum()) + int(held[walls.first].sum())
    return len(ends) / engine.n, left / held.sum() if held.any() else np.nan, 1.0 - float(held.sum()) / engine.n


def fabric_of(branch: np.ndarray) -> np.ndarray:
    """Fabric tensor (d, d; 1): mean of n n over the directions n of branches (n, d); its trace is 1."""
    normal = branch / length(branch)[:, None]
    with np.errstate(invalid="ignore"):
        return normal.T @ normal / np.float64(len(normal))


def sliding_share(engine, pairs: ContactForces, branch: np.ndarray) -> float:
    """Share (1) of pairs whose tangential force is friction times normal force; NaN without friction or with an attraction.

    An attraction is no part of what friction takes, or not all of it: the whole normal force does not tell the cap then.
    """
    contact = engine.contacts[0]
    if spring.FRICTION not in contact.laws.tangential.coefficients or not len(branch) or contact.laws.cohesion.acts:
        return np.nan
    kind = np.empty(engine.most, int)
    kind[engine.labels] = engine.kind
    sets, which = np.unique(set_of_pair(kind[pairs.first], kind[pairs.second]), return_inverse=True)
    friction = np.array([contact.numbered(number).coefficients[spring.FRICTION.name] for number in sets])[which]
    normal = branch / length(branch)[:, None]
    pressing = (pairs.force * normal).sum(axis=1)
    drag = length(pairs.force - pressing[:, None] * normal)
    return float((drag >= SLIDING * friction * np.maximum(pressing, 0.0)).mean())


def overlaps_of(engine, pairs: ContactForces, walls: ContactForces, branch: np.ndarray) -> np.ndarray:
    """Overlap of every contact over the smaller radius of its bodies (1)."""
    radius = np.empty(engine.most)
    radius[engine.labels] = engine.radius
    a, b = radius[pairs.first], radius[pairs.second]
    gap = length(branch)
    of_pairs, at_walls = a + b - gap[: len(a)], radius[walls.first] - gap[len(a) :]
    return np.concatenate([of_pairs / np.minimum(a, b), at_walls / radius[walls.first]])
