"""Ranges of the quantities of a silo and its contents: beyond the possible they are refused, beyond the usual told.

PLAUSIBLE is of grains, by the keys of their scenes: wide enough that what lies beyond is a slip of units before anything else.
The usual ends lie well outside Table E.1 of EN 1991-4 and the handbook's tables; they are this package's own.
"""

from dataclasses import dataclass
from math import inf

from silostudy.tables.units import split_unit

WIDE = ("unit_weight_kN_m3", "unit_weight_lower_kN_m3")
SPREADS = ("a_phi", "a_K", "a_mu")
FRICTIONS = ("wall_friction", "hopper_wall_friction", "d1", "d2", "d3")


@dataclass(frozen=True)
class Range:
    """Possible and usual ends of a quantity in the unit of its name; open: the possible ends themselves are not."""

    least: float
    greatest: float
    usual: tuple[float, float] = (-inf, inf)
    open: bool = False

    @property
    def constraints(self) -> dict[str, float]:
        """The possible ends as pydantic writes them."""
        names = ("gt", "lt") if self.open else ("ge", "le")
        return {name: end for name, end in zip(names, (self.least, self.greatest), strict=True) if abs(end) < inf}

    def unusual(self, value: float) -> bool:
        """Whether a value lies beyond the usual ends."""
        return not self.usual[0] <= value <= self.usual[1]


# quantity with the unit that a user writes it in -> its range; no bulk solid is denser than the densest metal's powder
WRITTEN = {
    **dict.fromkeys(WIDE, Range(0.0, 200.0, (2.0, 40.0), open=True)),
    "internal_friction_angle_deg": Range(0.0, 90.0, (10.0, 60.0), open=True),
    "effective_friction_angle_deg": Range(0.0, 90.0, (20.0, 75.0), open=True),
    "wall_friction_angle_deg": Range(0.0, 90.0, (3.0, 50.0), open=True),
    "repose_angle_deg": Range(0.0, 90.0, (15.0, 60.0), open=True),
    **dict.fromkeys(FRICTIONS, Range(0.0, 10.0, (0.05, 1.2))),
    "lateral_pressure_ratio": Range(0.0, 5.0, (0.2, 1.0)),
    "poisson_ratio": Range(0.0, 0.5, (0.1, 0.49), open=True),
    "i_phi": Range(0.0, 1.0),
    **dict.fromkeys(SPREADS, Range(1.0, 10.0, (1.0, 1.6))),
    "largest_particle_mm": Range(0.0, 5000.0, open=True),
    "patch_factor": Range(0.0, 10.0, (0.0, 1.0)),
    "diameter_m": Range(0.0, 1000.0, (0.05, 60.0), open=True),
    "cylinder_depth_m": Range(0.0, 1000.0, (0.05, 100.0), open=True),
    "slenderness": Range(0.0, 1000.0, (0.1, 10.0), open=True),
    "yield_stress_MPa": Range(10.0, 3000.0, (150.0, 1000.0)),
    "youngs_modulus_GPa": Range(1.0, 2000.0, (60.0, 220.0)),
    "thickness_mm": Range(0.0, 1000.0, (0.5, 60.0), open=True),
    "half_angle_deg": Range(0.0, 90.0, (5.0, 75.0), open=True),
}


BY_QUANTITY = {split_unit(written)[0]: (written, limits) for written, limits in WRITTEN.items()}

SIZES_MM = ("diameter_mm", "least_mm", "largest_mm", "mean_mm", "median_mm", "openings_mm")
PLAUSIBLE = {  # from foams to osmium, from gels to diamond, from flour's finest to boulders
    "density_kg_m3": (20.0, 23_000.0),
    "youngs_modulus_MPa": (1e-3, 1.3e6),
    "youngs_modulus_Pa": (1e3, 1.3e12),
    **dict.fromkeys(SIZES_MM, (0.01, 2000.0)),
    "radius_m": (5e-6, 1.0),
}
