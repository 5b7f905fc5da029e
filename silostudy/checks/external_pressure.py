"""Hoop compression of the empty wall: wind outside and suction inside, by EN 1993-1-6:2007."""

import numpy as np

from silostudy.checks.capacity import KNOWN_CLASSES, capacity
from silostudy.checks.family import SteelCheck
from silostudy.limits import Limit, Measure

LONGEST = 1.63  # omega / C over r / t up to which a cylinder is of medium length
# ends of k_w
WIND_LEAST = 0.65
WIND_MOST = 1.0
# (upper edge, lower edge) -> C_theta; with theory's first eigenvalue of a beam over pi beside it: 1.506, 1.250, 1, 0.597
EDGE_FACTORS = {
    ("clamped", "clamped"): 1.5,
    ("clamped", "pinned"): 1.25,
    ("pinned", "clamped"): 1.25,
    ("pinned", "pinned"): 1.0,
    ("free", "clamped"): 0.6,
}


def critical_pressure(*, youngs_modulus, inner_radius, thickness, wall_height, edge_factor):
    """External pressure (Pa) at which a perfect cylinder of medium length buckles: 0.92 E C_theta (r/l) (t/r)^2.5.

    Source: en1993_1_6_2007, annex D, two public programs; semi-membrane theory gives 0.9177.
    """
    r = inner_radius + thickness / 2
    return 0.92 * youngs_modulus * edge_factor * r / wall_height * (thickness / r) ** 2.5


def wind_factor(*, inner_radius, thinnest, wall_height, edge_factor):
    """Wind factor k_w (1), even pressure over that at the stagnation line: 0.46 (1 + 0.1 sqrt(C_theta r/(omega t))), 0.65 to 1.

    Source: en1993_1_6_2007, annex D, two sources; the ends by one of them.
    """
    r = inner_radius + thinnest / 2
    relative_length = wall_height / np.sqrt(r * thinnest)
    return np.clip(0.46 * (1 + 0.1 * np.sqrt(edge_factor * r / (relative_length * thinnest))), WIND_LEAST, WIND_MOST)


def even_pressure(*, wind_pressure, suction, inner_radius, thinnest, wall_height, edge_factor):
    """External pressure (Pa), even round the wall, that stands for wind and suction: k_w q + q_s. Source: en1993_1_6_2007."""
    factor = wind_factor(inner_radius=inner_radius, thinnest=thinnest, wall_height=wall_height, edge_factor=edge_factor)
    return factor * wind_pressure + suction


def hoop_compression(*, wind_pressure, suction, inner_radius, thickness, thinnest, wall_height, edge_factor):
    """Hoop stress (Pa), compression positive, of a course: p r / t. Source: en1993_1_6_2007."""
    edges = {"inner_radius": inner_radius, "thinnest": thinnest, "wall_height": wall_height, "edge_factor": edge_factor}
    return even_pressure(wind_pressure=wind_pressure, suction=suction, **edges) * (inner_radius / thickness + 0.5)


def reduction(*, yield_stress, critical_external_pressure, inner_radius, thickness):
    """Reduction chi_th (1), of lambda = sqrt(f_y t / (p_cr r)). Source: en1993_1_6_2007, section 8.5, two public programs."""
    critical = critical_external_pressure * (inner_radius / thickness + 0.5)
    with np.errstate(divide="ignore"):
        return capacity(np.sqrt(yield_stress / critical))


def strength(*, yield_stress, critical_external_pressure, inner_radius, thickness, partial_buckling):
    """Hoop stress (Pa) at which a course buckles with the wall: chi_th f_y / gamma_M1. Source: en1993_1_6_2007, as above."""
    wall = {"inner_radius": inner_radius, "thickness": thickness}
    chi = reduction(yield_stress=yield_stress, critical_external_pressure=critical_external_pressure, **wall)
    return chi * yield_stress / partial_buckling


def behind(
    *, yield_stress, critical_external_pressure, wind_pressure, suction, inner_radius, thickness, thinnest, wall_height,
    edge_factor,
):  # fmt: skip
    """Numbers behind the check: omega and k_w of the thinnest course, even pressure, critical stress (Pa), lambda and chi.

    Source: en1993_1_6_2007, as above.
    """
    edges = {"inner_radius": inner_radius, "thinnest": thinnest, "wall_height": wall_height, "edge_factor": edge_factor}
    wall = {"critical_external_pressure": critical_external_pressure, "inner_radius": inner_radius, "thickness": thickness}
    critical = critical_external_pressure * (inner_radius / thickness + 0.5)
    return {
        "relative_length": wall_height / np.sqrt((inner_radius + thinnest / 2) * thinnest),
        "wind_factor": wind_factor(**edges),
        "even_pressure": even_pressure(wind_pressure=wind_pressure, suction=suction, **edges),
        "critical_stress": critical,
        "slenderness": np.sqrt(yield_stress / critical),
        "reduction": reduction(yield_stress=yield_stress, **wall),
    }


def _length(*, inner_radius, thickness, wall_height, edge_factor):
    """Relative length omega t / (C_theta r) (1)."""
    r = inner_radius + thickness / 2
    return wall_height / np.sqrt(r * thickness) * thickness / r / edge_factor


MEDIUM = Limit(
    measure=Measure("omega t/(C_theta r)", "1", _length),
    most=LONGEST,
    why="longer cylinders: one of two numbers of the rule has a single source",
)

ROW = SteelCheck(
    key="external_pressure",
    rank=1,
    title="external pressure",
    source="en1993_1_6_2007",
    locator="annex D, circumferential compression, second-hand",
    effect=hoop_compression,
    resistance=strength,
    behind=behind,
    limits=(MEDIUM, KNOWN_CLASSES),
    acts_in=frozenset({"wind", "suction"}),
    idle_with=frozenset({"solids"}),
    formula="(k_w q + q_s) r/t <= chi f_y/gamma_M1, lambda = sqrt(f_y t/(p_cr r)), alpha 0.65, lambda_0 0.4, beta 0.6, eta 1; "
    "one course: p_cr = 0.92 E C_theta (r/l) (t/r)^2.5, C_theta 1.5, 1.25, 1, 0.6 by the edges; courses: p_cr by Ritz' method "
    "of semi-membrane theory over the whole height; k_w = 0.46 (1 + 0.1 sqrt(C_theta r/(omega t))) between 0.65 and 1, of the "
    "thinnest course",
    validity="the empty wall, between its edges: no ring ends a bay here, and the gain of short walls is left out, both safe; "
    "where the solid stands it presses outward and nothing is checked; courses joined by unequal laps not covered; hoop "
    "strengths of 2025 not known; two public programs each, C_theta by theory, printed standard not seen",
)
