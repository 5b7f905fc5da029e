"""The densest packings that the bodies of a scene may come to, of each kind alone: what bounds a step whatever happens."""

from dataclasses import replace

import numpy as np

from silostudy.dem.contacts import Contact
from silostudy.dem.model import Model
from silostudy.dem.snapshot import length

REACH = 4.5  # radii: size of the densest packing whose bound is taken


def packings(model: Model) -> list[Model]:
    """The smallest bodies of each kind in the densest order on a floor, with each contact that the kind has; larger ones are
    heavier, or touch fewer of them."""
    models = []
    for kind in range(model.kinds):
        smallest = least_of_kind(model, model.radius, kind)
        pairs = [model.between(kind, other) for other in range(model.kinds)]
        walls = [model.at_wall(kind, wall) for wall in range(len(model.walls))] or [model.wall_contact.numbered(0)]
        models += [packed(model, smallest, pair, wall) for pair in differing(pairs) for wall in differing(walls)]
    return models


def packed(model: Model, body: int, pair: Contact, wall: Contact) -> Model:
    """Bodies that are all like one of a model in the densest order on a floor."""
    r, space = float(model.radius[body]), model.space
    place = r * space.densest()
    place = place[length(place) < REACH * r]
    walls = (model.level_wall(2.0 * REACH * r, float(place[:, -1].min()) - r),)
    columns = dict(zip(model.columns, place.T, strict=False)) | dict.fromkeys(model.columns[space.ways + 1 :])
    contacts = {"pair_contact": pair, "wall_contact": wall}
    alike = {"radius": np.full(len(place), r), "density": float(np.broadcast_to(model.density, len(model.x))[body])}
    return replace(model, **(columns | alike | contacts | {"walls": walls, "waiting": 0, "kind": None}))


def least_of_kind(model: Model, values: np.ndarray, kind: int) -> int:
    """Number of the body of a kind that has the least of these values."""
    own = np.arange(len(values)) if model.kind is None else np.flatnonzero(model.kind == kind)
    return int(own[np.argmin(values[own])])


def differing(contacts: list[Contact]) -> list[Contact]:
    """The contacts that differ from all before them."""
    return [contact for number, contact in enumerate(contacts) if contact not in contacts[:number]]
