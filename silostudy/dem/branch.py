"""Branches: where a run ended, and another run that goes on from there with other events, another outlet, a later end.

The clock goes on, and so do what springs hold, frictions and gravity as events left them, walls in motion, a feeder, and the
mass that has left; records begin anew.
"""

import copy
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from silostudy.dem.arrays import Memory
from silostudy.dem.checkpoint import checkpoint, restore
from silostudy.dem.contacts import Contact
from silostudy.dem.drive import MASS
from silostudy.dem.floors import changed, exchanged, nearest_of
from silostudy.dem.model import FLOOR, Model
from silostudy.dem.neighbours import LOW, SHIFT
from silostudy.dem.varied import Varied

MARCH = "march"  # first word of the keys of time stepping
NUMBER = "1"  # unit of coefficients that a branch may change: frictions
Contacts = tuple[Contact | Varied, Contact | Varied]
Values = dict[tuple[str, int, str], float]  # a wall's name, or none; a kind, or a pair's number; a coefficient's name


def end_of(run) -> dict[str, Any]:
    """End of a run: its state, and those parts of its model that a run which goes on from there must share or may change."""
    model, engine = run.engine.model, run.engine
    return {
        "engine": checkpoint(engine),
        "body": model.space.body,
        "come": run.come,
        "came": run.came,
        "gone": run.gone + run.dropped,
        "looked": run.looked,
        "apart": isinstance(model.wall_contact, Varied),  # whether some walls have frictions of their own
        "over": run.over,
        "fed": run.feeder.stand if run.feeder else None,
        "fixed": fixed(model),
        "walls": walls(model),
        "stated": values(model, (model.pair_contact, model.wall_contact)),
        "held": values(model, engine.contacts),
        "gravity": model.gravity,
        "booked": model.booked,
    }


def fixed(model: Model) -> dict[str, Any]:
    """Parts of a model that a branch cannot change, by the words of a scene."""
    contacts = (model.pair_contact, model.wall_contact)
    columns = (model.place, model.radius, model.mass, *([] if model.kind is None else [model.kind]))
    return {
        "grains (sizes, density, packing, seed)": tuple(np.ascontiguousarray(column).tobytes() for column in columns),
        "contact laws": repr([contact.laws for contact in contacts]),
        "march.integrator": model.integrator,
        "march.step": model.pace.kind,
        "march.step_factor": model.pace.factor,
        "march.step_s": model.step,
    }


def walls(model: Model) -> dict[str, tuple[bytes, np.ndarray]]:
    """Box around each wall, and its shape at the start, by its name, in their order."""
    shapes, boxes = model.space.walls_of(model.walls).shape, model.space.extents(model.walls)
    rows = zip(model.walls, boxes, shapes, strict=True)
    return {wall.name: (np.ascontiguousarray(box).tobytes(), np.trim_zeros(shape, "b")) for wall, box, shape in rows}


def opening(model: Model, end: Mapping[str, Any]) -> bool:
    """Whether an outlet was still being opened at a speed then."""
    now, wider = end["engine"]["shape"], end["engine"]["shape"].copy()
    for wall in range(len(wider)):
        model.space.widen(wider, wall, model.dt)
    return not np.array_equal(now, wider)


def values(model: Model, contacts: Contacts) -> Values:
    """Every coefficient of contacts: of pairs by their number, at walls by the wall and the kind."""
    return {
        (*of, name): float(value)
        for pairs, contact in zip((True, False), contacts, strict=True)
        for number, coefficients in enumerate(contact.sets)
        for of in _meant(model, number, pairs=pairs, varied=isinstance(contact, Varied))
        for name, value in coefficients.coefficients.items()
    }


def _meant(model: Model, number: int, *, pairs: bool, varied: bool) -> list[tuple[str, int]]:
    """Contacts that a set of coefficients is of: a wall's name (empty: pairs) and the kind; all walls where they are alike."""
    if pairs:
        return [("", number)]
    kind, wall = divmod(number, len(model.walls)) if varied else (0, None)
    return [(surface.name, kind) for place, surface in enumerate(model.walls) if wall in (None, place)]


def differences(model: Model, end: Mapping[str, Any]) -> Iterator[str]:
    """Differences, in words, between a model and the end that it is to go on from."""
    if end["body"] != model.space.body:
        yield f"{end['body']}s, and the scene is of {model.space.body}s"
        return
    yield from _other_walls(model, end)
    here, there = fixed(model), end["fixed"]
    others = [name for name, now in here.items() if there[name] != now]
    yield from (f"other {name}" for name in others if not name.startswith(MARCH))
    yield from _other_coefficients(model, end)  # which the step follows from
    for name in others:
        yield f"other {name}: {there[name]} there, {here[name]} here, and must be given as it is there"


def _other_coefficients(model: Model, end: Mapping[str, Any]) -> Iterator[str]:
    """Coefficients, frictions apart, that are others than there."""
    units = {coefficient.name: coefficient.unit for contact in (model.pair_contact, model.wall_contact) for row in contact.rows
             for coefficient in row.coefficients}  # fmt: skip
    for key, now in values(model, (model.pair_contact, model.wall_contact)).items():
        then, unit = end["stated"].get(key, now), units[key[-1]]
        if then != now and unit != NUMBER:
            yield f"other {key[-1]}: {then:.6g} {unit} there, {now:.6g} here"


def _other_walls(model: Model, end: Mapping[str, Any]) -> Iterator[str]:
    """Walls that stand there and are others here, or that stand here alone; what waits to stand or to open may differ."""
    here, live = walls(model), dict(zip(end["walls"], end["engine"]["live"], strict=True))
    passed, own = exchanged(model, end, here)
    others = []
    for name, stands in live.items():
        box, shape = here.get(name, (b"", np.empty(0)))
        other = box != end["walls"][name][0] or (changed(end, name) and not np.array_equal(shape, end["walls"][name][1]))
        if stands and other and name not in passed:
            others.append(name)
    for name in sorted(others, key=lambda name: name.startswith(FLOOR)):  # the body first: floors reach as far as it does
        open_too = "an outlet that is open, and the silo's body, stay as they are"
        yield f"another wall {name}: {open_too if name.startswith(FLOOR) else 'the body of the silo stays as it is'}"
    for wall in model.walls:
        if wall.live and wall.name not in {*live, *own}:
            yield f"no wall {wall.name}, which stands here"
    moves = model.space.motion_of(end["engine"]["shape"])[:, 1:].any() or (end["engine"]["drive"][:, MASS] > 0.0).any()
    if moves and not model.moving:
        yield "walls in motion: an event here must move them too"


def as_events_left(model: Model, end: Mapping[str, Any]) -> list[str]:
    """Frictions and gravity, in words, with which a branch goes on as events left them there, other than its scene states."""
    stated = values(model, (model.pair_contact, model.wall_contact))
    left: dict[tuple[str, float], list[str]] = {}
    for (wall, _, name), now in end["held"].items():
        if now != end["stated"][wall, _, name] == stated.get((wall, _, name)):
            left.setdefault((name, now), []).append(wall or "grains")
    told = [f"{name} {now:g} of {', '.join(dict.fromkeys(walls))}" for (name, now), walls in left.items()]
    gravity = tuple(map(float, end["engine"]["gravity"]))
    moved = gravity != tuple(map(float, end["gravity"])) == tuple(map(float, model.gravity))
    return told + ([f"gravity_m_s2 {list(gravity)}"] if moved else [])


def go_on(run, end: Mapping[str, Any]) -> None:
    """Let a run that has not begun go on from an end of a model that agrees with its own."""
    engine = run.engine
    restore(engine, end["engine"] | _here(engine, end))
    run.come, run.came, run.gone, run.looked = (end[name] for name in ("come", "came", "gone", "looked"))
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
    return {
        **_walls_here(engine, end, *floors),
        **_memories_here(engine, end, *floors),
        "window": engine.record.window,
        "whole": engine.record.whole,
        "account": account,
        "gravity": saved["gravity"] if same else np.array(model.gravity),
        "coefficients": np.array(_coefficients_here(engine, end, *floors)),
    }


def _walls_here(engine, end: Mapping[str, Any], passed: set[str], own: set[str]) -> dict[str, np.ndarray]:
    """State of the walls: which stand, where, and what moves them; of those that had changed by then, as they were there."""
    here = {name: getattr(engine.walls, name).copy() for name in ("live", "shape", "drive")}
    numbers = {wall.name: number for number, wall in enumerate(engine.model.walls)}
    for then, name in enumerate(end["walls"]):
        stands = end["engine"]["live"][then]
        if name in {*passed, *own}:
            continue
        if name in numbers:
            here["live"][numbers[name]] = stands
        if stands:
            here["drive"][numbers[name]] = end["engine"]["drive"][then]
        if stands and changed(end, name):
            shape, row = end["engine"]["shape"][then], here["shape"][numbers[name]]
            most = min(len(shape), len(row))  # rows are as long as the walls with most holes or sides ask for
            row[:most] = shape[:most]
    return here


def _memories_here(engine, end: Mapping[str, Any], passed: set[str], own: set[str]) -> dict[str, np.ndarray]:
    """Histories at walls, under the numbers that these have here."""
    saved, model = end["engine"], engine.model
    live = dict(zip(end["walls"], saved["live"], strict=True))
    number = np.array([model.wall_number(name) if stands and name not in passed else 0 for name, stands in live.items()])
    near = Memory(*(saved[f"wall_{name}"] for name in Memory._fields))
    body, wall = near.key >> SHIFT, number[near.key & LOW]
    moved = np.isin(near.key & LOW, [list(live).index(name) for name in passed])
    if moved.any():
        wall[moved] = nearest_of(engine, own, saved["rows"][body[moved]][:, model.space.place])
    key = body << SHIFT | wall
    order = np.argsort(key, kind="stable")
    return {f"wall_{name}": column for name, column in near.picked(order, key[order])._asdict().items()}


def _coefficients_here(engine, end: Mapping[str, Any], passed: set[str], own: set[str]) -> list[float]:
    """Coefficients in the order of a checkpoint: as they stand there, where both models state the same, else as stated here."""
    model, values_here = engine.model, []
    for pairs, contact in zip((True, False), engine.contacts, strict=True):
        for number, coefficients in enumerate(contact.sets):
            wall, kind = _meant(model, number, pairs=pairs, varied=isinstance(contact, Varied))[0]
            of = (min(passed), kind) if wall in own - passed else (wall, kind)  # a new piece has what the floor had
            for row in coefficients.rows:
                for name in (coefficient.name for coefficient in row.coefficients):
                    now = coefficients.coefficients[name]
                    agreed = end["stated"].get((*of, name)) == now
                    values_here.append(end["held"][(*of, name)] if agreed else now)
    return values_here
