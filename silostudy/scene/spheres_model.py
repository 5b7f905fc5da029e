"""Builds the engine's model from a scene of spheres: where they start, what pushes them, and the time step."""

from dataclasses import replace
from math import sqrt
from typing import TypeAlias

import numpy as np
from scipy.spatial import cKDTree

from silostudy.config.spheres import SphereScene
from silostudy.contact import spring
from silostudy.dem.contacts import Contact
from silostudy.dem.space.model import SphereModel
from silostudy.dem.space.walls import Surface
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput
from silostudy.packing.filling import FILLINGS
from silostudy.packing.sizes import SIZES
from silostudy.scene.dem import DEEPEST
from silostudy.scene.dem_model import stepped
from silostudy.scene.lid import check_lid, lid_of, moves
from silostudy.scene.mixture import drawn
from silostudy.scene.outflow import called
from silostudy.scene.raining import flows_meanwhile
from silostudy.scene.space_silo import SpaceSilo
from silostudy.scene.sphere_events import check_spheres, check_turning, sphere_events
from silostudy.scene.spheres import contacts_of, grain_of, plane_of_rain, space_silo_of

# places (n, 3) and radii (m), and kinds where there are several
Start: TypeAlias = tuple[np.ndarray, np.ndarray, np.ndarray | None]
DENSEST = 0.7  # solid fraction that no random packing of nearly equal spheres comes to
APART = 3.0  # largest radii: between spheres that wait, one above the other over the silo


def sphere_model(scene: SphereScene, given: Start | None, where: str = "") -> SphereModel:
    """The engine's model; given: how spheres start by a file. BadInput for a start or a step that cannot be."""
    assert scene.march.integrator is not None, "no accuracy is measured that could choose it"
    space, row = space_silo_of(scene, where), FILLINGS[scene.filling.kind]
    check_frictions(scene, where)
    check_lid(scene.events, space.bottom, space.top, where)
    check_turning(scene, space, where)
    sphere_events(scene, space, 0.0, where)
    random = np.random.default_rng(scene.seed)
    places, radii, kind = given or _started(scene, space, random)
    check_spheres(scene, len(radii), where)
    check_outlet(scene, space, radii, kind, where)
    if row.rains:
        check_rain(scene, space, radii, where)
    else:
        check_start(space, places, radii, where)
    contacts, (x, y, z) = contacts_of(scene, where), places.T
    dense = np.array([grain_of(scene, where, name).density for name in scene.grain_kinds])
    density = float(dense[0]) if kind is None else dense[kind]
    model = SphereModel(
        x=x, y=y, z=z, radius=radii, density=density, walls=coated(space.walls(scene.record.pressure_cells), contacts[1]),
        pair_contact=contacts[0], wall_contact=contacts[1], dt=scene.march.step_s or 1.0, gravity=scene.gravity_m_s2,
        integrator=scene.march.integrator, watched=scene.record.wall_force_window_s is not None,
        booked=scene.record.energy, waiting=len(radii) if row.rains else 0, moving=moves(scene.events),
        kind=kind,
    )  # fmt: skip
    touching = space.plan.area / (2.0 * sqrt(3.0) * float(radii.min()) ** 2)  # in rows, each sphere in the gap of two
    model = replace(model, lid=lid_of(scene.events, space.plan.area, touching, float(model.mass.sum())))
    return stepped(scene, model, where)


def coated(walls: tuple[Surface, ...], contact: Contact | Varied) -> tuple[Surface, ...]:
    """The surfaces, each with the number of the first of those that have the same coefficients."""
    if not isinstance(contact, Varied):
        return walls
    sets = [contact.numbered(number) for number in range(len(contact.sets))]
    of_wall = [sets[number :: len(walls)] for number in range(len(walls))]
    return tuple(replace(wall, coat=of_wall.index(own)) for wall, own in zip(walls, of_wall, strict=True))


def _started(scene: SphereScene, space: SpaceSilo, random: np.random.Generator) -> Start:
    """Start of spheres that no file gives; those that will rain wait one above the other."""
    row = FILLINGS[scene.filling.kind]
    radii, kind = drawn(scene, random)
    if row.place is not None:
        return row.place(space, radii, random), radii, kind
    heights = space.top + APART * float(radii.max()) * (1.0 + np.arange(len(radii)))
    return np.column_stack([np.zeros((len(radii), 2)), heights]), radii, kind


def check_frictions(scene: SphereScene, where: str) -> None:
    """BadInput for a friction that no law of the scene takes."""
    for number, event in enumerate(scene.events):
        for field, config in (("sphere_friction", scene.spheres), ("wall_friction", scene.walls)):
            law, value = config.laws["tangential"], getattr(event, field)
            if value is not None and spring.FRICTION not in law.coefficients:
                raise BadInput(f"events.{number}.{field}", value, f"the tangential law {law.key} takes no friction", where)


def check_outlet(scene: SphereScene, space: SpaceSilo, radii: np.ndarray, kind: np.ndarray | None, where: str) -> None:
    """BadInput where the largest sphere does not pass an outlet, or does not fit the silo at all."""
    number = int(radii.argmax())
    largest = float(radii[number])
    rooms = {"is wider than the silo": min(space.plan.half)}
    rooms |= {f"does not pass the {called(name)}": min(opening.half) for name, opening in space.openings.items()}
    for told, half in rooms.items():
        if half < largest:
            field, value = _said_of_largest(scene, 0 if kind is None else int(kind[number]))
            raise BadInput(field, value, f"a sphere of {2e3 * largest:g} mm {told}, {2e3 * half:g} mm", where)


def _said_of_largest(scene: SphereScene, kind: int) -> tuple[str, object]:
    """Key of a scene that says how wide the largest sphere of a kind is, and what it says."""
    if FILLINGS[scene.filling.kind].from_file:
        return "filling.file", scene.filling.file
    name = list(scene.grain_kinds)[kind]
    sizes, section = (scene.other_grains[name].sizes, f"other_grains.{name}.sizes") if kind else (scene.sizes, "sizes")
    widest = SIZES[sizes.kind].widest
    return f"{section}.{widest}", getattr(sizes, widest)


def check_rain(scene: SphereScene, space: SpaceSilo, radii: np.ndarray, where: str) -> None:
    """BadInput for a plane outside the silo, a stream that has no room, or more spheres than the silo holds."""
    filling, largest = scene.filling, float(radii.max())
    height = plane_of_rain(scene, space, largest)
    if not largest < height <= space.top - largest:
        allowed = f"must be from {largest:.4g} to {space.top - largest:.4g} m: the plane lies outside the silo"
        raise BadInput("filling.height_m", height, allowed, where)
    for number, insert in enumerate(space.inserts):
        heights = np.array(insert.corners)[:, 2]  # type: ignore[attr-defined]
        if heights.min() - largest < height < heights.max() + largest:
            told = f"stands in the plane that spheres come in on, at {height:.4g} m"
            raise BadInput(f"inserts.{number}", insert.name, told, where)
    if filling.width_m is not None and filling.width_m < 2.0 * largest:
        raise BadInput(
            "filling.width_m", filling.width_m, f"must be {2.0 * largest:.4g} m or more, the largest diameter", where
        )
    outline, aside = space.outline(height), scene.silo.filling_eccentricity_m
    widest = float(np.ptp(outline.box, axis=0).max())
    if filling.width_m is not None and filling.width_m > widest:
        raise BadInput("filling.width_m", filling.width_m, f"must be at most {widest:.4g} m, the silo's width there", where)
    if aside and filling.width_m is None:
        allowed = "of a stream that is as wide as the silo: give filling.width_m, or leave it out"
        raise BadInput("silo.filling_eccentricity_m", aside, allowed, where)
    if outline.inset(aside, 0.0) < largest:
        raise BadInput("silo.filling_eccentricity_m", aside, "the stream lies outside the silo", where)
    volume, room = float((4.0 / 3.0 * np.pi * radii**3).sum()), space.volume_below(height)
    if volume > DENSEST * room and not flows_meanwhile(scene):
        most = int(DENSEST * room / volume * len(radii))
        raise BadInput("filling.count", len(radii), f"no room below the plane for more than {most} of these spheres", where)


def check_start(space: SpaceSilo, places: np.ndarray, radii: np.ndarray, where: str) -> None:
    """BadInput where two spheres overlap by more than a tenth of a radius, or one starts in or beyond a wall."""
    i, j = cKDTree(places).query_pairs(2.0 * radii.max(), output_type="ndarray").reshape(-1, 2).T
    overlap = radii[i] + radii[j] - np.linalg.norm(places[i] - places[j], axis=1)
    deep = np.flatnonzero(overlap > DEEPEST * np.minimum(radii[i], radii[j]))
    if len(deep):
        k = deep[np.argmax(overlap[deep])]
        raise BadInput("filling", f"spheres {i[k]}, {j[k]}", f"overlap by {overlap[k]:.4g} m at the start", where)
    free = space.room_at(places, (1.0 - DEEPEST) * radii)
    if not free.all():
        k = int(np.argmin(free))
        x, y, z = places[k]
        raise BadInput("filling", f"sphere {k}", f"starts in or beyond a wall, at x {x:.4g}, y {y:.4g}, z {z:.4g} m", where)
