"""Limits that several buckling rules share, and which rings are stiff enough to end a bay."""

import numpy as np

from silostudy.buckling.family import HOOP_YIELD, NO_RINGS, OUT_OF_RANGE, SMALL_RINGS, SUCTION, ShellLimit
from silostudy.limits import Measure

LEAST_RING_RATIO = 0.06  # of ring area over bay area L t


def needed_ring_ratio(*, bay_length, shell_radius, thickness):
    """Ratio A_r / (L t) (1) from which a ring ends a bay: 0.06 + 2 / Z^2, Z = L^2 sqrt(1 - nu^2) / (R t), nu = 0.3.

    Source: miller1977, text after eq. (12), for 0.06; 2 / Z^2 from one public program for offshore shells alone.
    """
    batdorf = bay_length**2 * np.sqrt(1 - 0.3**2) / (shell_radius * thickness)
    return LEAST_RING_RATIO + 2 / batdorf**2


def ring_share(*, ring_area, bay_length, shell_radius, thickness):
    """Ring area over the least that ends a bay (1); NaN without rings."""
    needed = needed_ring_ratio(bay_length=bay_length, shell_radius=shell_radius, thickness=thickness)
    return np.where(np.asarray(ring_area) > 0, ring_area / (bay_length * thickness) / needed, np.nan)


def between_supports(*, bay_length, total_length, ring_area, counts):
    """Length (m) between the edges that hold the wall: the bay, or the whole length where its rings are too small to count."""
    return np.where((np.asarray(ring_area) == 0) | counts, bay_length, total_length)


def _small_ring_share(*, ring_area, bay_length, total_length, shell_radius, thickness):
    """The same, NaN also where the whole length is known and the rings are left out."""
    share = ring_share(ring_area=ring_area, bay_length=bay_length, shell_radius=shell_radius, thickness=thickness)
    return np.where(np.isnan(total_length), share, np.nan)


SLENDERNESS = Measure("R/t", "1", lambda *, thickness, shell_radius: shell_radius / thickness)
GUARANTEED_PRESSURE = Measure("p_s", "Pa", lambda *, lower_internal_pressure: lower_internal_pressure)
RING_AREA = Measure("A_r", "m2", lambda *, ring_area: ring_area)
HOOP_SHARE = Measure(
    "p_g R/(t f_y)",
    "1",
    lambda *, upper_internal_pressure, shell_radius, thickness, yield_stress: (
        upper_internal_pressure * shell_radius / thickness / yield_stress
    ),
)

NO_SUCTION = ShellLimit(measure=GUARANTEED_PRESSURE, least=0.0, why="no rule here covers suction", reason=SUCTION)
WITHOUT_RINGS = ShellLimit(measure=RING_AREA, most=0.0, why="shells without rings only", reason=NO_RINGS)
THIN_SHELLS = ShellLimit(
    measure=SLENDERNESS, least=20.0, most=5000.0, why="EN 1993-1-6's range, from memory", reason=OUT_OF_RANGE
)
NOT_THICK = ShellLimit(
    measure=SLENDERNESS, least=20.0, why="thin shells; EN 1993-1-6's bound, from memory", reason=OUT_OF_RANGE
)
RINGS_THAT_COUNT = ShellLimit(
    measure=Measure("A_r/((0.06 + 2/Z^2) L t), whole length unknown", "1", _small_ring_share),
    least=1.0,
    tolerance=1e-9,
    why="smaller rings end no bay; 2/Z^2 by one source",
    reason=SMALL_RINGS,
)
BELOW_HOOP_YIELD = ShellLimit(measure=HOOP_SHARE, below=1.0, why="beyond it the pressure yields the wall", reason=HOOP_YIELD)
