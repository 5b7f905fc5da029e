"""AS 3774-1996, a powder that is filled in so fast that its air has no time to leave: nearly a fluid down to some depth."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.as3774_1996 import wall
from silostudy.pressure.calls import asking
from silostudy.pressure.family import CIRCULAR, SLOT, PressureMethod
from silostudy.pressure.limits import Limit, Measure

FLUID = 0.6  # of the unit weight
GIVEN = (*wall.GIVEN, *wall.SOFT, "fluid_depth")


def rapid_pressure(z, given):
    """Wall pressure (Pa) at depth z (m): the lesser of 0.6 gamma z and c_F v_F gamma, never below the normal filling pressure.

    Source: as3774_1996, second-hand (one account).
    """
    fluid = given["unit_weight"] * np.minimum(FLUID * z, given["fluid_depth"])
    return np.maximum(fluid, wall.normal_pressure(z, given))


ROW = PressureMethod(
    key="as3774_1996_rapid_filling",
    rank=171,
    title="AS 3774-1996, rapid filling (one source)",
    source="as3774_1996",
    locator="second-hand account (printed standard not seen)",
    phases={
        "filling": {
            "wall_normal_pressure": asking(
                lambda z, **given: rapid_pressure(z, given),
                GIVEN,
                "Wall pressure (Pa) in rapid filling at depth z (m). Source: as3774_1996, second-hand (one account).",
            )
        }
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR | SLOT,
    limits=(
        Limit(measure=Measure("c_F v_F", "m", lambda *, fluid_depth: fluid_depth), above=0.0, why="no rapid filling is given"),
    ),
    used={"filling": {"wall_normal_pressure": {"lateral_pressure_ratio": wall.lateral_ratio}}},
    formula="max(p_ni, min(0.6 gamma z, c_F v_F gamma)), c_F in h by solid, v_F the rise of the surface in m/h",
    validity="a load case of its own, without a factor of flow; no published numbers: checked by hand",
    colour="#01665E",
    marker="$r$",
    on_request=True,
)
