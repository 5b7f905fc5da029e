"""Steps that are longer at rest: errors are made while bodies fall and hit, and little is left to resolve as they settle."""

import numpy as np

from silostudy.dem.follow import change_steps
from silostudy.dem.observer import after

WATCHES = 4  # of the speed of bodies from one look at rest to the next, while steps are not the longest


def watch_after(run, step: int) -> int:
    """Next tick at which the speed of bodies is looked at."""
    pace = run.engine.model.pace
    watched = pace.lively and run.engine.ticks < pace.longest
    return after(step, run.check // WATCHES if watched else run.check)


def calm_down(run, before: int) -> None:
    """Let a run whose steps are longer at rest make steps as long as its bodies are slow, where it is time to look."""
    if run.engine.model.pace.lively and watch_after(run, before) <= run.engine.step:
        speed = liveliness(run)
        run.top_speed = max(run.top_speed, speed) if np.isfinite(speed) else 0.0
        ticks = run.engine.model.pace.at_speed(run.engine.ticks, speed, run.top_speed)
        change_steps(run.engine, run.recording.steps, ticks)


def wake(run) -> None:
    """Let a run whose steps are longer at rest make the first again: an event may set bodies in motion."""
    if run.engine.model.pace.lively:
        run.top_speed = 0.0
        change_steps(run.engine, run.recording.steps, run.engine.model.pace.ticks)


def liveliness(run) -> float:
    """Largest speed of a body over that of a fall by its radius (1); endless while bodies come in, or where they are moved."""
    moved = run.engine.model.moving or run.engine.model.quake is not None
    return np.inf if moved or run.come < run.engine.most else fastest(run.engine)


def fastest(engine) -> float:
    """Largest speed of a body, its spin's with it, over that of a fall by its radius (1); endless without gravity."""
    space = engine.space
    moving = sum(engine.column(lane) ** 2 for lane in space.velocity)
    turning = sum((engine.radius * engine.column(lane)) ** 2 for lane in space.spin) / space.inverse_inertia
    fall = 2.0 * np.hypot.reduce(engine.gravity) * engine.radius
    return float(np.sqrt(((moving + turning) / fall).max(initial=0.0))) if fall.all() else np.inf
