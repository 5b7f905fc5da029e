"""The longest stable step of a run's contacts as they are, read without a bit of the run changing.

Slopes of curved laws are taken at the deepest overlap there is, or at the one that the two fastest bodies would come to if they
met head on: what may come before the contacts are looked at again.
"""

from dataclasses import replace

import numpy as np
from scipy.spatial import cKDTree

from silostudy.dem.model import Model
from silostudy.dem.snapshot import length
from silostudy.dem.stability import longest_step
from silostudy.dem.strength import stiffness_of

HEAD_ON = (
    1.2  # overlap of a Hertzian impact over speed times the root of mass over its stiffness there: a bit above the root of 5/4
)
TURNS = 8  # until that overlap and the stiffness there agree
NEARLY = 1e-2  # of an eigenvalue: how well a look knows it
LEAST = 1e-6  # of a radius: overlap of bodies that neither touch nor move


def stable_now(engine) -> float:
    """Longest stable time step (s) of the contacts that an engine's bodies have now, and of lone ones that may come."""
    model = present(engine)
    return longest_step(model, engine.walls, deepest(engine, model), NEARLY)


def present(engine) -> Model:
    """The model of the bodies that are there, where they are."""
    model, labels = engine.model, np.sort(engine.labels)
    ways = model.columns[: model.space.ways]
    places = engine.places[labels].T
    still = dict.fromkeys(model.columns[model.space.ways + 1 :])
    density = model.density if np.ndim(model.density) == 0 else model.density[labels]
    kind = None if model.kind is None else np.asarray(model.kind)[labels]
    pair, wall = engine.contacts
    return replace(
        model, **dict(zip(ways, places, strict=True)), **still, radius=model.radius[labels], density=density, kind=kind,
        pair_contact=pair, wall_contact=wall, waiting=0, quake=None, end=None,
    )  # fmt: skip


def deepest(engine, model: Model) -> float:
    """Overlap (1) over the largest radius: the deepest there is, or that of the fastest bodies head on."""
    place, radius = model.place, model.radius
    i, j = cKDTree(place).query_pairs(2.0 * radius.max(), output_type="ndarray").reshape(-1, 2).T
    overlap = [radius[i] + radius[j] - length(place[i] - place[j])]
    walls = engine.walls
    overlap += [radius - length(model.space.all_from_wall(walls.shape, q, place)) for q in np.flatnonzero(walls.live)]
    largest = float(radius.max())
    return max(LEAST, max(float(values.max(initial=0.0)) for values in overlap) / largest, head_on(engine, model))


def head_on(engine, model: Model) -> float:
    """Overlap (1) over the largest radius to which two bodies press each other that meet at twice the fastest's speed."""
    speed = 2.0 * float(length(engine.bodies.rows[: engine.n, engine.space.velocity]).max())
    light, share = np.array([int(np.argmax(model.mass))]), 0.02
    contact = model.between(0, 0)
    for _ in range(TURNS):
        stiffness = float(stiffness_of(contact, model, light, light, model.dt, share)[0][0])
        mass = 0.5 * float(model.mass[light[0]])
        share = HEAD_ON * speed * (mass / stiffness) ** 0.5 / float(model.radius.max()) if stiffness else 0.0
        share = max(share, LEAST)
    return share
