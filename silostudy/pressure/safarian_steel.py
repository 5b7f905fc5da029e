"""Safarian's overpressure factors for steel silos: two zones on Janssen."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod


def overpressure_factor(z, *, cylinder_depth):
    """Overpressure factor (1): 1.5 in the upper third of the cylinder, 1.95 below and on the boundary.

    Source: silo_handbook, section 4.2.2 (g); zones and factors inferred from Table 4.2.5 column 10.
    """
    return np.where(z / cylinder_depth < 1 / 3, 1.5, 1.95)


ROW = PressureMethod(
    key="safarian_steel",
    rank=130,
    title="Safarian, steel silos",
    source="silo_handbook",
    locator="section 4.2.2 (g)",
    phases={"discharge": {"wall_normal_pressure": janssen.times(overpressure_factor)}},
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p_h = 1.5 times Janssen in the upper third of the cylinder, 1.95 times below",
    validity="steel silos; zones and factors inferred from one silo's column",
    colour="#44AA99",
    marker=">",
    number="10",
    drawn="handbook",
)
