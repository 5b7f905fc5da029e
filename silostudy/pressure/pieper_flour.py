"""Pieper, Martens and Nothdurft (1975): wheat flour, with unit weights by silo size and friction by wall roughness.

Janssen with lambda 0.31 in filling and 0.47 in discharge for flour (angles of repose must not be used: flour stands in
steps of 2 m, the internal friction angle is 20 degrees), for other contents 1 - sin(phi) and 1.5 (1 - sin(phi)); wall
friction tan(C phi) in filling and tan(0.8 C phi) in discharge.  C comes from the wall kind (roughness_1 ... roughness_5,
or those polished by use); for shell buckling, where more wall friction is the unsafe side, C is 0.05 larger.
The pressures are averages over the full width of the wall and a height of 0.7 widths, not local peaks.
Model law: similar prismatic cells have pressures and depths in proportion to their hydraulic radii.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking, first_line
from silostudy.pressure.family import CELLS, USUAL_PHASES, PressureMethod, Quantities

FLOUR_RATIO = {"filling": 0.31, "discharge": 0.47}
GENERAL_RATIO = {"filling": 1.0, "discharge": 1.5}  # times 1 - sin(phi)
ANGLE_SHARE = {"filling": 1.0, "discharge": 0.8}
BUCKLING = 0.05  # added to C
GIVEN = ("unit_weight_lower", "unit_weight", "hydraulic_radius", "wall_friction", "internal_friction_angle", "powder")


def unit_weight_large(*, unit_weight_lower, unit_weight):
    """Unit weight (N m-3) in a large silo: (2 max + min)/3. Source: silo_handbook, section 4.5.1 (2)."""
    return (2 * unit_weight + unit_weight_lower) / 3


def unit_weight_small(*, unit_weight_lower, unit_weight):
    """Unit weight (N m-3) in a small silo, little compacted: (max + 2 min)/3. Source: silo_handbook, section 4.5.1 (2)."""
    return (unit_weight + 2 * unit_weight_lower) / 3


def lateral_ratio(phase, *, internal_friction_angle, powder):
    """Lateral pressure ratio lambda (1) of a phase. Source: silo_handbook, section 4.5.1 (3)."""
    return np.where(powder == 1, FLOUR_RATIO[phase], GENERAL_RATIO[phase] * (1 - np.sin(internal_friction_angle)))


def wall_friction_of(phase, extra, *, wall_friction, internal_friction_angle):
    """Wall friction (1) of a phase: tan(C phi), in discharge tan(0.8 C phi), C larger by `extra` and at most 1.

    Source: silo_handbook, section 4.5.1 (4).
    """
    angle = np.minimum(np.arctan(wall_friction) + extra * internal_friction_angle, internal_friction_angle)
    return np.tan(ANGLE_SHARE[phase] * angle)


def model_law(pressure, depth, *, hydraulic_radius, other_hydraulic_radius):
    """Pressure (Pa) and depth (m) in a similar prismatic cell of another hydraulic radius.

    Source: silo_handbook, section 4.5.1 (5).
    """
    scale = other_hydraulic_radius / hydraulic_radius
    return pressure * scale, depth * scale


def averaging_height(*, diameter):
    """Height (m) of wall over which the pressure is an average: 0.7 widths. Source: silo_handbook, section 4.5.1 (6)."""
    return 0.7 * diameter


def _state(quantity, phase, weight, extra):
    def function(z, **given):
        angle = {"internal_friction_angle": given["internal_friction_angle"]}
        return janssen.STATE[quantity](
            z,
            unit_weight=weight(unit_weight_lower=given["unit_weight_lower"], unit_weight=given["unit_weight"]),
            hydraulic_radius=given["hydraulic_radius"],
            wall_friction=wall_friction_of(phase, extra, wall_friction=given["wall_friction"], **angle),
            lateral_pressure_ratio=lateral_ratio(phase, powder=given["powder"], **angle),
        )

    return asking(function, GIVEN, f"{first_line(janssen.STATE[quantity])} Source: silo_handbook, section 4.5.1.")


def _used(phase, weight, extra):
    """Values that a phase reckons with in place of those handed over."""

    def friction(*, wall_friction, internal_friction_angle):
        return wall_friction_of(phase, extra, wall_friction=wall_friction, internal_friction_angle=internal_friction_angle)

    def uncapped(*, wall_friction_uncapped, internal_friction_angle):
        return np.tan(ANGLE_SHARE[phase] * (np.arctan(wall_friction_uncapped) + extra * internal_friction_angle))

    def ratio(*, internal_friction_angle, powder):
        return lateral_ratio(phase, internal_friction_angle=internal_friction_angle, powder=powder)

    quantities: Quantities = {"wall_friction": friction, "wall_friction_uncapped": uncapped, "lateral_pressure_ratio": ratio}
    return janssen.for_state({**quantities, "unit_weight": weight})


def _row(key, title, weight, extra, colour, marker) -> PressureMethod:
    def phase(name):
        return {quantity: _state(quantity, name, weight, extra) for quantity in janssen.STATE}

    filling = phase("filling")
    totals = {"design_unit_weight": weight, "averaging_height": averaging_height}
    return PressureMethod(
        key=key,
        rank=150,
        title=title,
        source="silo_handbook",
        locator="section 4.5.1",
        phases={"filling": filling, "discharge": phase("discharge")},
        totals={"filling": totals, "discharge": totals},
        static=filling["wall_normal_pressure"],
        used={name: _used(name, weight, extra) for name in USUAL_PHASES},
        varies=frozenset({"wall_friction"}) if extra else frozenset(),
        plans=CELLS,
        table_key="pieper_flour",
        not_computed=(
            "rapid filling, air discharge aids, homogenising by air, nose and beam outlets, internal anchors: known to the "
            "source, whose abstract gives no formulas; scale from measurements with the model law, or give the overpressure "
            "of the plant's maker as a load of its own",
        ),
        formula="Janssen with gamma (2 max + min)/3 in a large silo, (max + 2 min)/3 in a small one; lambda 0.31 and 0.47 for "
        "flour; mu = tan(C phi) in filling, tan(0.8 C phi) in discharge, C by roughness",
        validity="needs a lower and an upper unit weight; the flour's lambda serves every powder (not soya flour: the source "
        "warns); averages over 0.7 widths of height, not local peaks; the row for buckling adds its 0.05 itself, and "
        "wall_friction_end: upper does not move it; the formulas are the source's but no published numbers were at "
        "hand: checked in 50-digit arithmetic",
        colour=colour,
        marker=marker,
        equilibrium=("filling", "discharge"),
    )


ROWS = (
    _row("pieper_flour", "Pieper, flour, large silo", unit_weight_large, 0.0, "#8C510A", "H"),
    _row("pieper_flour_small", "Pieper, flour, small silo", unit_weight_small, 0.0, "#BF812D", "$s$"),
    _row("pieper_flour_buckling", "Pieper, flour, for buckling", unit_weight_large, BUCKLING, "#DFC27D", "$b$"),
)
