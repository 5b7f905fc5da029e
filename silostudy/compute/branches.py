"""The end of a discrete-element run on disk, and scenes that go on from it."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.compute.branch_events import called_here, check_stop, outlets_of
from silostudy.compute.checkpoints import program, read_whole, write_whole
from silostudy.config.grain_scenes import AnyScene
from silostudy.cube.netcdf import is_file
from silostudy.dem.branch import end_of, with_motion
from silostudy.dem.likeness import MARCH, differences
from silostudy.dem.model import FLOOR, Model
from silostudy.dem.run import Run
from silostudy.dem.space.level import gate_of
from silostudy.dem.space.walls import Surface
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput
from silostudy.scene.dem_model import check_bound
from silostudy.scene.outflow import OUTLET

KEY = "start_from"
# beginnings of keys that a branch may change: what happens, is recorded or told, and until when
FREE = ("title", "outputs", "expected", "record", "events", "rest", "quake", "gravity", "outlets", "march.limit_s", KEY)
FRICTION = "friction"  # ending of keys of coefficients that may be others too
MOST = 3  # keys that a difference is told by


def keep_end(run: Run, scene: AnyScene, path: Path) -> None:
    """Write where the run of a scene ended, for scenes that go on from there."""
    write_whole((KEY, program(), end_of(run) | {"keys": keys_of(scene), "outlets": outlets_of(scene)}), path)


def keys_of(scene: AnyScene) -> dict[str, Any]:
    """Values of a scene by their keys, those that a branch may change left out."""
    return {
        key: value
        for key, value in _leaves(scene.model_dump(mode="json"))
        if value is not None and not key.startswith(FREE) and not key.endswith(FRICTION)
    }


def _leaves(section: Mapping[str, Any], above: str = "") -> Iterator[tuple[str, Any]]:
    """Keys and values of a section and of those in it."""
    for name, value in section.items():
        if isinstance(value, dict):
            yield from _leaves(value, f"{above}{name}.")
        else:
            yield f"{above}{name}", value


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
        raise BadInput(KEY, scene.start_from, f"is the end of a run with {other}{_by_keys(scene, end)}", where)
    check_bound(scene, model, where)
    then = int(end["engine"]["step"]) * model.dt
    if scene.march.limit_s <= then:
        raise BadInput(
            "march.limit_s", scene.march.limit_s, f"must be above {then:.6g} s, where {scene.start_from} ends", where
        )
    check_stop(scene, then, model.dt, where)
    end |= {"acted": called_here(end["acted"], end["outlets"], outlets_of(scene))}
    return replace(with_motion(model, end), end=end)


def _by_keys(scene: AnyScene, end: Mapping[str, Any]) -> str:
    """Words on the first keys of a scene whose values were others there; none where files or tables alone were others."""
    here, there = keys_of(scene), end["keys"]
    others = [key for key in {**there, **here} if there.get(key) != here.get(key)]
    others.sort(key=lambda key: key.startswith(MARCH))  # a step follows from the rest
    told = ", ".join(f"{key} {there.get(key, 'null')} there, {here.get(key, 'null')} here" for key in others[:MOST])
    return f" ({told})" if told else ""


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
