"""Steps that follow the contacts: looked at every so often, and made as long as the pace of the model allows."""

import numpy as np

from silostudy.dem.stable_now import stable_now

EVERY = 20  # looks at rest from one look at the contacts to the next


def follow(engine, steps: list[tuple[int, int]], filling: bool) -> None:
    """Let an engine's steps follow what its contacts bear now, and keep the tick and the ticks of a step where they change.

    filling: whether bodies are still to come in.
    """
    pace = engine.model.pace
    if not pace.share or not engine.n:
        return
    ticks = pace.after(engine.ticks, stable_now(engine) / engine.model.dt, filling)
    change_steps(engine, steps, ticks)


def change_steps(engine, steps: list[tuple[int, int]], ticks: int) -> None:
    """Let an engine make steps of so many ticks from now on, and keep the tick and the ticks of a step where they change."""
    if ticks == engine.ticks:
        return
    engine.take_steps_of(ticks)
    if steps and steps[-1][0] == engine.step:
        steps.pop()
    steps.append((engine.step, ticks))


def follow_in(run) -> None:
    """Let the steps of a run follow what its contacts bear now."""
    follow(run.engine, run.recording.steps, filling=run.come < run.engine.most)


def steps_made(run) -> int:
    """Number of steps that a run has made."""
    tick, ticks = np.array([*run.recording.steps, (run.engine.step, 1)]).T
    return int((np.diff(tick) // ticks[:-1]).sum())


def mean_step(run) -> float:
    """Mean time step (s) of a run; of one that has made none, that to come."""
    made = steps_made(run)
    return run.engine.model.dt * ((run.engine.step - run.began) / made) if made else run.engine.dt
