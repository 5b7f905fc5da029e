"""What is told of a scene of spheres before it runs: materials, coefficients, softening, times, effects, warnings."""

from math import pi, sqrt

import numpy as np

from silostudy.config.spheres import SphereScene
from silostudy.dem.space.model import SphereModel
from silostudy.packing.filling import FILLINGS
from silostudy.packing.sizes import SIZES
from silostudy.scene.dem import Effect, law_effect, surfaces_effect
from silostudy.scene.lid import moves
from silostudy.scene.spheres import MPA, contacts_of, grain_of, material_of, plane_of_rain, space_silo_of
from silostudy.scene.spheres_model import narrow
from silostudy.tables.materials import Material

FOOT_SOLID_FRACTION = 0.6  # of a loose random packing: for an estimate alone


def rayleigh_time(material: Material, radius: float) -> float:
    """Time (s) that a Rayleigh wave takes over half a sphere's girth.

    pi R sqrt(rho/G)/(0.1631 nu + 0.8766), as codes of discrete elements print it.
    """
    shear = material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio))
    return pi * radius * sqrt(material.density / shear) / (0.1631 * material.poissons_ratio + 0.8766)


def overlap_at(pressure: float, model: SphereModel) -> float:
    """Overlap over the radius (1) of two mean spheres under a pressure (Pa), each carrying it over its diameter squared.

    Hertz: F = 4/3 E* sqrt(R/2) delta^1.5.
    """
    radius, stiffness = float(model.radius.mean()), model.between(0, 0).coefficients["hertz_stiffness"]
    return float((pressure * 4.0 * radius**2 / (stiffness * sqrt(radius / 2.0))) ** (2.0 / 3.0) / radius)


def overlap_of_fall(scene: SphereScene, model: SphereModel) -> float:
    """Largest overlap over the radius (1) of a mean sphere that rain lets fall onto another from the plane to the outlet.

    Hertz: (15 m* v^2 / (16 E* sqrt(R*)))^0.4, without its dashpot.
    """
    radius, mass = float(model.radius.mean()), float(model.mass.mean())
    drop = plane_of_rain(scene, space_silo_of(scene), float(model.radius.max()))
    square = scene.filling.speed_m_s**2 + 2.0 * float(-model.gravity[2]) * drop
    modulus = 0.75 * model.between(0, 0).coefficients["hertz_stiffness"]
    return float((15.0 * mass / 2.0 * square / (16.0 * modulus * sqrt(radius / 2.0))) ** 0.4 / radius)


def softening(scene: SphereScene, model: SphereModel) -> list[str]:
    """Lines on the modulus that is computed with, and the overlap that the column's weight makes of it."""
    real, used = material_of(scene.grain).youngs_modulus, grain_of(scene).youngs_modulus
    space = space_silo_of(scene)
    volume = float((4.0 / 3.0 * pi * model.radius**3).sum()) / FOOT_SOLID_FRACTION
    low, high = 0.0, space.top
    for _ in range(40):  # the height that they fill
        middle = (low + high) / 2
        low, high = (middle, high) if space.volume_below(middle) < volume else (low, middle)
    pressure = FOOT_SOLID_FRACTION * float(np.mean(model.density)) * float(-model.gravity[2]) * low
    lines = []
    if real > used:
        ratio = real / used
        lines.append(
            f"softened: modulus {used / MPA:g} MPa in place of {real / MPA:g}, a ratio of {ratio:.3g}: steps {sqrt(ratio):.2g} "
            f"times as long, overlaps {ratio ** (2.0 / 3.0):.3g} times as deep"
        )
    if "hertz_stiffness" in model.between(0, 0).coefficients and pressure > 0.0:
        deep = overlap_at(pressure, model)
        told = f"overlap under {low:.3g} m of spheres without friction at walls: {deep:.2%} of the radius"
        lines.append(f"{told}; unsoftened {deep * (used / real) ** (2.0 / 3.0):.2%}" if real > used else told)
        if FILLINGS[scene.filling.kind].rains:
            lines.append(f"overlap of the longest fall: {overlap_of_fall(scene, model):.2%} of the radius, without dashpots")
    return lines


def materials(scene: SphereScene) -> list[str]:
    """Lines on the materials of spheres and walls, and of surfaces that have their own."""
    surfaces = [(name, material_of(of)) for name, (of, _) in scene.surface_contacts.items() if of != scene.wall]
    return [
        f"{name}: {body.title}, E {body.youngs_modulus / MPA:g} MPa, nu {body.poissons_ratio:g}"
        + (f", rho {body.density:g} kg/m3" if name == "grain" else "")
        + (f" ({body.source}, {body.locator})" if body.source != body.locator else f" ({body.source})")
        for name, body in (("grain", grain_of(scene)), ("wall", material_of(scene.wall)), *surfaces)
    ]


def warnings(scene: SphereScene, model: SphereModel) -> list[str]:
    """What is likely to be a mistake, a line each."""
    return narrow(space_silo_of(scene), model.radius)


def sphere_effects(scene: SphereScene) -> tuple[Effect, ...]:
    """Every effect the engine knows: whether this scene calls for it, and the key that says so."""
    contacts, record = dict(zip(("spheres", "walls"), contacts_of(scene), strict=True)), scene.record
    sizes = SIZES[scene.sizes.kind].title if scene.sizes else "from the file"
    return (
        law_effect("friction, rotation, history", "tangential", contacts),
        law_effect("rolling resistance", "rolling", contacts),
        law_effect("twisting resistance", "twisting", contacts),
        law_effect("cohesion", "cohesion", contacts),
        surfaces_effect(scene),
        Effect("spheres of several sizes", scene.sizes is None or scene.sizes.kind != "equal", f"sizes: {sizes}"),
        Effect("rain", FILLINGS[scene.filling.kind].rains, f"filling.kind: {scene.filling.kind}"),
        Effect("wall pressures every step", record.wall_force_window_s is not None, "record.wall_force_window_s"),
        Effect("energy ledger", record.energy, f"record.energy: {record.energy}"),
        Effect("several outlets", len(scene.outlets) > 1, f"outlets: {len(scene.outlets)}"),
        Effect("hopper", scene.silo.hopper is not None, "silo.hopper"),
        Effect("walls that move", moves(scene.events), "events: lower_lid, press_lid, move_lid, rotate"),
        Effect("events", len(scene.events) > 1, ", ".join(event.do for event in scene.events)),
        Effect("snapshots", bool(record.snapshots_s), f"record.snapshots_s: {len(record.snapshots_s)} times"),
    )
