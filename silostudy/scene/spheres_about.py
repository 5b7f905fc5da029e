"""Lines that tell a scene of spheres before it runs: materials, coefficients, softening, times, effects."""

from collections.abc import Iterator
from math import pi, sqrt

import numpy as np

from silostudy.config.mixture import GRAIN
from silostudy.config.spheres import SphereScene
from silostudy.dem.neighbours import TOO_DEEP
from silostudy.dem.space.model import SphereModel
from silostudy.packing.filling import FILLINGS
from silostudy.packing.sizes import SIZES
from silostudy.scene.cautions import DEEP
from silostudy.scene.dem import Effect, law_effect, reading_effects, surfaces_effect
from silostudy.scene.lid import moves
from silostudy.scene.spheres import MPA, contacts_of, grain_of, material_of, plane_of_rain, space_silo_of
from silostudy.tables.materials import Material

FOOT_SOLID_FRACTION = 0.6  # of a loose random packing: for an estimate alone


def rayleigh_time(material: Material, radius: float) -> float:
    """Time (s) that a Rayleigh wave takes over half a sphere's girth.

    pi R sqrt(rho/G)/(0.1631 nu + 0.8766), as codes of discrete elements print it.
    """
    shear = material.youngs_modulus / (2.0 * (1.0 + material.poissons_ratio))
    return pi * radius * sqrt(material.density / shear) / (0.1631 * material.poissons_ratio + 0.8766)


def overlap_at(pressure: float, model: SphereModel, kind: int = 0) -> float:
    """Overlap over the radius (1) of two mean spheres of a kind under a pressure (Pa), each carrying it over 4 R^2.

    Hertz: F = 4/3 E* sqrt(R/2) delta^1.5.
    """
    radius, stiffness = float(radii_of(model, kind).mean()), model.between(kind, kind).coefficients["hertz_stiffness"]
    return float((pressure * 4.0 * radius**2 / (stiffness * sqrt(radius / 2.0))) ** (2.0 / 3.0) / radius)


def overlap_of_fall(scene: SphereScene, model: SphereModel, kind: int = 0) -> float:
    """Largest overlap over the radius (1) of a mean sphere that rain lets fall onto its like from the plane to the outlet.

    Hertz: (15 m* v^2 / (16 E* sqrt(R*)))^0.4, without its dashpot.
    """
    radius, mass = float(radii_of(model, kind).mean()), float(model.mass[of_kind(model, kind)].mean())
    drop = plane_of_rain(scene, space_silo_of(scene), float(model.radius.max()))
    square = scene.filling.speed_m_s**2 + 2.0 * float(-model.gravity[2]) * drop
    modulus = 0.75 * model.between(kind, kind).coefficients["hertz_stiffness"]
    return float((15.0 * mass / 2.0 * square / (16.0 * modulus * sqrt(radius / 2.0))) ** 0.4 / radius)


def of_kind(model: SphereModel, kind: int) -> np.ndarray:
    """Mask of the spheres of a kind."""
    return np.ones(len(model.radius), bool) if model.kind is None else model.kind == kind


def radii_of(model: SphereModel, kind: int) -> np.ndarray:
    """Radii (m) of the spheres of a kind."""
    return model.radius[of_kind(model, kind)]


def filled_to(scene: SphereScene, model: SphereModel) -> float:
    """Height (m) that the spheres fill, in a loose random packing."""
    space = space_silo_of(scene)
    volume = float((4.0 / 3.0 * pi * model.radius**3).sum()) / FOOT_SOLID_FRACTION
    low, high = 0.0, space.top
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if space.volume_below(middle) < volume else (low, middle)
    return low


def softening(scene: SphereScene, model: SphereModel) -> list[str]:
    """Lines on the moduli that are computed with, and the overlap that the column's weight makes of them."""
    high = filled_to(scene, model)
    density = float(model.mass.sum() / (4.0 / 3.0 * pi * model.radius**3).sum())
    pressure = FOOT_SOLID_FRACTION * density * float(-model.gravity[2]) * high
    lines = []
    for kind, name in enumerate(scene.grain_kinds):
        whose = f"{name}: " if scene.other_grains else ""
        lines += [f"{whose}{line}" for line in _softened(scene, model, kind, name)]
        for line, deep, most in _overlaps(scene, model, kind, name, pressure, high):
            lines.append(f"note: {whose}{line}: beyond {most:.0%}" if deep > most else f"{whose}{line}")
    return lines


def _softened(scene: SphereScene, model: SphereModel, kind: int, name: str) -> list[str]:
    real, used = material_of(scene.grain_kinds[name]).youngs_modulus, grain_of(scene, kind=name).youngs_modulus
    if not real > used:
        return []
    if not model.pair_contact.laws.normal.of_hertz:
        return ["softened_modulus_MPa changes nothing: no law here takes the modulus"]
    ratio = real / used
    return [
        f"softened: modulus {used / MPA:g} MPa in place of {real / MPA:g}, a ratio of {ratio:.3g}: steps {sqrt(ratio):.2g} "
        f"times as long, overlaps {ratio ** (2.0 / 3.0):.3g} times as deep"
    ]


def _overlaps(
    scene: SphereScene, model: SphereModel, kind: int, name: str, pressure: float, high: float
) -> Iterator[tuple[str, float, float]]:
    """Lines on how deep spheres of a kind overlap, with that over the radius (1) and the most that passes without a note.

    Under the column that is what the cube warns of, in a fall, which lasts a moment, what ends a run.
    """
    real, used = material_of(scene.grain_kinds[name]).youngs_modulus, grain_of(scene, kind=name).youngs_modulus
    if not (model.pair_contact.laws.normal.of_hertz and pressure > 0.0):
        return
    deep = overlap_at(pressure, model, kind)
    told = f"overlap at the foot of {high:.3g} m of spheres without friction at walls: {deep:.2%} of the radius"
    yield f"{told}; unsoftened {deep * (used / real) ** (2.0 / 3.0):.2%}" if real > used else told, deep, DEEP
    if FILLINGS[scene.filling.kind].rains:
        fallen = overlap_of_fall(scene, model, kind)
        yield f"overlap of the longest fall: {fallen:.2%} of the radius, without dashpots", fallen, TOO_DEEP


def materials(scene: SphereScene) -> list[str]:
    """Lines on the materials of spheres and walls, and of surfaces that have their own."""
    surfaces = {name: wall for name, (_, wall, _) in scene.at_surfaces(GRAIN).items() if wall != scene.wall}
    walls = {"wall": scene.wall, **surfaces}
    return [
        *(_material(name, grain := grain_of(scene, kind=name), f", rho {grain.density:g} kg/m3") for name in scene.grain_kinds),
        *(_material(name, material_of(wall)) for name, wall in walls.items()),
    ]


def _material(name: str, body: Material, density: str = "") -> str:
    source = f"{body.source}, {body.locator}" if body.source != body.locator else body.source
    told = f"E {body.youngs_modulus / MPA:g} MPa, nu {body.poissons_ratio:g}{density}"
    return f"{name}: {f'{body.title}, ' if body.title else ''}{told} ({source})"


def wave_times(scene: SphereScene, model: SphereModel) -> str:
    """Rayleigh time (s) of the smallest sphere, of each kind where there are several."""
    times = {
        name: rayleigh_time(grain_of(scene, kind=name), float(radii_of(model, number).min()))
        for number, name in enumerate(scene.grain_kinds)
    }
    return ", ".join(f"{time:.3g} s ({name})" if len(times) > 1 else f"{time:.3g} s" for name, time in times.items())


def shares(scene: SphereScene, model: SphereModel) -> list[str]:
    """Lines on how many spheres there are of each kind, where there are several."""
    if model.kind is None:
        return []
    numbers = [of_kind(model, kind) for kind in range(model.kinds)]
    return [
        f"{name}: {own.sum()} spheres, {model.mass[own].sum() / model.mass.sum():.1%} of the mass, diameters "
        f"{2e3 * model.radius[own].min():.4g} to {2e3 * model.radius[own].max():.4g} mm"
        for name, own in zip(scene.grain_kinds, numbers, strict=False)
    ]


def sphere_effects(scene: SphereScene) -> tuple[Effect, ...]:
    """Every effect the engine knows: whether this scene calls for it, and the key that says so."""
    contacts, record = dict(zip(("spheres", "walls"), contacts_of(scene), strict=True)), scene.record
    sizes = SIZES[scene.sizes.kind].title if scene.sizes else "from the file"
    others = f"other_grains: {', '.join(scene.other_grains) or 'none'}"
    uneven = scene.sizes is None or scene.sizes.kind != "equal" or bool(scene.other_grains)
    return (
        law_effect("friction, rotation, history", "tangential", contacts),
        law_effect("rolling resistance", "rolling", contacts),
        law_effect("twisting resistance", "twisting", contacts),
        law_effect("cohesion", "cohesion", contacts),
        surfaces_effect(scene),
        Effect("several kinds of spheres", bool(scene.other_grains), others),
        Effect("spheres of several sizes", uneven, f"sizes: {sizes}"),
        Effect("rain", FILLINGS[scene.filling.kind].rains, f"filling.kind: {scene.filling.kind}"),
        Effect("shaking", scene.quake is not None, "quake"),
        Effect("wall forces every step", record.wall_force_window_s is not None, "record.wall_force_window_s"),
        Effect("energy balance", record.energy, f"record.energy: {record.energy}"),
        Effect("several outlets", len(scene.outlets) > 1, f"outlets: {len(scene.outlets)}"),
        Effect("inserts", bool(scene.inserts), f"inserts: {len(scene.inserts)}"),
        Effect("hopper", scene.silo.hopper is not None, "silo.hopper"),
        Effect(
            "walls that move",
            moves(scene.events),
            "events: lower_lid, press_lid, move_lid, rotate, run_belt, open_outlet at a speed",
        ),
        Effect("events", len(scene.events) > 1, ", ".join(event.do for event in scene.events)),
        *reading_effects(scene),
    )
