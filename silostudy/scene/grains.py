"""The scenes of a grains study: a box, its filling and its shaking; where discs start."""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any

from silostudy.config.grains import GrainsScene, GrainsStudy
from silostudy.config.grains_spheres import RoundBox, ShakenSpheres
from silostudy.config.shaking import Shaking
from silostudy.contact.spring import FRICTION
from silostudy.packing import loose, rows
from silostudy.scene.grains_spheres import filling_scene
from silostudy.scene.spheres import contacts_of
from silostudy.scene.spheres_model import sphere_model
from silostudy.tables.kiyama_1983 import ACTIVE, GAPS, PASSIVE

ROWS = {"rows_17_18": ACTIVE, "rows_11_12": PASSIVE}  # discs across
SOLID_FRACTION = 0.82  # of settled random discs, to choose how many fill the height


@dataclass(frozen=True)
class ShakenBox:
    """One case: the configuration it came from, its filling (equal text, equal filling) and its shaking."""

    config: GrainsScene | ShakenSpheres
    filling: str
    shaking: Shaking

    @property
    def width(self) -> float:
        """Inner width, or diameter (m), of the box."""
        box = self.config.box
        return box.diameter_m if isinstance(box, RoundBox) else box.width_m

    @property
    def wall_friction(self) -> float:
        """Friction (1) of grains and walls."""
        if isinstance(self.config, GrainsScene):
            return self.config.wall_friction
        _, at_walls = contacts_of(filling_scene(self.config, seed=1))
        return float(at_walls.sets[0].coefficients.get(FRICTION.name, 0.0))


def grains_builder(study: GrainsStudy, folder: Path, where: str) -> Callable[[GrainsScene | ShakenSpheres, dict], ShakenBox]:
    """Builds the scenes of a grains study; BadInput for a packing that does not fit its box, or a silo that takes no rain."""

    def build_one(config: GrainsScene | ShakenSpheres, settings: dict[str, Any]) -> ShakenBox:
        if isinstance(config, GrainsScene):
            discs_of(config, seed=1)
        else:
            sphere_model(filling_scene(config, seed=1), None, f"{where} (scene)")
        return ShakenBox(config, config.model_dump_json(exclude={"shaking"}), config.shaking)

    return build_one


def discs_of(config: GrainsScene, seed: int):
    """Positions (m) and radii (m) of the discs at their start; BadInput for a packing that does not fit its box."""
    width, radius = config.box.width_m, config.grains.radius_m
    height = config.box.slenderness * width
    if config.packing == loose.ROW.key:
        count = max(1, round(SOLID_FRACTION * width * height / (pi * radius**2)))
        return loose.place(width=width, count=count, radius=radius, spread=config.grains.radius_spread, seed=seed)
    across = ROWS[config.packing]
    gap = GAPS[across]
    return rows.place(width=width, height=height, radius=radius, across=across, gap=gap, offset=gap / 3, seed=seed)
