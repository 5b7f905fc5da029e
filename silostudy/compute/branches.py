"""The end of a discrete-element run on disk, and scenes that go on from it."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.compute.checkpoints import program, read_whole, write_whole
from silostudy.config.grain_scenes import AnyScene
from silostudy.cube.netcdf import is_file
from silostudy.dem.branch import end_of, with_motion
from silostudy.dem.change import not_open
from silostudy.dem.events import Event
from silostudy.dem.likeness import differences
from silostudy.dem.model import FLOOR, Model
from silostudy.dem.run import Run
from silostudy.dem.space.level import gate_of
from silostudy.dem.space.walls import Surface
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput
from silostudy.scene.outflow import OUTLET

KEY = "start_from"


def keep_end(run: Run, path: Path) -> None:
    """Write where a run ended, for scenes that go on from there."""
    write_whole((KEY, program(), end_of(run)), path)


def branched(scene: AnyScene, model: Model, folder: Path, where: str) -> Model:
    """The model of a scene that goes on from an end; BadInput where there is none, or it is of another scene than this one's.

    What moves there, or has frictions of its own, does so here too.
    """
    assert scene.start_from is not None
    end = _read(scene.start_from, folder, where)
    if end["apart"] and not isinstance(model.wall_contact, Varied):
        model = replace(model, wall_contact=Varied((model.wall_contact,) * len(model.walls)))
    model = replace(model, walls=tuple(as_there(wall, end) for wall in model.walls))
    model = _in_its_step(scene, model, end)
    if other := next(differences(model, end), None):
        raise BadInput(KEY, scene.start_from, f"is the end of a run with {other}", where)
    then = int(end["engine"]["step"]) * model.dt
    if scene.march.limit_s <= then:
        raise BadInput(
            "march.limit_s", scene.march.limit_s, f"must be above {then:.6g} s, where {scene.start_from} ends", where
        )
    _check_stop(scene, then, model.dt, where)
    return replace(with_motion(model, end), end=end)


def _in_its_step(scene: AnyScene, model: Model, end: dict[str, Any]) -> Model:
    """A model in the step that was chosen there, where none is asked for and that is shorter: a lid there may call for it."""
    step = end["fixed"]["march.step_s"]
    follows = end["fixed"]["march.step"] == model.pace.kind and scene.march.step_s is None and model.quake is None
    return replace(model, dt=step / model.pace.ticks) if follows and step < model.step else model


def as_there(wall: Any, end: Mapping[str, Any]) -> Any:
    """A surface of a model, or where it is a hopper's plug that was a gate by the end of a run, that gate."""
    if wall.name != FLOOR or not isinstance(wall, Surface) or FLOOR not in end["walls"]:
        return wall
    gate = gate_of(wall, OUTLET)
    return gate if np.array_equal(np.trim_zeros(gate.shape, "b"), end["walls"][FLOOR][1]) else wall


def _check_stop(scene: AnyScene, then: float, tick: float, where: str) -> None:
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


def yet_to_open(run: Run, scene: AnyScene) -> tuple[Event, ...]:
    """Events of a run that goes on from an end, without the outlets that are open there; BadInput where none is left."""
    events = []
    for number, event in enumerate(run.events):
        shut = True
        if event.action == "open":
            shut = bool(run.engine.walls.live[run.engine.model.wall_number(event.what[0])])
        elif event.action == "open holes":
            wall, names, speed = event.what
            shut = bool(names := not_open(run.engine, wall, names))
            event = replace(event, what=(wall, names, speed))
        if not shut:
            told = f"opens nothing: open by then, where {scene.start_from} ends"
            raise BadInput(f"events.{number}.do", scene.events[number].do, told)
        events.append(event)
    return tuple(events)


def _read(file: str, folder: Path, where: str) -> dict[str, Any]:
    if not is_file(folder / file):
        raise BadInput(KEY, file, "there is no such file: a run with record.keep_end writes it beside its cube", where)
    try:
        key, code, end = read_whole(folder / file)
        if key != KEY:
            raise ValueError("of another kind")
    except Exception as error:  # a file cut short or of another kind fails in any way
        raise BadInput(KEY, file, f"is no whole end of a run ({error})", where) from None
    if code != program():
        raise BadInput(KEY, file, "was written by another version of the program: run its scene again", where)
    return end
