"""Warnings on how a scene of spheres is filled: a rain too much, too fast, beside the silo or too long, a heap without rain."""

from collections.abc import Iterator

import numpy as np

from silostudy.config.spheres import SphereScene
from silostudy.dem.model import Model
from silostudy.dem.run import CHECK_EVERY
from silostudy.dem.space.level import Outline
from silostudy.packing.filling import FILLINGS
from silostudy.scene.cautions import LETS_OUT
from silostudy.scene.costs import duration
from silostudy.scene.space_silo import SpaceSilo
from silostudy.scene.spheres import plane_of_rain

# solid fractions of equal spheres at rest at random
LOOSE = 0.55  # Onoda and Liniger, 1990
CLOSE = 0.64  # Scott and Kilgour, 1969
COVERED = 0.547  # of a plane by equal discs that come down on it at random until none finds room (Feder, 1980)


def rain_warnings(scene: SphereScene, space: SpaceSilo, model: Model) -> Iterator[str]:
    """A warning for each thing that a rain cannot do as its scene says, which its run would tell."""
    if FILLINGS[scene.filling.kind].rains and not scene.start_from:
        height = plane_of_rain(scene, space, float(model.radius.max()))
        yield from too_many(scene, space.volume_below(height), model.radius)
        yield from too_fast(scene, space.outline(height).area, model)
        yield from past_the_wall(scene, space.outline(height))
        yield from cut_short(scene, len(model.radius))


def flows_meanwhile(scene: SphereScene) -> bool:
    """Whether an event may let grains out before all have come in: rest and a lid wait for that."""
    for event in scene.events:
        if event.when == "rest" or event.of_lid:
            return False
        if event.do in LETS_OUT:
            return True
    return False


def too_many(scene: SphereScene, room: float, radii: np.ndarray) -> Iterator[str]:
    """A warning where spheres fill the room (m3) below their plane to more than a loose packing does."""
    fraction, count = float((4.0 / 3.0 * np.pi * radii**3).sum()) / room, len(radii)
    if fraction > LOOSE and not flows_meanwhile(scene):
        yield (
            f"filling.count = {count}: fills {fraction:.3g} of the room below the plane of the rain, and grains that rained in "
            f"rest at {LOOSE:g} to {CLOSE:g} or so: {int(LOOSE / fraction * count)} to {int(CLOSE / fraction * count)} may fit"
        )


def too_fast(scene: SphereScene, area: float, model: Model) -> Iterator[str]:
    """A warning where spheres do not fall off their plane (area, m2) as fast as others are to come.

    At most a layer comes in, at random, in the time that a sphere takes to clear the plane, or between two looks.
    """
    filling, pull, size = scene.filling, max(-scene.gravity_m_s2[2], 0.0), 2.0 * float(model.radius.mean())
    if not pull:
        return
    if filling.width_m is not None:
        area = min(area, np.pi * filling.width_m**2 / 4.0)
    layer = max(1.0, COVERED * area / (np.pi * float((model.radius**2).mean())))
    clears = 2.0 * size / (filling.speed_m_s + np.sqrt(filling.speed_m_s**2 + 2.0 * pull * size))
    most, count = layer / max(clears, CHECK_EVERY * model.step), len(model.radius)
    if filling.rate_1_s > most and count > layer:
        late = (count - 1) * (1.0 / most - 1.0 / filling.rate_1_s)
        yield (
            f"filling.rate_1_s = {filling.rate_1_s:g}: at most about {most:.3g} of these spheres a second find room on the "
            f"plane of the rain: the last of them comes {late:.2g} s late or later"
        )


def past_the_wall(scene: SphereScene, outline: Outline) -> Iterator[str]:
    """A warning where a stream reaches past the outline of the walls on the side that it is off the axis to."""
    width, aside = scene.filling.width_m, scene.silo.filling_eccentricity_m
    if aside and width and (out := -float(outline.inset(aside + width / 2.0, 0.0))) > 1e-9 * width:
        yield f"filling.width_m = {width:g}: the stream reaches {out:.3g} m past the wall, which cuts it"


def cut_short(scene: SphereScene, count: int) -> Iterator[str]:
    """A warning where the run ends at a time that is known before the last sphere comes in."""
    waits = any(event.of_lid for event in scene.events)  # a lid does, until all have come in
    last, end = (count - 1) / scene.filling.rate_1_s, scene.march.limit_s if waits else duration(scene)
    told = f"events.{len(scene.events) - 1} stops" if end < scene.march.limit_s else "march.limit_s ends"
    if end < last:
        yield f"filling.rate_1_s = {scene.filling.rate_1_s:g}: the last sphere comes in at {last:.4g} s, {told} it at {end:g} s"


def spread(scene: SphereScene) -> Iterator[str]:
    """A warning on an eccentric filling whose grains are there from the start, all over the silo."""
    row, aside = FILLINGS[scene.filling.kind], scene.silo.filling_eccentricity_m
    if aside and not (row.rains or row.from_file or scene.start_from):
        yield f"silo.filling_eccentricity_m = {aside:g}: a filling {row.key} begins all over the silo, without a heap"
