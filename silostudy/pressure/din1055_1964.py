"""DIN 1055 (1964): Janssen with its own ratios for filling and discharge, relieved above the outlet in discharge.

Table 4.2.3 names mean particle sizes above 0.2 mm and below 0.06 mm.  Here a solid declared a powder takes the second
row and any other the first; what lies between the two sizes is the user's choice through the grain class.  The relieved
height is 1.2 D; for a plan other than a circle D stands for 4 R (a square's side, exactly).
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CELLS, USUAL_PHASES, PressureMethod
from silostudy.pressure.limits import Limit, Measure
from silostudy.tables.din1055_1964 import COEFFICIENTS

RELIEVED_HEIGHT = 1.2  # in diameters above the outlet


def lateral_pressure_ratio(powder, phase):
    """Lateral pressure ratio K (1) of a phase. Source: silo_handbook, Table 4.2.3."""
    return np.where(
        powder,
        COEFFICIENTS["powder"][f"{phase}_lateral_pressure_ratio"],
        COEFFICIENTS["grain"][f"{phase}_lateral_pressure_ratio"],
    )


def wall_friction(internal_friction_angle, powder, phase):
    """Wall friction coefficient (1) of a phase: tan of a share of phi. Source: silo_handbook, Table 4.2.3."""
    share = np.where(powder, COEFFICIENTS["powder"][f"{phase}_angle_factor"], COEFFICIENTS["grain"][f"{phase}_angle_factor"])
    return np.tan(share * internal_friction_angle)


def _state(janssen_quantity, phase):
    def quantity(z, *, unit_weight, hydraulic_radius, internal_friction_angle, powder):
        return janssen_quantity(
            z,
            unit_weight=unit_weight,
            hydraulic_radius=hydraulic_radius,
            wall_friction=wall_friction(internal_friction_angle, powder, phase),
            lateral_pressure_ratio=lateral_pressure_ratio(powder, phase),
        )

    quantity.__doc__ = f"{janssen_quantity.__doc__.splitlines()[0]} Source: silo_handbook, section 4.2.2 (e)."
    return quantity


FILLING = {name: _state(function, "filling") for name, function in janssen.STATE.items()}
UNRELIEVED = {name: _state(function, "discharge") for name, function in janssen.STATE.items()}


def relief_depth(hydraulic_radius, outlet_depth):
    """Depth (m) at which the relief above the outlet begins."""
    return np.maximum(outlet_depth - RELIEVED_HEIGHT * 4 * hydraulic_radius, 0.0)


def discharge_pressure(z, *, unit_weight, hydraulic_radius, internal_friction_angle, powder, outlet_depth):
    """Horizontal wall pressure (Pa) in discharge: straight from the relief depth to the filling pressure at the outlet.

    Source: silo_handbook, section 4.2.2 (e) and Fig. 4.2.5; 1.2 D inferred from Table 4.2.5 column 1.
    """
    own = {
        "unit_weight": unit_weight,
        "hydraulic_radius": hydraulic_radius,
        "internal_friction_angle": internal_friction_angle,
        "powder": powder,
    }
    start = relief_depth(hydraulic_radius, outlet_depth)
    full, filling = UNRELIEVED["wall_normal_pressure"], FILLING["wall_normal_pressure"]
    at_start, at_outlet = full(start, **own), filling(outlet_depth, **own)
    relieved = at_start + (at_outlet - at_start) * (z - start) / (outlet_depth - start)
    return np.where(z <= start, full(z, **own), relieved)


def _own(function, phase):
    def parameter(*, internal_friction_angle, powder):
        return function(internal_friction_angle, powder, phase)

    parameter.__doc__ = function.__doc__
    return parameter


USED = {
    phase: janssen.for_state(
        {
            "lateral_pressure_ratio": _own(lambda phi, powder, state: lateral_pressure_ratio(powder, state), phase),
            "wall_friction": _own(wall_friction, phase),
            "wall_friction_uncapped": _own(wall_friction, phase),
        },
    )
    for phase in USUAL_PHASES
}
ABOVE_RELIEF = Limit(
    measure=Measure(
        "z - (total depth - 4.8 R)",
        "m",
        lambda z, *, hydraulic_radius, outlet_depth: z - relief_depth(hydraulic_radius, outlet_depth),
    ),
    most=0.0,
    phases=("discharge",),
    quantities=tuple(name for name in janssen.STATE if name != "wall_normal_pressure"),
    why="in the relieved part the source gives the wall pressure only",
)
ROW = PressureMethod(
    key="din1055_1964",
    rank=80,
    title="DIN 1055 (1964)",
    source="silo_handbook",
    locator="section 4.2.2 (e)",
    phases={
        "filling": FILLING,
        "discharge": {
            "wall_normal_pressure": discharge_pressure,
            **{name: function for name, function in UNRELIEVED.items() if name != "wall_normal_pressure"},
        },
    },
    static=FILLING["wall_normal_pressure"],
    plans=CELLS,
    formula="Janssen with K = 0.5, mu = tan(0.75 phi) in filling and K = 1, mu = tan(0.6 phi) in discharge (powders: "
    "mu = tan phi in both); in discharge straight from 1.2 D above the outlet to the filling pressure at the outlet",
    limits=(ABOVE_RELIEF,),
    used=USED,
    validity="grain class decides between mean particle sizes above 0.2 mm and below 0.06 mm; between them the source is "
    "silent",
    colour="#000080",
    marker="h",
    number="1",
    drawn="handbook",
    misprinted_table=True,
    equilibrium=("filling", "discharge"),
)
