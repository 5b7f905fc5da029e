"""Changes to a scene between two steps: discs taken out, walls opened, friction changed; histories are carried over."""

from typing import Any

import numpy as np

from silostudy.dem.engine import Engine
from silostudy.dem.ledger import carry_in
from silostudy.dem.neighbours import LOW, SHIFT
from silostudy.dem.snapshot import from_walls, length
from silostudy.dem.thin import thin_wide
from silostudy.dem.varied import Varied


def keep_discs(engine: Engine, staying: np.ndarray) -> None:
    """Drop the bodies that are not marked; the others keep their order, so that every sum keeps its own."""
    pairs, near = engine.take_memories()
    number = np.cumsum(staying) - 1
    first, second = pairs.key >> SHIFT, pairs.key & LOW
    stay = np.flatnonzero(staying[first] & staying[second])
    pairs = pairs.picked(stay, number[first[stay]] << SHIFT | number[second[stay]])
    disc, wall = near.key >> SHIFT, near.key & LOW
    stay = np.flatnonzero(staying[disc])
    near = near.picked(stay, number[disc[stay]] << SHIFT | wall[stay])
    left, wide_holds = int(staying.sum()), engine.threads == 1 and np.isfinite(engine.blocks.wide_travel[0])
    if wide_holds:  # several threads share the bodies that are left anew
        thin_wide(engine.blocks, engine.parts[0].scratch, staying, number, engine.n)
    for column in engine.bodies:
        if len(column) >= engine.n:
            column[:left] = column[: engine.n][staying]
    engine.n = left
    engine.give_memories(pairs, near, wide_holds=wide_holds)


def add_bodies(engine: Engine, labels: np.ndarray, places: np.ndarray, velocity: tuple[float, ...]) -> None:
    """Let bodies that waited in, behind all others: at these places (n, d; m), with one velocity (m/s) and no spin."""
    pairs, near = engine.take_memories()
    bodies, space, new = engine.bodies, engine.space, slice(engine.n, engine.n + len(labels))
    rates = (*velocity, *(0.0 for _ in space.spin))
    bodies.rows[new] = 0.0
    bodies.rows[new, space.place] = places
    bodies.rows[new, (*space.velocity, *space.spin)] = rates
    if len(bodies.held):
        bodies.held[new, : len(rates)] = rates
    bodies.label[new] = labels
    if engine.model.unequal:
        mass, radius = engine.model.mass[labels], engine.model.radius[labels]
        bodies.radius[new], bodies.mass[new], bodies.inverse_mass[new] = radius, mass, 1.0 / mass
        bodies.inverse_inertia[new] = space.inverse_inertia / (mass * radius**2)
    if engine.model.kind is not None:
        bodies.kind[new] = engine.model.kind[labels]
    engine.n += len(labels)
    carry_in(engine, np.arange(engine.n) >= new.start)
    engine.give_memories(pairs, near)


def swap_walls(engine: Engine, gone: str, come: tuple[str, ...]) -> None:
    """Take a wall away and put others there; contacts that are still in touch with those keep their histories.

    A hole that was growing in it has grown.
    """
    old, *new = (engine.model.wall_number(name) for name in (gone, *come))
    engine.space.widen(engine.walls.shape, old, np.inf)
    pairs, near = engine.take_memories()
    disc, wall = near.key >> SHIFT, near.key & LOW
    for k in np.flatnonzero(wall == old):
        place = engine.bodies.rows[disc[k], engine.space.place]
        nearer = length(from_walls(engine, np.array(new), np.broadcast_to(place, (len(new), len(place)))))
        wall[k] = new[int(np.argmin(nearer))] if new else old
    stay = wall != old
    key = (disc << SHIFT | wall)[stay]
    order = np.argsort(key, kind="stable")
    engine.walls.live[old] = False
    engine.walls.live[new] = True
    engine.give_memories(pairs, near.picked(stay, key).picked(order))


def take_walls(engine: Engine, names: tuple[str, ...]) -> None:
    """Take walls away; nothing comes in their place."""
    for name in names:
        swap_walls(engine, name, ())


def standing_parts(engine: Engine, wall: str) -> list[int]:
    """Numbers of a surface of a name, or of its parts, that stand."""
    named = (n for n, of in enumerate(engine.model.walls) if of.name == wall or of.name.startswith(f"{wall}_"))
    return [number for number in named if engine.walls.live[number]]


def not_open(engine: Engine, wall: str, names: tuple[str, ...]) -> tuple[str, ...]:
    """Pick those of some outlets of a surface, or between its parts, that are not open altogether."""
    surfaces: Any = engine.model.walls
    left = {name for number in standing_parts(engine, wall) for name in surfaces[number].narrow(engine.walls.shape[number])}
    return tuple(name for name in names if name in left)


def open_holes(engine: Engine, wall: str, names: tuple[str, ...], speed: float) -> None:
    """Open holes of a level surface, or between its parts, at a speed (m/s) or at once where it is none.

    Those that are open stay so.  Contacts with what is left of it go on, those that stood over the holes end.
    """
    pairs, near = engine.take_memories()
    surfaces: Any = engine.model.walls
    numbers = standing_parts(engine, wall)
    for number in numbers:
        surfaces[number].opened(engine.walls.shape[number], names, speed)
    body, walls = near.key >> SHIFT, near.key & LOW
    away = length(from_walls(engine, walls, engine.bodies.rows[body][:, engine.space.place]))
    stay = ~np.isin(walls, numbers) | (away < engine.radius[body] + engine.model.gap)
    engine.give_memories(pairs, near.picked(stay, near.key[stay]))


def set_friction(engine: Engine, *, pair: float | None = None, wall: float | None = None, walls: tuple[str, ...] = ()) -> None:
    """Change the sliding friction between bodies of any kinds, at all walls or at those of some names, or both."""
    between, at_walls = engine.contacts
    if pair is not None:
        between = between.changed({"sliding_friction": pair})
    if wall is not None and walls:
        assert isinstance(at_walls, Varied)  # a scene with such an event has walls that differ
        numbers, many = {engine.model.wall_number(name) for name in walls}, len(engine.model.walls)
        at_walls = at_walls.changed({"sliding_friction": wall}, (n for n in range(len(at_walls.sets)) if n % many in numbers))
    elif wall is not None:
        at_walls = at_walls.changed({"sliding_friction": wall})
    engine.contacts = between, at_walls
