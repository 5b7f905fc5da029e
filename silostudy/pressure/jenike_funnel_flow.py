"""Jenike, Johanson and Carson (1973): funnel flow, a chart of overpressure factors on Janssen.

The source gives no closed form.  Its numbers for one silo are carried as a chart over z/D (tables/charts.csv); anything
else is masked.  From z = 2.9 D to the transition the printed pressure runs straight.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod
from silostudy.pressure.limits import RELATIVE_DEPTH, Limit
from silostudy.pressure.one_silo import FRICTION, PROPORTIONS
from silostudy.tables.charts import chart

# z / D, and factor there
DEPTHS, FACTORS = chart("jenike_funnel_flow")
STRAIGHT_FROM = DEPTHS[-2]


def chart_factor(relative_depth):
    """Overpressure factor on Janssen (1) read off the chart at z/D.

    Source: silo_handbook, Table 4.2.5 column 9.
    """
    return np.interp(relative_depth, DEPTHS[:-1], FACTORS[:-1])


def envelope_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, lateral_pressure_ratio, diameter):
    """Horizontal wall pressure (Pa) in discharge at depth z (m).

    Source: silo_handbook, section 4.2.2 (d) and Table 4.2.5 column 9.
    """

    def static(depth):
        return janssen.normal_pressure(
            depth,
            unit_weight=unit_weight,
            hydraulic_radius=hydraulic_radius,
            wall_friction=wall_friction,
            lateral_pressure_ratio=lateral_pressure_ratio,
        )

    start, end = STRAIGHT_FROM * diameter, DEPTHS[-1] * diameter
    at_start, at_end = FACTORS[-2] * static(start), FACTORS[-1] * static(end)
    straight = at_start + (at_end - at_start) * (z - start) / (end - start)
    return np.where(z <= start, chart_factor(z / diameter) * static(z), straight)


ROW = PressureMethod(
    key="jenike_funnel_flow",
    rank=50,
    title="Jenike, funnel flow",
    source="silo_handbook",
    locator="section 4.2.2 (d)",
    phases={"filling": janssen.STATE, "discharge": {"wall_normal_pressure": envelope_pressure}},
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p_h = C(z/D) times Janssen, C read off a chart (2.07 at 0.7 D, 2.73 at 2.1 D, 2.06 at 2.9 D), then "
    "straight to 1.29 times Janssen at 3.6 D",
    limits=(
        PROPORTIONS,
        *FRICTION,
        Limit(measure=RELATIVE_DEPTH, least=float(DEPTHS[0]), phases=("discharge",), why="the chart's first point"),
    ),
    validity="discharge: only the silo of the chart; masked elsewhere",
    colour="#CC79A7",
    marker="d",
    number="9",
    drawn="handbook",
    equilibrium=("filling",),
)
