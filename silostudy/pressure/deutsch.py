"""Deutsch and co-workers: a design chart of tests on models, known here through one silo's numbers only."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod
from silostudy.pressure.one_silo import FRICTION, PROPORTIONS
from silostudy.tables.charts import chart

# z / D, and p / (gamma D) there
DEPTHS, RATIOS = chart("deutsch")


def design_pressure(z, *, unit_weight, diameter):
    """Horizontal wall pressure (Pa) in discharge at depth z (m): nearly hydrostatic, then levelling off.

    Source: silo_handbook, section 4.2.2 (j) and Table 4.2.5 column 11.
    """
    return unit_weight * diameter * np.interp(z / diameter, DEPTHS, RATIOS)


ROW = PressureMethod(
    key="deutsch",
    rank=140,
    title="Deutsch",
    source="silo_handbook",
    locator="section 4.2.2 (j)",
    phases={"discharge": {"wall_normal_pressure": design_pressure}},
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p_h = 0.9592 gamma z down to 1.5 D, then a chart up to 1.972 gamma D from 2.7 D downward",
    limits=(PROPORTIONS, *FRICTION),
    validity="only the silo of the chart; masked elsewhere",
    colour="#882255",
    marker="*",
    number="11",
    drawn="handbook",
)
