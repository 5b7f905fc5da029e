"""A steel shell as a user writes it: the steel, how well it is made, and its ends."""

from itertools import pairwise
from typing import Literal, Self, TypeAlias

from pydantic import Field, field_validator, model_validator

from silostudy.config.fields import Strict, described
from silostudy.config.scene import possible

Quality: TypeAlias = Literal["A", "B", "C"]
Manufacture: TypeAlias = Literal["manufactured", "fabricated", "fabricated_safe"]


class Making(Strict):
    """Quality of a shell's fabrication, and how its ends are held."""

    quality: Quality = described("EN 1993-1-6 fabrication quality class: A excellent, B high, C normal", "")
    end_factor: Literal[6, 3, 1] = described("EN 1993-1-6 factor C_xb of the end conditions, for long shells", default=1)


class Steel(Making):
    """The steel of a shell."""

    youngs_modulus_GPa: float = described("Young's modulus", "GPa", default=210.0, **possible("youngs_modulus_GPa"))
    shell_poisson_ratio: float = described("Poisson's ratio of the steel", ge=0, lt=0.5, default=0.3)
    yield_stress_MPa: float = described("yield stress", "MPa", **possible("yield_stress_MPa"))
    manufacture: Manufacture = described(
        "Miller's kind of shell: manufactured as a tube, fabricated from plates, or fabricated with his safe constants", ""
    )


class Cylinder(Steel):
    """One unpressurised or pressurised cylinder under axial compression."""

    radius_m: float = described("radius of the middle surface", "m", gt=0)
    thickness_mm: float | None = described("wall thickness", "mm", gt=0, default=None)
    radius_over_thickness: float | None = described("R/t, in place of thickness_mm", gt=1, default=None)
    bay_length_m: float | None = described("ring spacing; the whole length where there are no rings", "m", gt=0, default=None)
    relative_bay_length: float | None = described("L / sqrt(R t), in place of bay_length_m", gt=0, default=None)
    ring_area_cm2: float | None = described("area of one ring; left out: no rings", "cm2", gt=0, default=None)
    ring_area_ratio: float = described("ring area over bay area L t, in place of ring_area_cm2; 0: no rings", ge=0, default=0.0)
    lower_internal_pressure_kPa: float = described("smallest guaranteed internal pressure", "kPa", default=0.0)
    upper_internal_pressure_kPa: float | None = described("largest internal pressure; null: the smallest", "kPa", default=None)

    @model_validator(mode="after")
    def _one_of_two(self) -> Self:
        for first, second in (("thickness_mm", "radius_over_thickness"), ("bay_length_m", "relative_bay_length")):
            if (getattr(self, first) is None) == (getattr(self, second) is None):
                raise ValueError(f"give either {first} or {second}, and not both")
        if self.thickness_mm is not None and self.thickness_mm >= self.radius_m * 1e3:
            raise ValueError(f"thickness_mm must be below the radius, {self.radius_m * 1e3:g} mm")
        if self.ring_area_cm2 is not None and self.ring_area_ratio:
            raise ValueError("give either ring_area_cm2 or ring_area_ratio, and not both")
        upper = self.upper_internal_pressure_kPa
        if upper is not None and upper < self.lower_internal_pressure_kPa:
            raise ValueError("upper_internal_pressure_kPa must not be below lower_internal_pressure_kPa")
        return self


class Strake(Strict):
    """A part of the wall with its own thickness."""

    down_to: float = described(
        "depth of its lower edge over the height of the cylinder; both its ends are looked at, whatever the depths",
        gt=0,
        le=1,
    )
    thickness_mm: float = described("wall thickness", "mm", gt=0)


class Rings(Strict):
    """Equal rings at equal distances."""

    spacing_m: float = described("distance of the rings", "m", gt=0)
    area_cm2: float = described("area of one ring", "cm2", gt=0)


class SiloWall(Steel):
    """The steel wall of a silo's cylinder."""

    strakes: tuple[Strake, ...] = Field(
        default=(), description="from the top down; none: only the thickness that the load asks for is computed"
    )
    rings: Rings | None = described("ring stiffeners; null: none, and the bay is the whole height", "", default=None)
    safety_factor: float = described(
        "number by which the axial stress and the largest pressure (elephant's foot, hoop tension) are multiplied before they "
        "meet the strength; the smallest guaranteed pressure, which steadies the wall, is not",
        ge=1,
        le=10,
    )
    joint_efficiency: float = described(
        "strength of the vertical welds over that of the plate, in hoop tension; 1: as strong. ASME VIII-1, table UW-12: butt "
        "joint welded from both sides 1.0, 0.85, 0.7 with full, spot, no radiography; codes disagree on lapped joints",
        gt=0,
        le=1,
        default=1.0,
    )
    density_kg_m3: float = described(
        "density of the steel, for the own weight of the wall above; 0: left out", "kg m-3", ge=0, le=20000, default=7850.0
    )
    roof_kN: float = described("weight of the roof, on the top of the wall all round", "kN", ge=0, default=0.0)
    snow_kPa: float = described("snow on the roof, over the plan", "kPa", ge=0, le=100, default=0.0)

    @field_validator("density_kg_m3")
    @classmethod
    def _heavier_than_water(cls, density):
        if 0 < density < 1000:
            raise ValueError("must be 0, or 1000 to 20000 kg/m3: steel has about 7850")
        return density

    @model_validator(mode="after")
    def _strakes_reach_the_foot(self) -> Self:
        edges = [strake.down_to for strake in self.strakes]
        if edges and (edges[-1] != 1 or any(b <= a for a, b in pairwise(edges))):
            given = ", ".join(f"{edge:g}" for edge in edges)
            raise ValueError(f"the strakes' down_to must increase and end at 1, the foot of the cylinder: {given}")
        return self
