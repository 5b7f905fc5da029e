"""Restitution (1) that the finite step leaves two bodies with after a head-on impact."""

import numpy as np

from silostudy.contact.family import Touch
from silostudy.dem.contacts import Contact
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.model import Model
from silostudy.dem.packed import least_of_kind

PHASES = 16  # places within a step at which the impact begins
MOST = 100_000  # steps that an impact is followed for


def restitutions(model: Model, speed: float, kind: int = 0) -> np.ndarray:
    """Restitution (1) at the model's step of the two lightest of a kind that close at a speed (m/s), by phase of the step.

    Integrated by the model's own scheme and normal law; a contact that pulls has none.
    """
    body = least_of_kind(model, model.mass, kind)
    reduced = model.mass[body] / 2.0, model.radius[body] / 2.0
    contact, phases = model.between(kind, kind), (np.arange(PHASES) + 0.5) / PHASES
    return np.array([_apart(contact, reduced, model.integrator, model.dt, speed, phase) for phase in phases]) / speed


def _apart(contact: Contact, reduced: tuple[float, float], integrator: str, dt: float, speed: float, phase: float) -> float:
    """Speed (m/s) at which two bodies come apart that were a share of a step's way from each other before the first step."""
    advance, law, c = INTEGRATORS[integrator].advance, contact.laws.normal.law, contact.ordered[0]
    depth, closing, held, pushed = -phase * speed * dt, speed, speed, False
    for _ in range(MOST):
        before = depth - closing * dt
        touch = Touch(*reduced, dt, max(depth, 0.0), closing, before)
        force = law(depth, closing, touch, c)[1] if depth > 0.0 else 0.0
        if pushed and depth <= 0.0:
            break
        pushed = pushed or depth > 0.0
        closing, held, way = advance(closing, held, -force / reduced[0], dt, dt)
        depth += way
    return -(held if INTEGRATORS[integrator].holds else closing)
