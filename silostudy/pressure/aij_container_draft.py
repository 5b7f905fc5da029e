"""Draft of the container structures committee of the Architectural Institute of Japan: a dynamic factor on Janssen."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod


def overpressure_factor(z, *, diameter, cylinder_depth):
    """Dynamic factor C_d (1): 1 at the surface, linear to 2 at 1.5 D above the transition, then 2.

    Source: silo_handbook, section 4.2.2 (h); the line inferred from Table 4.2.5 column 5.
    A cylinder shallower than 1.5 D lies wholly in the lower zone.
    """
    full = cylinder_depth - 1.5 * diameter
    rise = np.clip(z / np.where(full > 0, full, 1.0), 0.0, 1.0)
    return 1.0 + np.where(full > 0, rise, 1.0)


ROW = PressureMethod(
    key="aij_container_draft",
    rank=120,
    title="AIJ container committee (draft)",
    source="silo_handbook",
    locator="section 4.2.2 (h)",
    phases={"discharge": {"wall_normal_pressure": janssen.times(overpressure_factor)}},
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p_h = C_d(z) times Janssen; C_d = 1 + z / (H - 1.5 D), at most 2",
    validity="cylinder only (the hopper's factors are not in the source); line inferred from one silo's column",
    colour="#0072B2",
    marker="<",
    number="5",
    drawn="handbook",
)
