"""Kinds of spheres in one scene: how many there are of each, of which radii, in which order they come in."""

import numpy as np

from silostudy.config.spheres import SphereScene
from silostudy.errors import BadInput
from silostudy.packing.sizes import SIZES
from silostudy.scene.shares import whole
from silostudy.scene.spheres import grain_of

ROUNDS = 5  # of numbers by the mean mass of as many spheres, which changes with them


def drawn(scene: SphereScene, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray | None]:
    """Radii (m) of all spheres and their kinds, counted from 0, in a mixed order; None: they are of one kind.

    Of shares of mass the numbers follow by the mean mass of the spheres of each kind.
    """
    count = scene.filling.count
    sizes = [scene.sizes, *(kind.sizes for kind in scene.other_grains.values())]
    radii = [SIZES[of.kind].radii(random, count, of) for of in sizes]
    if len(radii) == 1:
        return radii[0], None
    numbers = numbers_of(scene, radii)
    kind = np.repeat(np.arange(len(radii)), numbers)
    order = random.permutation(count)
    return np.concatenate([of[:number] for of, number in zip(radii, numbers, strict=True)])[order], kind[order]


def numbers_of(scene: SphereScene, radii: list[np.ndarray]) -> np.ndarray:
    """Number of spheres of each kind, of the first of these radii (m); BadInput where a kind would have none."""
    others, count = scene.other_grains.values(), len(radii[0])
    by_mass = all(kind.mass_share is not None for kind in others)
    shares = np.array([kind.mass_share if by_mass else kind.number_share for kind in others], float)
    weights = np.array([1.0 - shares.sum(), *shares])
    numbers = whole(weights, count)
    if by_mass:
        density = [grain_of(scene, kind=name).density for name in scene.grain_kinds]
        for _ in range(ROUNDS):
            masses = [rho * (of[: max(n, 1)] ** 3).mean() for rho, of, n in zip(density, radii, numbers, strict=True)]
            numbers = whole(weights / masses, count)
    for name, number in zip(scene.grain_kinds, numbers, strict=True):
        if not number:
            raise BadInput("filling.count", count, f"so few spheres that their shares leave none to {name}")
    return numbers
