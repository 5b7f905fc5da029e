"""Translates the user's words on what happens in a scene of spheres into the engine's events."""

import numpy as np

from silostudy.config.moves import OF_LID
from silostudy.config.sphere_events import SphereEventConfig
from silostudy.config.spheres import SphereScene
from silostudy.dem.events import TRIGGERS, Event
from silostudy.dem.space.joints import flat_joints, turned_joints
from silostudy.dem.space.level import LevelPiece
from silostudy.dem.space.rows import CIRCLE
from silostudy.dem.space.walls import FlatPiece, Surface, TurnedLine
from silostudy.errors import BadInput
from silostudy.scene.dem import walls_of_event
from silostudy.scene.lid import lid_action
from silostudy.scene.space_silo import FLOOR, SpaceSilo

ALONG = 1e-6  # share of a belt's velocity that may be rounding across it


def sphere_events(scene: SphereScene, space: SpaceSilo, mass: float, where: str = "") -> tuple[Event, ...]:
    """Events in the engine's words; mass: of all spheres, kg. BadInput for surfaces or spheres that there are none of."""
    events = []
    for number, event in enumerate(scene.events):
        action, what = _action(event, space, mass)
        if action == "friction":
            what = (*what, walls_of_event(event.surfaces, [wall.name for wall in space.walls()], number, where))
        elif action == "run":
            what = (*what, *belts(event, space, number, where))
        elif action == "take away":
            what = taken_away(event, space, number, where)
        events.append(Event(event.when, event.value * TRIGGERS[event.when].scale, action, what, event.said))
    return tuple(events)


def _action(event: SphereEventConfig, space: SpaceSilo, mass: float) -> tuple[str, tuple]:
    if event.do == "set_gravity":
        assert event.gravity_m_s2 is not None  # the model asks for it
        return "gravity", event.gravity_m_s2
    if event.do == "set_friction":
        return "friction", (event.sphere_friction, event.wall_friction)
    if event.do == "rotate":
        return "turn", (event.spin_rad_s, *event.surfaces)
    if event.do == "run_belt":
        return "run", (event.velocity_m_s,)
    if event.do == "remove_sphere":
        return "remove", (event.sphere,) if event.near_m is None else event.near_m
    if event.do == "feed":
        return "feed", (event.rate_kg_s,)
    if event.do == "take_away":
        return "take away", ()
    if event.do in OF_LID:
        return lid_action(event, space.plan.area, mass, space.bottom, space.top)
    if event.do == "open_outlet":
        if space.opening and not space.gated:
            return "open", (FLOOR,)
        return "open holes", (FLOOR, event.outlets or tuple(space.openings), event.speed_m_s or 0.0)
    return "stop", ()


def taken_away(event: SphereEventConfig, space: SpaceSilo, number: int, where: str) -> tuple[str, ...]:
    """Names of the inserts that an event takes away; BadInput for one that shares a side or an end with another surface."""
    if not space.inserts:
        raise BadInput(f"events.{number}.surfaces", ", ".join(event.surfaces), "the scene has no inserts to take away", where)
    names = walls_of_event(event.surfaces, [insert.name for insert in space.inserts], number, where)
    surfaces = space.walls()
    joints = [*flat_joints(surfaces), *turned_joints(surfaces)]
    joined = {surfaces[end].name for joint in joints for end in (joint.surface, joint.other)}
    for name in names:
        if name in joined:
            allowed = "shares a side with another surface, which would be left with a joint: let it reach beyond that"
            raise BadInput(f"events.{number}.surfaces", name, allowed, where)
    return names


def belts(event: SphereEventConfig, space: SpaceSilo, number: int, where: str) -> tuple[str, ...]:
    """Names of the surfaces whose faces an event lets run; BadInput for one that its velocity does not run along."""
    surfaces = {surface.name: surface for surface in space.walls()}
    names, velocity = walls_of_event(event.surfaces, list(surfaces), number, where), np.array(event.velocity_m_s)
    for name in names:
        facing = faces(surfaces[name])
        if facing is None:
            raise BadInput(f"events.{number}.surfaces", name, "is not one flat piece, as belts are; round ones rotate", where)
        if abs(float(velocity @ facing)) > ALONG * np.linalg.norm(velocity):
            allowed = f"must run along {name}, which faces {', '.join(f'{way:.3g}' for way in facing)}"
            raise BadInput(f"events.{number}.velocity_m_s", event.velocity_m_s, allowed, where)
    return names


def faces(surface: Surface) -> np.ndarray | None:
    """Unit vector across a surface that is one flat piece; None of others."""
    if isinstance(surface, FlatPiece):
        return None if surface.sheet else surface.normal
    level = isinstance(surface, LevelPiece) or (isinstance(surface, TurnedLine) and surface.start[1] == surface.end[1])
    return np.array([0.0, 0.0, 1.0]) if level else None


def check_spheres(scene: SphereScene, count: int, where: str) -> None:
    """BadInput for an event that takes out a sphere that `count` spheres do not have, or one twice."""
    removed = [event.sphere for event in scene.events]
    for number, sphere in enumerate(removed):
        if sphere is not None and sphere >= count:
            raise BadInput(f"events.{number}.sphere", sphere, f"must be below {count}, the number of spheres", where)
        if sphere is not None and sphere in removed[:number]:
            raise BadInput(f"events.{number}.sphere", sphere, "is taken out twice", where)


def turns_in_place(surface: Surface) -> bool:
    """Whether a surface stays where it is when it turns about the upright axis x = y = 0."""
    if isinstance(surface, LevelPiece):
        outlines = (surface.outline, *(hole.outline for hole in surface.holes))
        return all(outline.sides == CIRCLE and outline.middle == (0.0, 0.0) for outline in outlines)
    return isinstance(surface, TurnedLine) and surface.axis == (0.0, 0.0)


def check_turning(scene: SphereScene, space: SpaceSilo, where: str) -> None:
    """BadInput for surfaces that do not stay where they are when they turn."""
    surfaces = {surface.name: surface for surface in space.walls()}
    for number, event in enumerate(scene.events):
        turned = walls_of_event(event.surfaces, list(surfaces), number, where) if event.do == "rotate" else ()
        if not all(turns_in_place(surfaces[name]) for name in turned):
            allowed = "turn about the axis of a circular silo alone, whose outlet, if any, is round and in its middle"
            raise BadInput(f"events.{number}.surfaces", ", ".join(event.surfaces), allowed, where)
