"""A discrete-element scene that asks for an accuracy: what the error of its wall forces hangs on, and which may ask."""

from collections.abc import Iterator, Sequence
from math import inf, pi, sqrt
from pathlib import Path

from silostudy.choice.promise import Choice
from silostudy.choice.settle import settled
from silostudy.config.contact import ContactConfig
from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene, scene_class
from silostudy.config.load import is_project, other_file, own_validated, read_yaml
from silostudy.contact import MEASURED
from silostudy.errors import BadInput
from silostudy.packing import rows
from silostudy.stages import KINDS

WALL_FORCE = "wall_force"  # the quantity of tables/asked.csv that the measured front is of


def load(path: Path) -> tuple[AnyScene, Choice | None]:
    """The scene in a YAML file with the settings chosen for its accuracy, and the choice; BadInput lists every mistake."""
    content = read_yaml(path)
    if is_project(content) or content.get("kind") in KINDS:
        raise other_file(content, str(path))
    scene = own_validated(scene_class(content, str(path)), content, str(path), path.parent)
    if scene.of_fillings:
        told = "is of many fillings: ask for it in a study of kind scenes, whose `scene:` holds what this file does"
        raise BadInput("accuracy", ", ".join(scene.of_fillings), told, str(path))
    return settled(scene, [scene], str(path)) if scene.accuracy else (scene, None)


def dem_traits(asking: DemScene, scenes: Sequence[DemScene]) -> list[dict[str, float]]:
    """Numbers (1) that the error of the wall forces at rest hangs on, of each scene."""
    return [scene_traits(scene) for scene in scenes]


def scene_traits(scene: DemScene) -> dict[str, float]:
    """The dynamics before rest, and the contacts (1); BadInput for a scene of a kind that was not measured.

    fall: gap over the overlap that a disc's weight makes, times the root of the layers of discs.  The errors go with
    restlessness or its root; the others say which scenes were measured.
    """
    walls = scene.walls or scene.discs
    for key, value, measured in _kinds(scene, walls):
        if value != measured:
            raise BadInput("accuracy", scene.accuracy, f"was measured with {key} {measured} alone, not {value}")
    assert scene.discs.normal_stiffness_N_m2 is not None
    assert walls.normal_stiffness_N_m2 is not None
    stiffness, mass = scene.discs.normal_stiffness_N_m2, scene.density_kg_m3 * pi * scene.radius_m**2
    gap = scene.packing.gap_m * stiffness / (-scene.gravity_m_s2[1] * mass)
    fall = gap * sqrt(0.5 * scene.packing.fill_height_m / scene.radius_m)
    direct, ratio = scene.discs.normal_damping_N_s_m2, _ratio(scene.discs)
    damping = direct / (2.0 * sqrt(mass * stiffness)) if direct is not None else ratio
    unrest = restlessness(fall, damping, walls.sliding_friction)
    return {
        "fall": fall,
        "restlessness": unrest,
        "restlessness_root": sqrt(unrest),
        "damping_ratio": damping,
        "wall_stiffness_ratio": walls.normal_stiffness_N_m2 / stiffness,
        "stiffness_ratio": scene.discs.stiffness_ratio,
        "disc_friction": scene.discs.sliding_friction,
        "wall_friction": walls.sliding_friction,
    }


def restlessness(fall: float, damping_ratio: float, wall_friction: float) -> float:
    """Trait (1) that the errors of wall forces go with; infinite without damping.

    Powers of the three traits that errors of 32 silos, each at 15 steps, were seen to go with.
    """
    return fall**0.87 * wall_friction**0.25 / damping_ratio**0.7 if damping_ratio else inf


def _ratio(discs: ContactConfig) -> float:
    """Damping ratio (1) of a disc's mass, which a pair's reduced mass is half of."""
    if discs.restitution is not None:
        return discs.laws["normal"].damped(discs.restitution) / sqrt(2.0)
    return discs.damping_ratio or 0.0


def _kinds(scene: DemScene, walls: ContactConfig) -> Iterator[tuple[str, object, object]]:
    """Keys whose values make a scene of the kind that was measured: name, value, the one measured."""
    across, up = scene.gravity_m_s2
    yield "packing.kind", scene.packing.kind, rows.ROW.key
    yield "silo.hopper_half_angle_deg", scene.silo.hopper_half_angle_deg, None
    yield "quake", scene.quake, None
    yield "surfaces", scene.surfaces or None, None
    yield "gravity", "straight down" if across == 0 and up < 0 else scene.gravity_m_s2, "straight down"
    for name, contact in (("discs", scene.discs), ("walls", walls)):
        for family, law in contact.laws.items():
            yield f"{name}.{family}", law.key, MEASURED[family]
        yield f"{name}.line_contact", contact.line_contact, None
