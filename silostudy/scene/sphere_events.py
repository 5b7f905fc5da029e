"""From the user's words to the engine's: what happens in a scene of spheres."""

from silostudy.config.moves import OF_LID
from silostudy.config.sphere_events import SphereEventConfig
from silostudy.config.spheres import SphereScene
from silostudy.dem.events import TRIGGERS, Event
from silostudy.dem.space.surfaces import CIRCLE
from silostudy.dem.space.walls import TurnedLine
from silostudy.errors import BadInput
from silostudy.scene.dem import walls_of_event
from silostudy.scene.lid import lid_action
from silostudy.scene.space_silo import AROUND, FLOOR, SpaceSilo


def sphere_events(scene: SphereScene, space: SpaceSilo, mass: float, where: str = "") -> tuple[Event, ...]:
    """Events in the engine's words; mass: of all spheres, kg. BadInput for friction at a surface that there is none."""
    found = []
    for number, event in enumerate(scene.events):
        action, what = _action(event, space, mass)
        if action == "friction":
            what = (*what, walls_of_event(event.surfaces, [wall.name for wall in space.walls()], number, where))
        found.append(Event(event.when, event.value * TRIGGERS[event.when].scale, action, what))
    return tuple(found)


def _action(event: SphereEventConfig, space: SpaceSilo, mass: float) -> tuple[str, tuple]:
    if event.do == "set_gravity":
        assert event.gravity_m_s2 is not None  # the model asks for it
        return "gravity", event.gravity_m_s2
    if event.do == "set_friction":
        return "friction", (event.sphere_friction, event.wall_friction)
    if event.do == "rotate":
        return "turn", (event.spin_rad_s, *turned(event, space))
    if event.do == "feed":
        return "feed", (event.rate_kg_s,)
    if event.do in OF_LID:
        return lid_action(event, space.plan.area, mass, space.bottom, space.top)
    return ("open", (FLOOR, *space.waiting)) if event.do == "open_outlet" else ("stop", ())


def turned(event: SphereEventConfig, space: SpaceSilo) -> tuple[str, ...]:
    """Names of the engine's surfaces that turn; those about an outlet turn with the floor."""
    return (*event.surfaces, *([AROUND] if "floor" in event.surfaces and AROUND in space.waiting else []))


def check_turning(scene: SphereScene, space: SpaceSilo, where: str) -> None:
    """BadInput for surfaces that a silo does not have, or that do not stay where they are when they turn."""
    surfaces = {surface.name: surface for surface in space.walls()}
    for number, event in enumerate(scene.events):
        key, names = f"events.{number}.surfaces", turned(event, space)
        for name in names:
            if name not in surfaces and space.plan.sides == CIRCLE:
                raise BadInput(key, name, f"the silo has none; it has {', '.join(surfaces)}", where)
        if not all(isinstance(surfaces.get(name), TurnedLine) for name in names):
            allowed = "turn about the axis of a circular silo alone, whose outlet, if any, is round and in its middle"
            raise BadInput(key, ", ".join(event.surfaces), allowed, where)
