"""One plane cell of a laboratory with its filling of discs: sizes and stiffness in SI, a metre thick."""

from dataclasses import dataclass
from functools import cached_property
from math import nan, pi

from silostudy.config.laboratory_scenes import DiscLaboratory
from silostudy.contact.family import Touch
from silostudy.dem.contacts import Contact
from silostudy.scene.dem import contact_of
from silostudy.scene.laboratory_cell import Cell

LOOSE = 0.8  # about the solid fraction of a filling: it sets how many grains make the height
TRAY = 96.0  # width of the tray that is drained, and of the base below it, in grains
DEEP = 0.25  # depth of the tray's filling over its width


@dataclass(frozen=True)
class DiscCase(Cell):
    """One plane cell with its filling of discs."""

    config: DiscLaboratory

    @property
    def grain(self) -> float:
        """Mean diameter (m) of the discs."""
        return 2.0 * self.config.radius_m

    @property
    def density(self) -> float:
        """Density (kg/m3) of the discs."""
        return self.config.density_kg_m3

    @property
    def grain_area(self) -> float:
        """Mean area (m2) of the discs."""
        return pi * self.config.radius_m**2 * (1.0 + self.config.radius_spread**2 / 3.0)

    @property
    def count(self) -> int:
        """Number of discs."""
        return round(LOOSE * self.width * self.height / self.grain_area)

    @property
    def tray(self) -> float:
        """Width (m) of the tray that is drained onto a base of the same width."""
        return TRAY * self.grain

    @property
    def heap_count(self) -> int:
        """Number of discs in that tray."""
        return round(LOOSE * DEEP * self.tray**2 / self.grain_area)

    def at_wall(self, *, wall: bool = True) -> Contact:
        """Contact of a disc of the mean radius with the wall's material, or with another disc."""
        config, uneven = self.config, self.config.radius_spread > 0.0
        return contact_of(
            config.walls if wall else config.discs, config.radius_m, config.density_kg_m3, wall=wall, uneven=uneven
        )

    def stiffness(self, *, wall: bool) -> float:
        """Normal stiffness (N/m2) of a contact that is pressed in by a hundredth of the radius."""
        contact, radius = self.at_wall(wall=wall), self.config.radius_m
        mass = self.config.density_kg_m3 * self.grain_area
        touch = Touch(mass / 2.0, radius / 2.0, 1.0)
        return float(contact.laws.normal.stiffness(0.01 * radius, touch, contact.ordered[0]))

    @cached_property
    def modulus(self) -> float:
        """Stiffness (Pa) of two discs: a stress over it is about how deep they are pressed in, over a diameter."""
        return self.stiffness(wall=False)

    @property
    def restitution(self) -> float:
        """Restitution (1) at the wall that the study asks for; NaN where it says a dashpot."""
        asked = self.config.walls.restitution
        return nan if asked is None else asked
