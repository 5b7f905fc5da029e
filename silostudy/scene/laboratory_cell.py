"""One round cell of a laboratory with its filling of spheres: sizes and speeds in SI, and what plane cells share with it."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from math import nan, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.config.laboratory_scenes import LaboratoryScene
from silostudy.packing.sizes import SIZES
from silostudy.scene.spheres import MPA, material_of
from silostudy.tables.materials import PAIRS
from silostudy.tables.references import own_files

KPA = 1e3  # Pa
DRAWN = 2000  # sizes from which mean diameter and volume are taken
TRAY = 1.6  # width of a heap's tray over that of the cell
SLOPE = 0.47  # tangent of the angle that a heap is reckoned to have: it sets how many grains are poured
LOOSE = 0.57  # about the solid fraction of a filling: it sets how many grains make the height


@dataclass(frozen=True)
class Cell(ABC):
    """One cell with its filling: the configuration, the stresses (Pa) and shear strain (1) of its tests.

    Each sort of grains says its mean diameter `grain` (m) and its `density` (kg/m3).
    """

    config: Any
    folder: Path
    stresses: tuple[float, ...]
    shear_strain: float

    @property
    def files(self) -> tuple[Path, ...]:
        """The user's own files that the grains' laws come from."""
        return own_files(self.folder, self.config.methods_from)

    @property
    @abstractmethod
    def grain(self) -> float:
        """Mean diameter (m) of the grains."""

    @property
    @abstractmethod
    def density(self) -> float:
        """Density (kg/m3) of the grains."""

    @property
    def width(self) -> float:
        """Width (m) of the cell."""
        return self.config.cell_grains * self.grain

    @property
    def height(self) -> float:
        """Height (m) of the filling, about."""
        return self.config.height_grains * self.grain

    def speed(self, stress: float) -> float:
        """Speed (m/s) of an end at which the strain rate has the inertial number under a stress (Pa)."""
        return self.config.inertial_number * self.height / self.grain * sqrt(stress / self.density)


@dataclass(frozen=True)
class LaboratoryCase(Cell):
    """One round cell with its filling of spheres."""

    config: LaboratoryScene

    @cached_property
    def radii(self) -> np.ndarray:
        """Radii (m) of grains drawn from the sizes."""
        return SIZES[self.config.sizes.kind].radii(np.random.default_rng(0), DRAWN, self.config.sizes)

    @property
    def grain(self) -> float:
        """Mean diameter (m) of the grains."""
        return 2.0 * float(self.radii.mean())

    @property
    def density(self) -> float:
        """Density (kg/m3) of the grains; NaN where their material has none."""
        return material_of(self.config.grain).density

    @property
    def area(self) -> float:
        """Area (m2) of the cell's ends."""
        return 0.25 * pi * self.width**2

    @property
    def lever(self) -> float:
        """Radius (m) at which an even shear stress over an end would act for its torque: two thirds of the end's."""
        return self.width / 3.0

    @property
    def count(self) -> int:
        """Number of grains."""
        return round(LOOSE * self.area * self.height / self.grain_volume)

    @property
    def grain_volume(self) -> float:
        """Mean volume (m3) of the grains."""
        return float((4.0 / 3.0 * pi * self.radii**3).mean())

    @property
    def tray(self) -> float:
        """Width (m) of the tray that a heap is poured onto."""
        return TRAY * self.width

    @property
    def heap_count(self) -> int:
        """Number of grains of a heap: a cone of a usual slope over nine tenths of the tray."""
        return round(LOOSE * pi / 3.0 * (0.45 * self.tray) ** 3 * SLOPE / self.grain_volume)

    @property
    def modulus(self) -> float:
        """Young's modulus (Pa) that the grains are computed with."""
        return (self.config.grain.softened_modulus_MPa or material_of(self.config.grain).youngs_modulus / MPA) * MPA

    @property
    def restitution(self) -> float:
        """Restitution (1) of grains and wall that the study or the table of pairs asks for; NaN where neither says one."""
        known = PAIRS.get(frozenset((self.config.grain.material, self.config.wall.material)))
        asked = self.config.walls.restitution
        return asked if asked is not None else known.restitution if known else nan
