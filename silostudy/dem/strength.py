"""Stiffness and damping of contacts, as the stability bound takes them."""

from collections.abc import Sequence

import numpy as np

from silostudy.contact.family import Touch
from silostudy.dem.model import Contact, Model

DEEP = 0.02  # of a radius: the overlap at which a curved law's slope is taken


def springs(of_rows: Sequence) -> Sequence:
    """The rows of a contact's laws, or of their coefficients, that may hold springs: all but cohesion."""
    normal, tangential, rolling, _, twisting = of_rows
    return normal, tangential, rolling, twisting


def stiffness_of(contact: Contact, model: Model, i, j, dt, deep: float = DEEP):
    """Normal, tangential (N/m per m), rolling and twisting (N m per m) stiffness of each contact.

    deep: overlap over the largest radius at which curved laws' slopes are taken.
    """
    touch, depth = touch_of(model, i, j, dt, deep), deep * float(model.radius.max())
    ways = zip(springs(contact.rows), springs(contact.ordered), strict=True)
    return [np.ones(len(i)) * row.stiffness(depth, touch, c) for row, c in ways]


def damping_of(contact: Contact, model: Model, i, j, dt, deep: float = DEEP):
    """Normal, tangential (N s/m per m), rolling and twisting damping of each contact, as its dashpots act at this step."""
    touch = touch_of(model, i, j, dt, deep)
    ways = zip(springs(contact.rows), springs(contact.ordered), strict=True)
    return [row.damping(touch, c) for row, c in ways]


def touch_of(model: Model, i, j, dt, deep: float = DEEP) -> Touch:
    """Reduced mass and radius of each contact."""
    mass, radius = (of[i] if j is None else 1.0 / (1.0 / of[i] + 1.0 / of[j]) for of in (model.mass, model.radius))
    return Touch(mass, radius, dt, deep * float(model.radius.max()))
