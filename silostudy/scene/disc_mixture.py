"""Kinds of discs in one scene: which disc is of which, their radii and densities, and the contacts of every pair."""

import numpy as np

from silostudy.config.dem import DemScene
from silostudy.errors import BadInput
from silostudy.scene.shares import whole


def radii_of_kinds(scene: DemScene) -> np.ndarray:
    """Radius (m) of each kind."""
    return np.array([scene.radius_m, *(kind.radius_m for kind in scene.other_grains.values())])


def densities_of_kinds(scene: DemScene) -> np.ndarray:
    """Density (kg/m3) of each kind."""
    return np.array([scene.density_kg_m3, *(kind.density_kg_m3 for kind in scene.other_grains.values())])


def kinds_of(scene: DemScene, count: int) -> np.ndarray | None:
    """Kind of each of so many discs, counted from 0, in a mixed order; None: they are of one."""
    others = scene.other_grains.values()
    if not others:
        return None
    by_mass = all(kind.mass_share is not None for kind in others)
    shares = np.array([kind.mass_share if by_mass else kind.number_share for kind in others], float)
    weights = np.array([1.0 - shares.sum(), *shares])
    mass = densities_of_kinds(scene) * radii_of_kinds(scene) ** 2 if by_mass else 1.0
    numbers = whole(weights / mass, count)
    for name, number in zip(scene.kinds, numbers, strict=True):
        if not number:
            raise BadInput("packing", scene.packing.kind, f"so few discs that their shares leave none to {name}")
    return np.random.default_rng(scene.seed).permutation(np.repeat(np.arange(len(numbers)), numbers))


def uneven(scene: DemScene, radii: np.ndarray) -> bool:
    """Whether discs of these radii (m) differ in size or in mass, so that dashpots follow the masses of each pair."""
    return bool(np.ptp(radii) > 0.0 or np.ptp(densities_of_kinds(scene)) > 0.0)
