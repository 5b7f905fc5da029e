"""ACI 313-77 (concrete silos): overpressure factors on Janssen by zones, known here through one silo's numbers only."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod
from silostudy.pressure.limits import Limit, Measure
from silostudy.pressure.one_silo import PROPORTIONS

ZONE_ENDS = (1.45, 1.55, 1.65, 1.75, 1.75)  # inferred from Table 4.2.5 column 3 (H/D = 3.6)


def overpressure_factor(z, *, internal_friction_angle, diameter, cylinder_depth):
    """Overpressure factor C_d (1): 1.45 at H1 = D tan(phi), then linear over four equal zones to the transition.

    Source: silo_handbook, section 4.2.2 (g); zones and factors inferred from Table 4.2.5 column 3.
    """
    top = diameter * np.tan(internal_friction_angle)
    zone = 4 * (z - top) / (cylinder_depth - top)
    return np.interp(zone, range(5), ZONE_ENDS)


BELOW_THE_TOP_ZONE = Limit(
    measure=Measure(
        "z/(D tan phi)", "1", lambda z, *, diameter, internal_friction_angle: z / (diameter * np.tan(internal_friction_angle))
    ),
    least=1.0,
    why="the source shows no other rows of the code's table",
)


ROW = PressureMethod(
    key="aci313_1977",
    rank=100,
    title="ACI 313-77",
    source="silo_handbook",
    locator="section 4.2.2 (g)",
    phases={"discharge": {"wall_normal_pressure": janssen.times(overpressure_factor)}},
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    formula="p_h = C_d(z) times Janssen; C_d 1.45 at H1 = D tan phi, 1.55, 1.65, 1.75, 1.75 at the ends of four equal zones",
    limits=(PROPORTIONS, BELOW_THE_TOP_ZONE),
    validity="zones and factors inferred from one silo's column",
    colour="#009E73",
    marker="^",
    number="3",
    drawn="handbook",
)
