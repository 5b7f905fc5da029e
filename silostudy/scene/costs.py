"""About what a discrete-element scene costs, before anything of it is built."""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.config.dem import DemScene
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.spheres import SphereScene
from silostudy.contact.family import Touch
from silostudy.dem.contacts import Contact
from silostudy.dem.strength import DEEP
from silostudy.dem.varied import set_of_pair
from silostudy.packing import PACKINGS
from silostudy.packing.filling import FILLINGS
from silostudy.packing.sizes import SIZES
from silostudy.scene.scenes import SceneCase
from silostudy.scene.spheres import contacts_of, grain_of

START = 0.02  # s: building a scene
LINE = 100  # bytes of a body in a file
UNKNOWN = np.array([1e-3])  # m: radius of spheres whose sizes stand in a file
SETTLES = 0.2  # s from the end of a rain to rest: 0.17 to 0.27 in the silos of config/silos.yaml
OF_MEAN = 32  # fillings of a case whose mean is asked for: as many as its scatter asks for, some tens
MINUTE = 60.0  # s
HOUR = 3600.0  # s
DRAWN = 200  # sizes that the ends of a distribution are guessed from


@dataclass(frozen=True)
class Costs:
    """Costs of a run. count(scene, folder) -> bodies; step(scene) -> usual time step (s); body, look: CPU time (s).

    body: of each in a step, look: of a step besides, most of it looks at rest and at what has left.
    """

    count: Callable[[Any, Path], float]
    step: Callable[[Any], float]
    body: float
    look: float


def cost(case: SceneCase, step: float | None = None) -> float:
    """About how long (s) a case computes: bodies times steps to its end, at most; of a rain, to a rest soon after it.

    step: of the built model (s); None: what is usual.
    """
    scene, folder = case.config, case.folder
    costs = COSTS[scene.grains]
    step = step or scene.march.step_s or costs.step(scene) * (scene.march.step_factor or 1.0)
    whole, full = until_end(scene)
    once = START + (whole * costs.look + full * costs.count(scene, folder) * costs.body) / step
    return OF_MEAN * once if scene.of_fillings else once


def told_time(seconds: float) -> str:
    """A computing time (s) in words: seconds, from a minute on minutes, from two hours on hours."""
    if seconds < MINUTE:
        return f"{seconds:.2g} s"
    return f"{seconds / HOUR:.1f} h" if seconds >= 2.0 * HOUR else f"{seconds / MINUTE:.3g} min"


def rains(scene: AnyScene) -> bool:
    """Whether grains rain in and an event waits for their rest."""
    rained = isinstance(scene, SphereScene) and FILLINGS[scene.filling.kind].rains
    return rained and any(event.when == "rest" for event in scene.events)


def until_end(scene: AnyScene) -> tuple[float, float]:
    """Model time (s) to the stop, and the part of it for which all grains are there; they rain in at an even rate."""
    longest = duration(scene)
    if not (isinstance(scene, SphereScene) and rains(scene)):
        return longest, longest
    raining = scene.filling.count / scene.filling.rate_1_s
    after = SETTLES + sum(event.value for event in scene.events if event.when == "after")
    whole = min(raining + after, longest)
    return whole, whole - min(raining, whole) / 2.0


def duration(scene: AnyScene) -> float:
    """Model time (s) to the stop where events have their times, else to the limit."""
    now = 0.0
    for event in scene.events:
        if event.when not in ("time", "after"):
            return scene.march.limit_s
        now = event.value + (now if event.when == "after" else 0.0)
    return min(now, scene.march.limit_s)


def _discs(scene: DemScene, folder: Path) -> float:
    section, packing = scene.packing, PACKINGS[scene.packing.kind]
    if packing.count is not None:
        return packing.count(scene.radius_m, **packing.arguments(section))
    return _in_file(folder / section.file)


def _disc_step(scene: DemScene) -> float:
    mass = scene.density_kg_m3 * pi * scene.radius_m**2
    stiffness = max((contact and contact.normal_stiffness_N_m2) or 0.0 for contact in (scene.discs, scene.walls))
    return 0.4 * sqrt(mass / stiffness) if stiffness else 2e-5


def _spheres(scene: SphereScene, folder: Path) -> float:
    filling = scene.filling
    return _in_file(folder / filling.file) if FILLINGS[filling.kind].from_file else filling.count


def _sphere_step(scene: SphereScene) -> float:
    """Time step (s) from the smallest sphere's mass and the stiffness of two of them at the engine's overlap."""
    between, _ = contacts_of(scene)
    kinds = zip(scene.grain_kinds, (scene.sizes, *(kind.sizes for kind in scene.other_grains.values())), strict=True)
    return min(_step_of_kind(scene, name, sizes, between.numbered(set_of_pair(k, k))) for k, (name, sizes) in enumerate(kinds))


def _step_of_kind(scene: SphereScene, name: str, sizes, between: Contact) -> float:
    radii = UNKNOWN if sizes is None else SIZES[sizes.kind].radii(np.random.default_rng(0), DRAWN, sizes)
    least, most = float(radii.min()), float(radii.max())
    mass = grain_of(scene, kind=name).density * 4.0 / 3.0 * pi * least**3
    touch, c = Touch(mass / 2.0, least / 2.0, 1.0), between.ordered[0]
    return 0.09 * sqrt(mass / float(between.laws.normal.stiffness(DEEP * most, touch, c)))


def _in_file(path: Path) -> float:
    """About how many bodies a file holds."""
    return path.stat().st_size / LINE if path.is_file() else 1


COSTS = {
    "discs": Costs(_discs, _disc_step, 35e-9, 0.0),  # `silostudy explain config/scenes/kiyama-17-18.yaml`, with its looks
    "spheres": Costs(_spheres, _sphere_step, 45e-9, 2e-5),  # of config/scenes/wheat-bin.yaml and of tests' small bin
}
