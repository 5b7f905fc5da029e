"""Explosions: what ends a run that cannot go on, and the cause as far as the body tells it."""

import numpy as np

from silostudy.dem.sweep import EXPLODED


class Explosion(RuntimeError):
    """A disc moved more than its radius in a step, is pressed half through another body, or is not finite.

    What was recorded up to then is kept.
    """

    def __init__(self, disc: int, step: int, dt: float, cause: str, body: str = "disc"):
        self.disc, self.step, self.time, self.cause = disc, step, step * dt, cause
        super().__init__(f"{body} {disc} ran away at t = {step * dt:.6g} s: {cause}")


def explosion_of(engine) -> Explosion:
    """The explosion of the body that a thread has told of."""
    part = int(np.argmax(engine.said == EXPLODED))
    disc, space = int(engine.clock[2 + part]), engine.space
    row = engine.bodies.rows[disc]
    cause = f"the time step is too long for the stiffness and damping, or the {space.body}s overlapped at the start"
    if np.linalg.norm(row[list(space.velocity)]) * engine.dt <= engine.radius[disc]:
        cause = "its overlap is beyond half a radius: contacts too soft for their load, or too long a time step"
    if not np.isfinite(row[: space.motion]).all():
        cause = "its motion is not finite: two centres fell together, or a force overflowed"
    return Explosion(int(engine.labels[disc]), engine.step, engine.model.dt, cause, space.body)
