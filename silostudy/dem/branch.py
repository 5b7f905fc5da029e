"""Branches: where a run ended, and another run that goes on from there with other events, another outlet, a later end.

The clock goes on, and so do what springs hold, frictions and gravity as events left them, walls in motion, a feeder, and the
mass that has left; records begin anew.
"""

import copy
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from silostudy.dem.arrays import Memory
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.drive import MASS
from silostudy.dem.events import Event
from silostudy.dem.floors import Exchange, changed, exchanged, nearest_of
from silostudy.dem.likeness import fixed, meant, values, walls
from silostudy.dem.model import Model
from silostudy.dem.neighbours import LOW, SHIFT
from silostudy.dem.varied import Varied

CARRIED = ("come", "came", "looked", "top_speed")  # of where a run stands


def end_of(run) -> dict[str, Any]:
    """End of a run: its state, and those parts of its model that a run which goes on from there must share or may change."""
    model, engine = run.engine.model, run.engine
    return {
        "engine": checkpoint(engine),
        "body": model.space.body,
        "gone": run.gone + run.dropped,
        **{name: getattr(run, name) for name in CARRIED},
        "apart": isinstance(model.wall_contact, Varied),  # whether some walls have frictions of their own
        "over": run.over,
        "fed": run.feeder.stand if run.feeder else None,
        "fixed": fixed(model),
        "walls": walls(model),
        "stated": values(model, (model.pair_contact, model.wall_contact)),
        "held": values(model, engine.contacts),
        "gravity": model.gravity,
        "lid": model.lid,
        "booked": model.booked,
        "acted": acted(run),
    }


def acted(run) -> list[tuple[float, Event]]:
    """Times (s) at which events acted, and the events, those of runs that this one goes on from first; stops apart."""
    before = run.engine.model.end["acted"] if run.engine.model.end else []
    own = zip(run.recording.happened, run.events[: run.next_event], strict=False)  # the limit is no event
    return [*before, *((time, event) for (time, *_), event in own if event.action != "stop")]


def in_motion(model: Model, end: Mapping[str, Any]) -> bool:
    """Whether a wall moved, turned or ran along itself then, bore a load, or was drawn back from an outlet."""
    now, wider = end["engine"]["shape"], end["engine"]["shape"].copy()
    for wall in range(len(wider)):
        model.space.widen(wider, wall, model.dt)
    loaded = (end["engine"]["drive"][:, MASS] > 0.0).any()
    return bool(loaded or model.space.motion_of(now)[:, 1:].any() or not np.array_equal(now, wider))


def with_motion(model: Model, end: Mapping[str, Any]) -> Model:
    """A model whose walls go on to move as they did then, its lid the lighter of those of both."""
    if not in_motion(model, end):
        return model
    lids = [lid for lid in (model.lid, end["lid"]) if lid is not None]
    return replace(model, moving=True, lid=min(lids, key=lambda lid: lid.mass, default=None))


def go_on(run, end: Mapping[str, Any]) -> None:
    """Let a run that has not begun go on from an end of a model that agrees with its own."""
    engine = run.engine
    restore(engine, end["engine"] | _here(engine, end))
    vars(run).update({name: end[name] for name in (*CARRIED, "gone")})
    run.over = copy.deepcopy(end["over"])  # one end may have several branches
    run.began = run.since = run.opened = engine.step
    if run.feeder and end["fed"]:
        run.feeder.stand = end["fed"]


def _here(engine, end: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """The parts of a checkpoint that an engine with other walls, records or frictions takes otherwise."""
    model, saved = engine.model, end["engine"]
    account = saved["account"] if end["booked"] else engine.ledger.account  # of what began before nothing is known
    same = model.gravity == end["gravity"]
    floors = exchanged(model, end, walls(model))
    stand = _walls_here(engine, end, floors)
    engine.walls.shape[:] = stand["shape"]
    return {
        **stand,
        **_memories_here(engine, end, floors),
        "window": engine.record.window,
        "whole": engine.record.whole,
        "account": account,
        "gravity": saved["gravity"] if same else np.array(model.gravity),
        "coefficients": np.array(_coefficients_here(engine, end, floors)),
    }


def _walls_here(engine, end: Mapping[str, Any], floors: Exchange) -> dict[str, np.ndarray]:
    """State of the walls: which stand, where, and what moves them; of those that had changed by then, as they were there."""
    here = {name: getattr(engine.walls, name).copy() for name in ("live", "shape", "drive")}
    numbers = {wall.name: number for number, wall in enumerate(engine.model.walls)}
    for then, name in enumerate(end["walls"]):
        stands = end["engine"]["live"][then]
        if name in {*floors.passed, *floors.own}:
            continue
        if name in numbers:
            here["live"][numbers[name]] = stands
        if stands:
            here["drive"][numbers[name]] = end["engine"]["drive"][then]
        if changed(end, name):
            shape, row = end["engine"]["shape"][then], here["shape"][numbers[name]]
            most = min(len(shape), len(row))  # rows are as long as the walls with most holes or sides ask for
            row[:most] = shape[:most]
    for name, shape in zip(floors.own, floors.rows, strict=True):
        here["shape"][numbers[name], : len(shape)] = shape
    return here


def _memories_here(engine, end: Mapping[str, Any], floors: Exchange) -> dict[str, np.ndarray]:
    """Histories at walls, under the numbers that these have here."""
    saved, model = end["engine"], engine.model
    live = dict(zip(end["walls"], saved["live"], strict=True))
    number = np.array([model.wall_number(name) if stands and name not in floors.passed else 0 for name, stands in live.items()])
    near = Memory(*(saved[f"wall_{name}"] for name in Memory._fields))
    body, wall = near.key >> SHIFT, number[near.key & LOW]
    for name, takes in zip(floors.passed, floors.takes, strict=True):
        moved = (near.key & LOW) == list(live).index(name)
        heirs = tuple(piece for piece, heir in zip(floors.own, takes, strict=True) if heir)
        wall[moved] = nearest_of(engine, heirs, saved["rows"][body[moved]][:, model.space.place])
    key = body << SHIFT | wall
    order = np.argsort(key, kind="stable")
    return {f"wall_{name}": column for name, column in near.picked(order, key[order])._asdict().items()}


def _coefficients_here(engine, end: Mapping[str, Any], floors: Exchange) -> list[float]:
    """Coefficients in the order of a checkpoint: as they stand there, where both models state the same, else as stated here."""
    model, values_here = engine.model, []
    for pairs, contact in zip((True, False), engine.contacts, strict=True):
        for number, coefficients in enumerate(contact.sets):
            wall, kind = meant(model, number, pairs=pairs, varied=isinstance(contact, Varied))[0]
            new = wall in floors.own and wall not in floors.passed
            of = (floors.passed[0], kind) if new else (wall, kind)  # a new piece has what the floor had
            for row in coefficients.rows:
                for name in (coefficient.name for coefficient in row.coefficients):
                    now = coefficients.coefficients[name]
                    agreed = end["stated"].get((*of, name)) == now
                    values_here.append(end["held"][(*of, name)] if agreed else now)
    return values_here
