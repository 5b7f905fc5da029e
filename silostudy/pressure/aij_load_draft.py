"""Draft load standard of the Architectural Institute of Japan: factors on Janssen by thirds of the cylinder."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CELLS, PressureMethod


def overpressure_factor(z, *, cylinder_depth):
    """Overload times correction factor (1): 1.0, 1.3, 2.6 in the thirds; a boundary belongs to the zone below it.

    Source: silo_handbook, section 4.2.2 (i); zones and factors inferred from Table 4.2.5 column 4.
    """
    third = z / cylinder_depth
    return np.select([third < 1 / 3, third < 2 / 3], [1.0, 1.3], 2.6)


ROW = PressureMethod(
    key="aij_load_draft",
    rank=110,
    title="AIJ load standard (draft)",
    source="silo_handbook",
    locator="section 4.2.2 (i)",
    phases={"discharge": {"wall_normal_pressure": janssen.times(overpressure_factor)}},
    static=janssen.normal_pressure,
    plans=CELLS,
    formula="p_h = n a times Janssen: 1.0, 1.3, 2.6 in the upper, middle and lower third of the cylinder",
    validity="zones and factors inferred from one silo's column; the draft's own limits are not in the source",
    colour="#56B4E9",
    marker="v",
    number="4",
    drawn="handbook",
)
