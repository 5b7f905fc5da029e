"""TY-124-56 (Soviet code for silos of granular goods): overload and dynamic factors on Janssen."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CELLS, PressureMethod

OVERLOAD = 1.3  # factor n


def overpressure_factor(z, *, outlet_depth):
    """Overload factor n = 1.3 times a (1): a = 1 in the upper third of the total depth, 2 below and on the boundary.

    Source: silo_handbook, section 4.2.2 (f); zones inferred from Table 4.2.5 column 2 (total depth to the outlet).
    """
    return OVERLOAD * np.where(z / outlet_depth < 1 / 3, 1.0, 2.0)


ROW = PressureMethod(
    key="ty124_1956",
    rank=90,
    title="TY-124-56",
    source="silo_handbook",
    locator="section 4.2.2 (f)",
    phases={"discharge": {"wall_normal_pressure": janssen.times(overpressure_factor)}},
    static=janssen.normal_pressure,
    plans=CELLS,
    formula="p_h = n a times Janssen; n = 1.3, a = 1 in the upper third of the depth to the outlet, 2 below",
    validity="zones inferred from one silo's column",
    colour="#999933",
    marker="P",
    number="2",
    drawn="handbook",
)
