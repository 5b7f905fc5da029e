"""Builds a scene of spheres in SI from the user's units: silo, materials, contacts, rain, and events."""

from dataclasses import replace
from math import isnan, nan
from typing import Any, NamedTuple

import numpy as np

from silostudy.config.elastic import MaterialConfig, TouchConfig
from silostudy.config.mixture import GRAIN
from silostudy.config.spheres import SphereScene
from silostudy.contact.coefficient import Given
from silostudy.contact.rolling import spring_slider
from silostudy.dem.contacts import Contact
from silostudy.dem.pieces import Laws
from silostudy.dem.rain import Rain
from silostudy.dem.space.inserts import INSERTS
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput, within
from silostudy.scene.dem import inserted, keys_of, walls_contact
from silostudy.scene.lid import slides
from silostudy.scene.silo_from import silo_of
from silostudy.scene.space_silo import Outlet, SpaceSilo
from silostudy.scene.surfaces import check_names
from silostudy.tables.materials import MATERIALS, PAIRS, Material

BELOW_TOP = 1.05  # radii: the plane of the rain below the top of the walls, where a scene does not say
MPA = 1e6  # Pa


def space_silo_of(scene: SphereScene, where: str = "") -> SpaceSilo:
    """The silo in space; BadInput for one that has no surfaces, or a heap that grains make of themselves."""
    if scene.silo.heap_at_repose or scene.silo.top_cone_height_m:
        raise BadInput("silo.top_cone_height_m", scene.silo.top_cone_height_m, "spheres make their heap themselves", where)
    outlets = tuple(
        Outlet(width=outlet.width_m, length=outlet.length_m, middle=outlet.middle_m, name=outlet.name)
        for outlet in scene.outlets
    )
    with within(where):
        return SpaceSilo(
            silo=silo_of(scene.silo, nan, where, ""),
            outlets=outlets,
            inserts=tuple(inserted(number, insert, INSERTS) for number, insert in enumerate(scene.inserts)),
            wedge=scene.wedge,
            lid=scene.lid,
            gated=slides(scene.events),
        )


def material_of(config: MaterialConfig) -> Material:
    """The material with the values that replace the table's."""
    own: dict[str, Any] = {
        "youngs_modulus": config.youngs_modulus_MPa and config.youngs_modulus_MPa * MPA,
        "poissons_ratio": config.poissons_ratio,
        "density": getattr(config, "density_kg_m3", None),
    }
    given = {name: value for name, value in own.items() if value is not None}
    if config.material is None:
        return Material(key="own", title="", source="the scene", locator="the scene", **given)
    return replace(MATERIALS[config.material], **given)


def grain_of(scene: SphereScene, where: str = "", kind: str = GRAIN) -> Material:
    """The material that spheres of a kind are computed with; BadInput without a density."""
    config, section = scene.grain_kinds[kind], GRAIN if kind == GRAIN else f"other_grains.{kind}"
    grain, soft = material_of(config), config.softened_modulus_MPa
    if isnan(grain.density):
        raise BadInput(f"{section}.density_kg_m3", None, f"must be given: {grain.title} has none", where)
    if soft is not None and soft * MPA > grain.youngs_modulus:
        raise BadInput(
            f"{section}.softened_modulus_MPa", soft, f"must not be above the material's {grain.youngs_modulus / MPA:g}", where
        )
    return grain if soft is None else replace(grain, youngs_modulus=soft * MPA)


def contacts_of(scene: SphereScene, where: str = "") -> tuple[Contact | Varied, Contact | Varied]:
    """Contacts between spheres, and of spheres and walls: from the materials and what their pair says.

    Kinds of spheres have contacts of their own by pairs, and walls each where the scene tells a surface from the others.
    """
    bodies = {kind: ElasticBody(grain_of(scene, where, kind), config.material) for kind, config in scene.grain_kinds.items()}
    kinds = list(bodies)
    between = [
        _contact(*scene.between(kind, other), bodies[kind], bodies[other], where, wall=False)
        for number, kind in enumerate(kinds)
        for other in kinds[: number + 1]
    ]
    names = wall_names(scene, where)
    check_names(scene, kinds, names, where)
    at_walls = [walls_contact(scene, _at_walls(scene, kind, body, where), names, where) for kind, body in bodies.items()]
    if len(kinds) == 1:
        return between[0], at_walls[0]
    sets = tuple(contact for walls in at_walls for contact in (walls.numbered(number) for number in range(len(names))))
    return Varied(tuple(between)), Varied(sets)


def _at_walls(scene: SphereScene, kind: str, body: "ElasticBody", where: str) -> dict[str, Contact]:
    """Contacts of a kind of spheres at surfaces that differ, by their names in the scene; "": at the others."""
    return {
        name: _contact(section, touch, body, ElasticBody(material_of(wall), wall.material), where, wall=True)
        for name, (section, wall, touch) in scene.at_surfaces(kind).items()
    }


def wall_names(scene: SphereScene, where: str = "") -> list[str]:
    """Names of the surfaces."""
    return [surface.name for surface in space_silo_of(scene, where).walls()]


class ElasticBody(NamedTuple):
    """An elastic body of a contact: its material, and the key of that in the table of pairs."""

    material: Material
    key: str | None


def _contact(section: str, config: TouchConfig, body: ElasticBody, other: ElasticBody, where: str, *, wall: bool) -> Contact:
    laws, fields, known = config.laws, config.model_dump(), PAIRS.get(frozenset((body.key, other.key)))
    for name in ("restitution", "sliding_friction"):
        if fields[name] is None:
            if known is None:
                told = f"must be given: no table holds the pair of {body.material.title} and {other.material.title}"
                raise BadInput(f"{section}.{name}", None, told, where)
            fields[name] = getattr(known, name)
    rolling = spring_slider.FRICTION.field
    if known is not None and not fields.get(rolling):
        fields[rolling] = known.rolling_friction
    fields["materials"] = tuple((of.material.youngs_modulus, of.material.poissons_ratio) for of in (body, other))
    given = Given(fields, nan, body.material.density, laws["normal"], wall, True)
    coefficients: dict[str, float] = {}
    with within(where, keys_of(section, laws)):
        for law in laws.values():
            coefficients |= law.prepared(given)
        return Contact(Laws(**laws), coefficients)


def plane_of_rain(scene: SphereScene, space: SpaceSilo, largest: float) -> float:
    """Height (m) above the outlet of the plane that spheres up to a radius (m) come in on."""
    return space.top - BELOW_TOP * largest if scene.filling.height_m is None else scene.filling.height_m


def rain_of(scene: SphereScene, space: SpaceSilo, radii: np.ndarray) -> Rain:
    """Rain of spheres of these radii (m): spots even over the plane, or over a round stream."""
    filling, height = scene.filling, plane_of_rain(scene, space, float(radii.max()))
    outline, aside, half = space.outline(height), scene.silo.filling_eccentricity_m, (filling.width_m or 0.0) / 2
    low, high = outline.box

    def spots(random: np.random.Generator, radius: float, count: int) -> np.ndarray:
        if filling.width_m is None:
            x, y = random.uniform(low, high, (count, 2)).T
        else:
            x, y = _disc(random, half - radius, count)
            x = x + aside
        free = outline.inset(x, y) >= radius
        return np.column_stack([x, y, np.full(count, height)])[free]

    return Rain(rate=filling.rate_1_s, velocity=(0.0, 0.0, -filling.speed_m_s), level=height, spots=spots, seed=scene.seed)


def _disc(random: np.random.Generator, radius: float, count: int) -> np.ndarray:
    """Places (2, count; m), even over a disc about the origin."""
    turn, off = random.uniform(0.0, 2.0 * np.pi, count), radius * np.sqrt(random.uniform(0.0, 1.0, count))
    return np.stack([off * np.cos(turn), off * np.sin(turn)])
