"""Reimbert: a hyperbola in place of Janssen's exponential, with the top cone's surcharge.

The source gives p_max and c for the circular plan only; the other plans are masked, since no copy of their formulas
could be checked.  Depth z counts from the equivalent flat surface, the formula's y from the highest contact of solid
and wall: y = z - h/3, h the height of the top cone.  Both c and p_max grow without bound as mu -> 0; the forms below
divide by R - mu k h/3 instead and stay exact there.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod
from silostudy.pressure.limits import Limit, Measure


def active_ratio(internal_friction_angle):
    """Rankine's active ratio k (1): tan^2(45 deg - phi/2)."""
    return (np.cos(internal_friction_angle) / (1 + np.sin(internal_friction_angle))) ** 2  # keeps its digits near 90 degrees


def relative_depth(y, *, hydraulic_radius, wall_friction, internal_friction_angle, top_cone_height):
    """Relative depth y / c (1) with c = D / (4 mu k) - h/3."""
    friction = wall_friction * active_ratio(internal_friction_angle)
    return friction * y / (hydraulic_radius - friction * top_cone_height / 3)


def _cone_over_constant(*, hydraulic_radius, wall_friction, internal_friction_angle, top_cone_height):
    """Ratio (h/3) / (R / (mu k)) (1)."""
    return wall_friction * active_ratio(internal_friction_angle) * top_cone_height / 3 / hydraulic_radius


def normal_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle, top_cone_height):
    """Horizontal wall pressure (Pa) at depth z (m).

    Source: silo_handbook, section 4.2.2 (b): p_max (1 - (1 + y/c)^-2), p_max = gamma D / (4 mu).
    """
    y = z - top_cone_height / 3
    u = relative_depth(
        y,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        internal_friction_angle=internal_friction_angle,
        top_cone_height=top_cone_height,
    )
    ratio = active_ratio(internal_friction_angle)
    stiffness = hydraulic_radius / (hydraulic_radius - wall_friction * ratio * top_cone_height / 3)
    return unit_weight * ratio * stiffness * y * (2 + u) / (1 + u) ** 2


def friction_traction(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle, top_cone_height):
    """Wall friction traction (Pa) at depth z (m): mu times the wall pressure.

    Source: silo_handbook, section 4.2.2 (b); with it p_v and p_h are in vertical equilibrium.
    """
    return wall_friction * normal_pressure(
        z,
        unit_weight=unit_weight,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        internal_friction_angle=internal_friction_angle,
        top_cone_height=top_cone_height,
    )


def vertical_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle, top_cone_height):
    """Mean vertical pressure in the solid (Pa) at depth z (m).

    Source: silo_handbook, section 4.2.2 (b): gamma (y / (1 + y/c) + h/3).
    """
    y = z - top_cone_height / 3
    u = relative_depth(
        y,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        internal_friction_angle=internal_friction_angle,
        top_cone_height=top_cone_height,
    )
    return unit_weight * (y / (1 + u) + top_cone_height / 3)


def axial_wall_force(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle, top_cone_height):
    """Axial wall force per metre of perimeter (N/m, compression positive) at depth z (m).

    Source: the friction traction of silo_handbook, section 4.2.2 (b), integrated from the wall's top to z.
    """
    y = z - top_cone_height / 3
    u = relative_depth(
        y,
        hydraulic_radius=hydraulic_radius,
        wall_friction=wall_friction,
        internal_friction_angle=internal_friction_angle,
        top_cone_height=top_cone_height,
    )
    return unit_weight * hydraulic_radius * y * u / (1 + u)


ROW = PressureMethod(
    key="reimbert",
    rank=20,
    title="Reimbert",
    source="silo_handbook",
    locator="section 4.2.2 (b)",
    phases={
        "filling": {
            "wall_normal_pressure": normal_pressure,
            "wall_friction_traction": friction_traction,
            "vertical_pressure": vertical_pressure,
            "axial_wall_force": axial_wall_force,
        }
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p_h = p_max (1 - (1 + y/c)^-2), p_max = gamma D / (4 mu), c = D / (4 mu tan^2(45 - phi/2)) - h/3, "
    "p_v = gamma (y / (1 + y/c) + h/3), y = z - h/3",
    limits=(Limit(measure=Measure("mu k h/(3 R)", "1", _cone_over_constant), below=1.0, why="a heap so high that c vanishes"),),
    used={"filling": janssen.for_state({"lateral_pressure_ratio": active_ratio})},
    validity="circular plan only (the source gives no others); no published numbers: checked against the formula in "
    "50-digit arithmetic and by vertical equilibrium",
    colour="#7f7f7f",
    marker="x",
    drawn="handbook",
    equilibrium=("filling",),
)
