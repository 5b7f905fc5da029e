"""Troubles: why a run did not come to its stop, in words."""

from silostudy.dem.events import TRIGGERS, Event
from silostudy.dem.moves import lid_standing


def trouble_of(run) -> str:
    """Reason why a run did not come to its stop; empty where it did."""
    if run.recording.explosion is not None:
        return str(run.recording.explosion)
    if run.recording.buried:
        return run.recording.buried
    event = run.recording.waiting
    return f"the time limit came before the event `{event}`: {_standing(run, event)}" if event else ""


def _standing(run, event: Event) -> str:
    """Distance of an event from its trigger, in words."""
    if event.trigger == "rest":
        return f"{run.rest.criterion.measure(run.engine, run.looked):.3g}, to be at rest: {run.rest}"
    if TRIGGERS[event.trigger].of_lid:
        return lid_standing(run.engine)
    if event.trigger == "discharged":
        return f"a share of {(run.gone + run.dropped) / run.full:.3g} has left"
    return f"due at {run.due() * run.engine.model.dt:.6g} s"
