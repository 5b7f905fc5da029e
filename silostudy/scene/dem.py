"""From the user's units to a discrete-element scene in SI: walls, discs, contacts, events, and which effects it calls for."""

from dataclasses import dataclass
from math import radians

import numpy as np

from silostudy.config.contact import ContactConfig
from silostudy.config.dem import BoxConfig, DemScene, EventConfig
from silostudy.contact.family import Given
from silostudy.dem.events import Event
from silostudy.dem.model import Contact, Wall
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput
from silostudy.packing import PACKINGS
from silostudy.scene.plane_silo import FLOOR, HALVES, PlaneSilo

DEEPEST = 0.1  # of a radius: overlap that a start may have (a packing at rest has some)


@dataclass(frozen=True)
class Effect:
    """One thing that can be compiled in: whether this scene calls for it, and why."""

    name: str
    on: bool
    why: str


def plane_silo_of(config: BoxConfig) -> PlaneSilo:
    """The silo in SI."""
    angle = config.hopper_half_angle_deg
    half_angle = None if angle is None else radians(angle)
    return PlaneSilo(config.width_m, config.height_m, config.slit_width_m, half_angle, config.lid)


def contact_of(config: ContactConfig, radius: float, density: float) -> Contact:
    """Laws and coefficients in SI, each prepared as its law says."""
    given = Given(config.model_dump(), radius, density)
    coefficients: dict[str, float] = {}
    for law in config.laws.values():
        coefficients |= law.prepared(given)
    return Contact(Laws(**config.laws), coefficients)


def events_of(scene: DemScene) -> tuple[Event, ...]:
    """Events in the engine's words."""
    beside = HALVES if scene.silo.hopper_half_angle_deg is None else ()
    found = []
    for event in scene.events:
        action, what = _action(event, beside)
        found.append(Event(event.when, event.value, action, what))
    return tuple(found)


def _action(event: EventConfig, beside: tuple[str, ...]) -> tuple[str, tuple]:
    if event.do == "remove_disc":
        return "remove", (event.disc,) if event.near_m is None else event.near_m
    if event.do == "set_gravity":
        assert event.gravity_m_s2 is not None  # the model asks for it
        return "gravity", event.gravity_m_s2
    if event.do == "set_friction":
        return "friction", (event.disc_friction, event.wall_friction)
    return ("open", (FLOOR, *beside)) if event.do == "open_slit" else ("stop", ())


def check_start(walls: tuple[Wall, ...], x, y, radius, where: str = "") -> None:
    """BadInput where two discs overlap by more than a tenth of a radius, or a disc's centre lies outside the walls."""
    from scipy.spatial import cKDTree

    pairs = cKDTree(np.c_[x, y]).query_pairs(2.0 * radius.max(), output_type="ndarray").reshape(-1, 2)
    i, j = pairs.T
    overlap = radius[i] + radius[j] - np.hypot(x[i] - x[j], y[i] - y[j])
    worst = int(np.argmax(overlap)) if len(overlap) else -1
    if worst >= 0 and overlap[worst] > DEEPEST * min(radius[i[worst]], radius[j[worst]]):
        raise BadInput("packing", f"discs {i[worst]}, {j[worst]}", f"overlap by {overlap[worst]:.4g} m at the start", where)
    for wall in walls:
        (x0, y0), (x1, y1) = wall.start, wall.end
        length = np.hypot(x1 - x0, y1 - y0)
        along = ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length
        inside = ((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)) / length
        out = np.flatnonzero((along >= 0.0) & (along <= length) & (inside < (1.0 - DEEPEST) * radius) & wall.live)
        if len(out):
            raise BadInput("packing", f"disc {out[0]}", f"starts in or beyond the wall {wall.name}", where)


def effects(scene: DemScene) -> tuple[Effect, ...]:
    """Every effect the engine knows: whether this scene calls for it, and the key that says so."""
    walls = scene.walls or scene.discs
    laws, sliding = scene.discs.laws, (scene.discs.laws["tangential"], walls.laws["tangential"])
    slides = {"discs": scene.discs.tangential, "walls": walls.tangential}
    uneven = PACKINGS[scene.packing.kind].uneven(scene.packing)
    record = scene.record
    return (
        Effect("friction, rotation, history", any(law.acts for law in sliding), f"tangential: {slides}"),
        Effect("rolling resistance", laws["rolling"].acts, f"discs.rolling: {scene.discs.rolling}"),
        Effect("cohesion", laws["cohesion"].acts, f"discs.cohesion: {scene.discs.cohesion}"),
        Effect("discs of several sizes", uneven, f"packing.kind: {scene.packing.kind}"),
        Effect("shaking", scene.quake is not None, "quake"),
        Effect("wall forces every step", record.wall_force_window_s is not None, "record.wall_force_window_s"),
        Effect("energy ledger", record.energy, f"record.energy: {record.energy}"),
        Effect("slit", scene.silo.slit_width_m > 0, f"silo.slit_width_m: {scene.silo.slit_width_m:g}"),
        Effect("hopper", scene.silo.hopper_half_angle_deg is not None, "silo.hopper_half_angle_deg"),
        Effect("events", len(scene.events) > 1, ", ".join(event.do for event in scene.events)),
        Effect("snapshots", bool(record.snapshots_s), f"record.snapshots_s: {len(record.snapshots_s)} times"),
    )
