"""Cautions on linear springs too soft for what all the grains weigh; of curved ones the overlap is told for every scene."""

from collections.abc import Iterator

import numpy as np

from silostudy.dem.model import Model
from silostudy.dem.strength import stiffness_of
from silostudy.scene.cautions import DEEP


def soft_springs(model: Model, kinds: tuple[str, ...], area: float) -> Iterator[str]:
    """A caution for each kind of grains whose linear spring gives way by more than DEEP of a radius at the foot of all others.

    area: of the silo's plan (m2; in the plane its width, m), by which the weight of all grains is a pressure.
    """
    pressure = float(model.mass.sum()) * max(-model.gravity[-1], 0.0) / area
    for kind, name in enumerate(kinds):
        contact = model.between(kind, kind)
        own = np.arange(len(model.x)) if model.kind is None else np.flatnonzero(model.kind == kind)
        if contact.laws.normal.of_hertz or not len(own):
            continue
        body = own[[np.argmax(model.radius[own])]]
        radius = float(model.radius[body[0]])
        force = pressure * (2.0 * radius) ** (model.space.ways - 1)
        deep = force / float(np.ravel(stiffness_of(contact, model, body, body, 0.0)[0])[0]) / radius
        if deep > DEEP:
            who = f"{model.space.body}s" if len(kinds) == 1 else name
            told = f"all that is there presses the lowest {deep:.2g} of the radius into each other"
            yield f"{who}: {told}; beyond {DEEP:.0%} contacts are too soft for it"
