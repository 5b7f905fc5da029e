"""Snapshots: the contacts of this instant with their forces, read without disturbing the run."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from numba import njit

from silostudy.contact.family import Touch
from silostudy.dem.arrays import aligned
from silostudy.dem.cache import OPTIONS, named
from silostudy.dem.contacts import Contact
from silostudy.dem.dimension import Dimension
from silostudy.dem.force import force_pass
from silostudy.dem.history import entry
from silostudy.dem.ledger import of_spring
from silostudy.dem.pieces import Laws


@dataclass(frozen=True)
class ContactForces:
    """Touching contacts: labels of the bodies (the second may be a wall), place (m), force on the first (N/m, N)."""

    first: np.ndarray
    second: np.ndarray
    place: np.ndarray
    force: np.ndarray

    @property
    def table(self) -> np.ndarray:
        """A row a contact: first, second, place, force."""
        return np.column_stack([self.first, self.second, self.place, self.force])


@cache
def reader(space: Dimension, laws: Laws, unequal: bool, flat: bool, varied: bool, moving: bool):
    """Compiled function that computes the forces of a list without changing its histories."""
    forces = force_pass(space, laws, unequal=unequal, flat=flat, varied=varied, moving=moving)
    force_of, stretch = space.force_of, space.stretch

    def read(rows, contacts, shape, count, lanes, out, total, stored, rolled, dt, c):
        for start in range(0, count, stretch):
            many = min(stretch, count - start)
            forces(rows, contacts, shape, start, many, lanes, out, stored, rolled, dt, c)
            for k in range(many):
                force = force_of(out, k)
                for way in range(len(force)):
                    total[start + k, way] = force[way]

    return njit(**OPTIONS)(named(read, repr((space, laws, unequal, flat, varied, moving))))


def _forces(engine, part, contacts, count, flat):
    """Force (count, d) of each contact of a part's list on its first body."""
    space, unequal, contact = engine.space, engine.model.unequal, engine.contacts[flat]
    total = np.zeros((count, space.ways))
    lanes, out = aligned(*space.lanes), aligned(*space.forces)
    read = reader(space, contact.laws, unequal, flat, part.varied[flat], flat and engine.model.moving)
    stored, rolled = contacts.stored[..., :count].copy(), contacts.rolled[..., :count].copy()
    contacts, c = contacts._replace(twisted=contacts.twisted.copy(), touched=contacts.touched.copy()), engine.coefficients(part)
    read(engine.bodies.rows, contacts, engine.walls.shape, count, lanes, out, total, stored, rolled, engine.past_dt, c[flat])
    return total


def pair_contacts(engine) -> ContactForces:
    """Every touching pair once, in the order of the engine's own numbers, first before second."""
    engine.list_contacts()
    columns = []
    for part in engine.parts:
        last = engine.blocks_of(part)
        count = int(part.pairs.begin[last + 1])
        force = _forces(engine, part, part.pairs, count, False)
        lo, _ = engine.bounds(part.number)
        first, second = (engine.true_number(part, column[:count]) for column in part.pairs[:2])
        touching = force.any(axis=1) & (first >= lo)
        columns.append((first[touching], second[touching], force[touching]))
    i, j, force = (np.concatenate(column) for column in zip(*columns, strict=True))
    place, radius = engine.bodies.rows[:, engine.space.place], engine.radius
    share = (radius[i] / (radius[i] + radius[j]))[:, None]
    return ContactForces(engine.labels[i], engine.labels[j], place[i] + (place[j] - place[i]) * share, force)


def wall_contacts(engine) -> ContactForces:
    """Every body that touches a wall, with the number of the wall."""
    engine.list_contacts()
    columns = []
    for part in engine.parts:
        count = int(part.near.begin[0])
        force = _forces(engine, part, part.near, count, True)
        touching = force.any(axis=1)
        columns.append((part.near.first[:count][touching], part.near.second[:count][touching], force[touching]))
    i, q, force = (np.concatenate(column) for column in zip(*columns, strict=True))
    place = engine.bodies.rows[i][:, engine.space.place]
    return ContactForces(engine.labels[i], q, place - from_walls(engine, q, place), force)


def snapshot(engine) -> dict[str, np.ndarray]:
    """Places, velocities and force chains now."""
    return {
        "time": np.array(engine.time),
        "label": engine.labels.copy(),
        "motion": engine.bodies.rows[: engine.n, : engine.space.motion].copy(),
        "pairs": pair_contacts(engine).table,
        "walls": wall_contacts(engine).table,
    }


def from_walls(engine, walls: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Vector (n, d; m) from the nearest point of each wall to each place."""
    space, shape = engine.space, engine.walls.shape
    away = [space.nearest(shape, wall, *place)[: space.ways] for wall, place in zip(walls, places, strict=True)]
    return np.array(away).reshape(-1, space.ways)


def held_energy(engine) -> float:
    """Elastic energy (J/m) of all contacts now, in their springs and in their attraction; of one thread's lists."""
    engine.list_contacts()
    (part,) = engine.parts
    place, radius = engine.bodies.rows[: engine.n, engine.space.place], engine.radius
    pairs, walls = engine.contacts
    i, j, which, *histories = _listed(part.pairs, int(part.pairs.begin[engine.blocks_of(part) + 1]), engine.n)
    overlaps = radius[i] + radius[j] - length(place[i] - place[j])
    total = _energy([pairs.numbered(n) for n in which], _touches(engine, i, j), overlaps, *histories)
    i, q, which, *histories = _listed(part.near, int(part.near.begin[0]), engine.n)
    away = length(from_walls(engine, q, place[i]))
    return total + _energy([walls.numbered(n) for n in which], _against_walls(engine, i, q), radius[i] - away, *histories)


def length(vectors: np.ndarray) -> np.ndarray:
    """Lengths of vectors (n, d)."""
    return np.hypot(*vectors.T) if vectors.shape[-1] == 2 else np.linalg.norm(vectors, axis=-1)


def _touches(engine, i, j=None) -> list[Touch]:
    """Reduced mass and radius of each contact of discs i with discs j, or with walls."""
    mass, radius = (of[i] if j is None else 1.0 / (1.0 / of[i] + 1.0 / of[j]) for of in (engine.mass, engine.radius))
    return [Touch(*numbers, engine.past_dt) for numbers in zip(mass, radius, strict=True)]


def _against_walls(engine, i, walls) -> list[Touch]:
    """Reduced mass and radius of each contact of bodies i with walls, which may be bent."""
    place, space = engine.bodies.rows[:, engine.space.place], engine.space
    bent = [space.bent(engine.walls.shape, q, *spot) for q, spot in zip(walls, place[i], strict=True)]
    radius = engine.radius[i]
    return [Touch(*numbers, engine.past_dt) for numbers in zip(engine.mass[i], radius / (1.0 - radius * bent), strict=True)]


def _listed(contacts, count: int, n: int):
    """First, second, set of coefficients, and all histories (zero where none is kept) of a list, without what pads it."""
    real = np.flatnonzero(contacts.first[:count] < n)
    histories = contacts.stored, contacts.rolled, contacts.twisted, contacts.touched
    which = contacts.which[real] if len(contacts.which) > 1 else np.zeros(len(real), int)
    return [contacts.first[real], contacts.second[real], which, *([entry(history, k) for k in real] for history in histories)]


def _energy(contacts: list[Contact], touches, overlaps, *histories) -> float:
    """Energy (J/m) of those contacts of a list that touch."""
    total = 0.0
    for contact, touch, overlap, held, turned, twisted, touched in zip(contacts, touches, overlaps, *histories, strict=True):
        normal, tangential, rolling, (attraction, c), twisting = zip(contact.rows, contact.ordered, strict=True)
        if overlap <= (-attraction.gap(touch.radius, c) if touched else 0.0):
            continue
        depth = attraction.pressed(overlap, touch.radius, c)
        touch = touch._replace(overlap=depth)
        total += normal[0].energy(depth, touch, normal[1]) + attraction.energy(touch, c)
        for (law, values), force in ((tangential, held), (rolling, turned), (twisting, twisted)):
            total += of_spring(force, law.stiffness(depth, touch, values))
    return float(total)
