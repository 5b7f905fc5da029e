"""Likeness of a model to the end of a run that it goes on from: what both share, what may be other, differences in words."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from silostudy.dem.contacts import Contact
from silostudy.dem.floors import changed, exchanged
from silostudy.dem.model import FLOOR, Model
from silostudy.dem.varied import Varied

MARCH = "march"  # first word of the keys of time stepping
NUMBER = "1"  # unit of coefficients that a branch may change: frictions
Contacts = tuple[Contact | Varied, Contact | Varied]
Values = dict[tuple[str, int, str], float]  # a wall's name, or none; a kind, or a pair's number; a coefficient's name


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


def walls(model: Model) -> dict[str, tuple[bytes, np.ndarray, tuple[str, ...]]]:
    """Box around each wall, its shape at the start, and its outlets, by its name, in their order."""
    shapes, boxes = model.space.walls_of(model.walls).shape, model.space.extents(model.walls)
    rows = zip(model.walls, boxes, shapes, strict=True)
    return {
        wall.name: (np.ascontiguousarray(box).tobytes(), np.trim_zeros(shape, "b"), wall.outlets) for wall, box, shape in rows
    }


def values(model: Model, contacts: Contacts) -> Values:
    """Every coefficient of contacts: of pairs by their number, at walls by the wall and the kind."""
    return {
        (*of, name): float(value)
        for pairs, contact in zip((True, False), contacts, strict=True)
        for number, coefficients in enumerate(contact.sets)
        for of in meant(model, number, pairs=pairs, varied=isinstance(contact, Varied))
        for name, value in coefficients.coefficients.items()
    }


def meant(model: Model, number: int, *, pairs: bool, varied: bool) -> list[tuple[str, int]]:
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
    for (wall, kind, name), now in values(model, (model.pair_contact, model.wall_contact)).items():
        then, unit = end["stated"].get((wall, kind, name), now), units[name]
        if then != now and unit != NUMBER:
            of = f"{model.space.body}s" if not wall else wall if isinstance(model.wall_contact, Varied) else "walls"
            yield f"other {name} of {of}: {then:.6g} {unit} there, {now:.6g} here"


def _other_walls(model: Model, end: Mapping[str, Any]) -> Iterator[str]:
    """Walls that stand there and are others here, or that stand here alone; what waits to stand or to open may differ."""
    here, live = walls(model), dict(zip(end["walls"], end["engine"]["live"], strict=True))
    floors, others = exchanged(model, end, here), []
    if floors.lost:
        yield f"the outlet {floors.lost} open, which this scene has not: only outlets that are shut there may be others"
    for name, stands in live.items():
        box, shape, _ = here.get(name, (b"", np.empty(0), ()))
        moved = changed(end, name)  # one that waits to stand may run along itself
        other = box != end["walls"][name][0] or (moved and not np.array_equal(shape, end["walls"][name][1]))
        if (stands or moved) and other and name not in floors.passed:
            others.append(name)
    for name in sorted(others, key=lambda name: name.startswith(FLOOR)):  # the body first: floors reach as far as it does
        open_too = "an outlet that is open, and the silo's body, stay as they are"
        yield f"another wall {name}: {open_too if name.startswith(FLOOR) else 'the body of the silo stays as it is'}"
    for wall in model.walls:
        if wall.live and wall.name not in {*live, *floors.own}:
            yield f"no wall {wall.name}, which stands here"


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
