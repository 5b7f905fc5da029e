"""Spheres that come into a run, so that another code may let in the same."""

from typing import NamedTuple

import numpy as np

from silostudy.dem.run import Run


class Arrival(NamedTuple):
    """A sphere that came in: at which step, its number, place (m) and velocity (m/s)."""

    step: int
    number: int
    place: np.ndarray
    velocity: np.ndarray


def followed(run: Run) -> list[Arrival]:
    """Carry a run to its end; gives the spheres that were there at the start or came in on the way."""
    engine, model = run.engine, run.engine.model
    came: list[Arrival] = []
    speed = np.array(run.rain.velocity) if run.rain else np.zeros(3)
    run.go(until=0)  # the first of a rain comes in at once
    while True:
        for number in range(len(came), run.come):
            velocity = speed if run.rain else model.velocity[number]
            came.append(Arrival(engine.step, number, engine.places[number], velocity))
        if run.done:
            return came
        run.go(until=None if run.come == engine.most else engine.step + run.check)
