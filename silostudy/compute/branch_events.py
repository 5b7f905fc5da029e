"""Events of a scene that goes on from the end of a run: those that had happened by then, and those that come."""

from collections.abc import Mapping
from dataclasses import replace

from silostudy.config.grain_scenes import AnyScene
from silostudy.config.spheres import SphereScene
from silostudy.dem.change import not_open
from silostudy.dem.events import Event
from silostudy.dem.run import Run
from silostudy.errors import BadInput
from silostudy.scene.dem import plane_silo_of
from silostudy.scene.spheres import space_silo_of


def outlets_of(scene: AnyScene) -> dict[str, tuple]:
    """Places (m) of the outlets of a scene by their names, which may be others in a branch."""
    if isinstance(scene, SphereScene):
        return {name: (opening.middle, opening.half) for name, opening in space_silo_of(scene).openings.items()}
    return {slit.name: slit.edges for slit in plane_silo_of(scene).slits}


def called_here(acted: list[tuple[float, Event]], there: Mapping[str, tuple], here: Mapping[str, tuple]) -> list:
    """Events that have acted, what they opened under the names that it has here."""
    names = {name: next((own for own, hole in here.items() if hole == place), name) for name, place in there.items()}
    return [
        (time, replace(event, what=(event.what[0], tuple(names[name] for name in event.what[1]), *event.what[2:])))
        if event.action == "open holes"
        else (time, event)
        for time, event in acted
    ]


def check_stop(scene: AnyScene, then: float, tick: float, where: str) -> None:
    """BadInput where the stop of a scene that goes on at a time (s) comes at once."""
    time = then
    for event in scene.events:
        if event.when not in ("time", "after"):
            return
        time = max(time, event.value) if event.when == "time" else time + event.value
    if round(time / tick) <= round(then / tick):
        number, last = len(scene.events) - 1, scene.events[-1]
        told = f"the run would stop where it begins: must come after {then:.6g} s, where {scene.start_from} ends"
        raise BadInput(f"events.{number}.value", last.value, told, where)


def yet_to_come(run: Run, scene: AnyScene) -> tuple[tuple[Event, ...], int]:
    """Events of a run that goes on from an end, without those that had happened by then, and the tick they count from.

    The first events of a scene had happened where they were due before and acted so there: it may be the scene that it goes on
    from, with more events.  BadInput for any other event whose time has passed, and for one that opens nothing.
    """
    assert run.engine.model.end is not None
    done, since, first = [event for _, event in run.engine.model.end["acted"]], None, 0
    for event in run.events:
        due = _due(run, event, since)
        if due is None or due >= run.began or event not in done:
            break
        done, since, first = done[done.index(event) + 1 :], due, first + 1
    for number, event in enumerate(run.events[first:], first):
        _check_to_come(run, scene, number, _due(run, event, since if number == first else None))
    return run.events[first:], run.since if since is None else since


def _due(run: Run, event: Event, since: int | None) -> int | None:
    """Tick at which an event is due that follows another at a tick, where that is known."""
    start = {"time": 0, "after": since}.get(event.trigger)
    return None if start is None else start + round(event.value / run.engine.model.dt)


def _check_to_come(run: Run, scene: AnyScene, number: int, due: int | None) -> None:
    """BadInput for an event of a scene that was due before it goes on, or that opens what is open."""
    event, began = run.events[number], run.engine.time
    if due is not None and due < run.began:
        told = f"lies at {due * run.engine.model.dt:.6g} s, before {scene.start_from} ends: must not be before {began:.6g} s, "
        raise BadInput(f"events.{number}.value", scene.events[number].value, f"{told}unless it happened there")
    shut = True
    if event.action == "open":
        shut = bool(run.engine.walls.live[run.engine.model.wall_number(event.what[0])])
    elif event.action == "open holes":
        shut = bool(not_open(run.engine, *event.what[:2]))
    if not shut:
        told = f"opens nothing: open by then, where {scene.start_from} ends"
        raise BadInput(f"events.{number}.do", scene.events[number].do, told)
