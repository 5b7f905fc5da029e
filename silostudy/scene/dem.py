"""Builds a scene of discs in SI from the user's units: walls, discs, contacts, events, and the effects it calls for."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import radians
from typing import Any

import numpy as np

from silostudy.config.contact import ContactConfig
from silostudy.config.dem import DemScene, EventConfig
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.moves import OF_LID
from silostudy.contact import NO_TANGENTIAL, TANGENTIAL, spring
from silostudy.contact.coefficient import Given
from silostudy.contact.family import Law
from silostudy.dem.events import TRIGGERS, Event
from silostudy.dem.inserts import LINES, Insert
from silostudy.dem.model import Contact, Wall
from silostudy.dem.pieces import Laws
from silostudy.dem.rest import REST, STEADY, USUAL, Rest
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput, within
from silostudy.packing import PACKINGS
from silostudy.scene.disc_mixture import radii_of_kinds, uneven
from silostudy.scene.lid import lid_action, moves
from silostudy.scene.plane_silo import FLOOR, HALVES, PlaneSilo, Slit
from silostudy.scene.surfaces import by_surface, check_names, parts_of

DEEPEST = 0.1  # of a radius: overlap that a start may have (a packing at rest has some)


@dataclass(frozen=True)
class Effect:
    """One thing that can be compiled in: whether this scene calls for it, and why; of a family of laws the one that acts."""

    name: str
    on: bool
    why: str
    law: str = ""


def plane_silo_of(scene: DemScene, where: str = "") -> PlaneSilo:
    """The silo in SI, with its inserts; BadInput for one that cannot be."""
    config, angle = scene.silo, scene.silo.hopper_half_angle_deg
    half_angle = None if angle is None else radians(angle)
    inserts = tuple(inserted(number, insert, LINES) for number, insert in enumerate(scene.inserts))
    slits = tuple(Slit(outlet.name, outlet.middle_m, outlet.width_m) for outlet in scene.outlets)
    with within(where):
        return PlaneSilo(config.width_m, config.height_m, config.slit_width_m, half_angle, config.lid, inserts, slits)


def inserted(number: int, config: Any, rows: Mapping[str, Insert]) -> Any:
    """The wall of an insert; BadInput for one that cannot be."""
    row = rows[config.kind]
    try:
        return row.make(**row.arguments(config))
    except BadInput as error:
        raise BadInput(f"inserts.{number}", config.name, f"{error.allowed}") from None


def contact_of(
    config: ContactConfig, radius: float, density: float, *, wall: bool = False, uneven: bool = False, slippery: bool = False
) -> Contact:
    """Laws and coefficients in SI, each prepared as its law says.

    wall: whether of discs and walls; uneven: whether discs differ in size; slippery: whether friction of zero stays so, and
    its law is left out.
    """
    laws = config.laws
    if slippery and config.sliding_friction == 0.0 and spring.FRICTION in laws["tangential"].coefficients:
        laws |= {"tangential": TANGENTIAL[NO_TANGENTIAL]}
    given = Given(config.model_dump(), radius, density, laws["normal"], wall, uneven)
    coefficients: dict[str, float] = {}
    with within(keys=keys_of("walls" if wall else "discs", laws)):
        for law in laws.values():
            coefficients |= law.prepared(given)
        return Contact(Laws(**laws), coefficients)


def keys_of(section: str, laws: Mapping[str, Law]) -> dict[str, str]:
    """Keys of a section of contacts: of the families of its laws, and of the coefficients that come from a field of its own."""
    own = (coefficient for law in laws.values() for coefficient in law.coefficients)
    return {name: f"{section}.{name}" for name in laws} | {row.name: f"{section}.{row.field}" for row in own}


def contacts_of(scene: DemScene, radii: np.ndarray, where: str = "") -> tuple[Contact | Varied, Contact | Varied]:
    """Contacts between discs of these radii (m), and of discs and walls; stiffness and damping of their own radius if equal.

    Kinds of discs have contacts of their own by pairs where those differ, and walls each where the scene tells a surface from
    the others.
    """
    differ, kinds = uneven(scene, radii), scene.kinds
    about: dict[str, Any] = {
        "radius": scene.radius_m if differ else float(radii[0]), "uneven": differ, "density": scene.density_kg_m3
    }  # fmt: skip
    changed = [event for event in scene.events if event.do == "set_friction"]
    at_walls = {kind: scene.at_surfaces(kind) for kind in kinds}
    smooth = not any(config.sliding_friction for configs in at_walls.values() for config in configs.values())
    smooth = smooth and all(event.wall_friction is None for event in changed)
    pairs = [scene.between(kind, other) for number, kind in enumerate(kinds) for other in kinds[: number + 1]]
    slippery = not any(pair.sliding_friction for pair in pairs) and all(event.disc_friction is None for event in changed)
    names, walls = wall_names(scene), []
    check_names(scene, kinds, names, where)
    for configs in at_walls.values():
        contacts = {name: contact_of(config, wall=True, slippery=smooth, **about) for name, config in configs.items()}
        walls.append(walls_contact(scene, contacts, names, where))
    return varied([contact_of(pair, slippery=slippery, **about) for pair in pairs]), of_kinds(walls, len(names))


def varied(contacts: list[Contact]) -> Contact | Varied:
    """Contacts as one where they are all alike."""
    return contacts[0] if all(contact == contacts[0] for contact in contacts) else Varied(tuple(contacts))


def of_kinds(contacts: list[Contact | Varied], walls: int) -> Contact | Varied:
    """Contacts of kinds of grains with so many walls, from those of each; one where all are alike."""
    if all(contact == contacts[0] for contact in contacts) and isinstance(contacts[0], Contact):
        return contacts[0]
    return Varied(tuple(contact.numbered(number) for contact in contacts for number in range(walls)))


def walls_contact(scene: AnyScene, contacts: dict[str, Contact], names: Sequence[str], where: str) -> Contact | Varied:
    """Contact with walls of these names, from those of surfaces that differ, by their names in the scene; "": of the others."""
    others = contacts.pop("")
    differ = bool(contacts) or any(event.do == "set_friction" and event.surfaces for event in scene.events)
    return Varied(tuple(by_surface(contacts, names, others, where))) if differ else others


def wall_names(scene: DemScene) -> list[str]:
    """Names of the walls."""
    return [wall.name for wall in plane_silo_of(scene).walls()]


def events_of(scene: DemScene, mass: float, where: str = "") -> tuple[Event, ...]:
    """Events in the engine's words; mass: of all discs, kg/m. BadInput for a friction that no law of the scene takes, or at a
    wall that there is none."""
    beside = HALVES if scene.silo.hopper_half_angle_deg is None else ()
    events = []
    for number, event in enumerate(scene.events):
        action, what = _action(event, scene, beside, mass)
        if action == "friction":
            _check_friction(scene, what, f"events.{number}", where)
            what = (*what, walls_of_event(event.surfaces, wall_names(scene), number, where))
        elif action == "run":
            what = (*what, *walls_of_event(event.surfaces, wall_names(scene), number, where))
        events.append(Event(event.when, event.value * TRIGGERS[event.when].scale, action, what, event.said))
    return tuple(events)


def walls_of_event(surfaces: tuple[str, ...], names: Sequence[str], number: int, where: str) -> tuple[str, ...]:
    """Names of the walls that an event is about."""
    return tuple(wall for surface in surfaces for wall in parts_of(surface, names, f"events.{number}.surfaces", where))


def _check_friction(scene: DemScene, what: tuple, key: str, where: str) -> None:
    for field, value, config in zip(("disc_friction", "wall_friction"), what, scene.touches, strict=True):
        law = config.laws["tangential"]
        if value is not None and spring.FRICTION not in law.coefficients:
            raise BadInput(f"{key}.{field}", value, f"the tangential law {law.key} takes no friction", where)


def rest_of(scene: AnyScene) -> Rest:
    """The criterion of rest."""
    restless = any(law.restless for touch in scene.touches for law in touch.laws.values())
    usual = STEADY if restless else USUAL
    criterion = REST[scene.rest.criterion] if scene.rest.criterion else usual
    return Rest(criterion, criterion.below if scene.rest.below is None else scene.rest.below)


def check_events(scene: DemScene, count: int, where: str = "") -> None:
    """BadInput for an event that takes out a disc that `count` discs do not have."""
    for number, event in enumerate(scene.events):
        if event.disc is not None and event.disc >= count:
            raise BadInput(f"events.{number}.disc", event.disc, f"must be below {count}, the number of discs", where)


def _action(event: EventConfig, scene: DemScene, beside: tuple[str, ...], mass: float) -> tuple[str, tuple]:
    if event.do == "remove_disc":
        return "remove", (event.disc,) if event.near_m is None else event.near_m
    if event.do == "set_gravity":
        assert event.gravity_m_s2 is not None  # the model asks for it
        return "gravity", event.gravity_m_s2
    if event.do == "set_friction":
        return "friction", (event.disc_friction, event.wall_friction)
    if event.do == "feed":
        return "feed", (event.rate_kg_s,)
    if event.do == "run_belt":
        return "run", (event.speed_m_s,)
    if event.do in OF_LID:
        silo = plane_silo_of(scene)
        return lid_action(event, silo.width, mass, silo.bottom, silo.bottom + silo.height)
    if event.do == "open_slit" and scene.outlets:
        names = event.outlets or tuple(outlet.name for outlet in scene.outlets)
        return "open holes", (FLOOR, names, event.speed_m_s or 0.0)
    return ("open", (FLOOR, *beside)) if event.do == "open_slit" else ("stop", ())


def check_start(walls: tuple[Wall, ...], x, y, radius, where: str = "") -> None:
    """BadInput where two discs overlap by more than a tenth of a radius, or a disc's centre lies outside the walls.

    Above the highest wall is outside too: a disc that falls over a wall is lost to the silo.
    """
    from scipy.spatial import cKDTree

    pairs = cKDTree(np.c_[x, y]).query_pairs(2.0 * radius.max(), output_type="ndarray").reshape(-1, 2)
    i, j = pairs.T
    overlap = radius[i] + radius[j] - np.hypot(x[i] - x[j], y[i] - y[j])
    worst = int(np.argmax(overlap)) if len(overlap) else -1
    if worst >= 0 and overlap[worst] > DEEPEST * min(radius[i[worst]], radius[j[worst]]):
        raise BadInput("packing", f"discs {i[worst]}, {j[worst]}", f"overlap by {overlap[worst]:.4g} m at the start", where)
    for wall in walls:
        out = np.flatnonzero((room(wall, x, y) < (1.0 - DEEPEST) * radius) & wall.live)
        if len(out):
            raise BadInput("packing", f"disc {out[0]}", f"starts in or beyond the wall {wall.name}", where)
    ends = np.array([end for wall in walls for end in (wall.start, wall.end)])
    (left, low), (right, high) = ends.min(axis=0), ends.max(axis=0)
    out = np.flatnonzero((x < left) | (x > right) | (y < low) | (y > high))
    if len(out):
        worst = out[np.argmax(y[out])]
        place = f"starts at x {x[worst]:.4g} m, y {y[worst]:.4g} m, outside walls from x {left:.4g} to {right:.4g} m and y "
        told = f"{place}{low:.4g} to {high:.4g} m; {len(x) - len(out)} of {len(x)} discs start inside"
        raise BadInput("packing", f"disc {worst}", told, where)


def room(wall: Wall, x, y) -> np.ndarray:
    """Distance (m) of places from a line, or from what is beside a wall with one face, negative behind it."""
    (x0, y0), (x1, y1) = wall.start, wall.end
    length = np.hypot(x1 - x0, y1 - y0)
    along = ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length
    inside = ((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) / length
    if wall.faces > 1:
        return np.hypot(inside, np.maximum(np.maximum(-along, along - length), 0.0))
    begin, end = wall.reach
    return np.where((along >= begin) & (along <= end), inside, np.inf)


def law_effect(name: str, family: str, contacts: Mapping[str, Contact | Varied]) -> Effect:
    """The effect of a family of laws, which discs or walls or both may call for."""
    rows = {where: getattr(contact.laws, family) for where, contact in contacts.items()}
    said = ", ".join(f"{where}.{family}: {row.key}" for where, row in rows.items())
    acting = [row.key for row in rows.values() if row.acts]
    return Effect(name, bool(acting), said, *acting[:1])


def surfaces_effect(scene: AnyScene) -> Effect:
    """The effect of walls that differ."""
    return Effect("walls of several coefficients", bool(scene.surfaces), f"surfaces: {', '.join(scene.surfaces) or 'none'}")


def reading_effects(scene: AnyScene) -> tuple[Effect, ...]:
    """Effects that are read between steps, and the measure of rest that is waited for."""
    record, rests = scene.record, any(event.when == "rest" for event in scene.events)
    every = f"every {record.snapshots_every_s:g} s" if record.snapshots_every_s else f"{len(record.snapshots_s)} times"
    cells = " x ".join(map(str, record.fields.cells)) if record.fields else "none"
    return (
        Effect("rest", rests, f"rest: {rest_of(scene)}"),
        Effect("snapshots", bool(record.snapshots_s or record.snapshots_every_s), f"record.snapshots: {every}"),
        Effect("fields", record.fields is not None, f"record.fields.cells: {cells}"),
        Effect("statistics of contacts", record.contact_statistics is not None, "record.contact_statistics"),
    )


def effects(scene: DemScene) -> tuple[Effect, ...]:
    """Every effect the engine knows: whether this scene calls for it, and the key that says so."""
    contacts = dict(zip(("discs", "walls"), contacts_of(scene, np.array([scene.radius_m])), strict=True))
    kinds = f"other_grains: {', '.join(scene.other_grains) or 'none'}"
    sizes = PACKINGS[scene.packing.kind].uneven(scene.packing) or np.ptp(radii_of_kinds(scene)) > 0.0
    record = scene.record
    return (
        law_effect("friction, rotation, history", "tangential", contacts),
        law_effect("rolling resistance", "rolling", contacts),
        law_effect("cohesion", "cohesion", contacts),
        surfaces_effect(scene),
        Effect("several kinds of discs", bool(scene.other_grains), kinds),
        Effect("discs of several sizes", bool(sizes), f"packing.kind: {scene.packing.kind}; {kinds}"),
        Effect("shaking", scene.quake is not None, "quake"),
        Effect("wall forces every step", record.wall_force_window_s is not None, "record.wall_force_window_s"),
        Effect("energy balance", record.energy, f"record.energy: {record.energy}"),
        Effect("slit", scene.silo.slit_width_m > 0, f"silo.slit_width_m: {scene.silo.slit_width_m:g}"),
        Effect(
            "outlets by names", bool(scene.outlets), f"outlets: {', '.join(outlet.name for outlet in scene.outlets) or 'none'}"
        ),
        Effect("hopper", scene.silo.hopper_half_angle_deg is not None, "silo.hopper_half_angle_deg"),
        Effect("inserts", bool(scene.inserts), f"inserts: {len(scene.inserts)}"),
        Effect(
            "walls that move", moves(scene.events), "events: lower_lid, press_lid, move_lid, run_belt, open_slit at a speed"
        ),
        Effect("events", len(scene.events) > 1, ", ".join(event.do for event in scene.events)),
        *reading_effects(scene),
    )
