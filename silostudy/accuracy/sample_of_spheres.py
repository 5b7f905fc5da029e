"""A sample of a scene's spheres near rest: from the price of their steps that of the scene follows before it runs."""

from dataclasses import replace
from typing import Any

import numpy as np

from silostudy.dem.space.model import SphereModel
from silostudy.dem.varied import Varied
from silostudy.packing.filling import ROOM, loose
from silostudy.scene.silo import Silo
from silostudy.scene.space_silo import SpaceSilo

SAMPLE = 2000  # spheres at most: as many fit the caches of a core
CELLS = (10, 12)


def sample(model: SphereModel) -> SphereModel:
    """Spheres of a model on a loose lattice in a cylinder about as high as wide, with the model's laws and effects.

    Evenly picked, so that sizes and kinds are there by their shares.  Walls stand: they cost little beside pairs.
    """
    picked = np.unique(np.linspace(0, len(model.x) - 1, min(len(model.x), SAMPLE)).astype(int))
    radius = model.radius[picked]
    pitch = ROOM * float(radius.max())
    wide = 1.1 * pitch * (4.0 / np.pi * len(radius)) ** (1.0 / 3.0) + 2.0 * pitch
    silo = SpaceSilo(silo=Silo(plan="circular", diameter=wide, wall_depth=2.0 * wide))
    x, y, z = loose(silo, radius, np.random.default_rng(0)).T
    walls = silo.walls(CELLS)
    own: dict[str, Any] = {"density": model.density if np.ndim(model.density) == 0 else np.asarray(model.density)[picked]}
    own |= dict.fromkeys(model.columns[model.space.ways + 1 :])
    own |= {} if model.kind is None else {"kind": model.kind[picked]}
    at_walls = model.wall_contact
    if isinstance(at_walls, Varied):
        at_walls = Varied(tuple(model.at_wall(kind, 0) for kind in range(model.kinds) for _ in walls))
    return replace(
        model, x=x, y=y, z=z, radius=radius, walls=walls, wall_contact=at_walls, waiting=0, moving=False, lid=None, quake=None,
        end=None, **own,
    )  # fmt: skip
