"""Single precision of what an engine carries from step to step: the least error that a single-precision engine would make.

The engine knows double precision only.  Places, speeds and histories are rounded after every step and forces are still
computed in double.  The cost is that of the same run in double precision, which such an engine might halve at best.
"""

from collections.abc import Callable

import numpy as np

from silostudy.dem.engine import Engine

SINGLE = "single precision (time of double)"


def step_rounded(engine: Engine, stop: int) -> None:
    """Step an engine of one thread with all that it carries from step to step rounded to single precision."""
    while engine.step < stop:
        engine.step_to(engine.step + 1)
        part = engine.parts[0]
        for carried in (engine.bodies.rows[: engine.n, : engine.space.motion], part.pairs.stored, part.near.stored):
            carried[:] = carried.astype(np.float32)


def timed_in_double(run: Callable) -> Callable:
    """Run in double precision that is timed; the rounded run's result is computed before the clock runs.

    run: takes how an engine is stepped to a tick.
    """
    rounded = run(step_rounded)

    def timed():
        run(Engine.step_to)
        return rounded

    return timed
