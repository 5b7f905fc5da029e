"""Numbers of a packing study's scenes on which the errors of its means hang."""

from collections.abc import Sequence
from math import sqrt

from silostudy.config.packing import PackingStudy
from silostudy.scene.packing import SlitScene, discs_of


def packing_traits(study: PackingStudy, scenes: Sequence[SlitScene]) -> list[dict[str, float]]:
    """Traits of each scene: scatter by friction, and how far discs of a row are apart and offset, over the radius."""
    traits = []
    for scene in scenes:
        discs, count = scene.config.discs, len(discs_of(study, scene.config, 1)[0])
        number = friction_scatter(discs.disc_friction, discs.wall_friction, count)
        offsets = {"offset": study.offset_m / discs.radius_m, "offset_gap": study.offset_gap_m / discs.radius_m}
        pitch = (scene.config.silo.width_m - 2.0 * discs.radius_m) / (scene.config.across - 1) / discs.radius_m
        traits.append({"friction_scatter": number, "pitch": pitch, **offsets})
    return traits


def friction_scatter(discs: float, walls: float, count: int) -> float:
    """Root of both frictions' product over the number of discs (1): what friction leaves open, the more the fewer share it."""
    return sqrt(discs * walls / count)
