"""AS 3774-1996, a wall that cools: it shrinks on the stored solid, which presses back; added to the filling pressure.

The form is that of a thin ring on an elastic core, and so holds whatever code sets its factor.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.as3774_1996 import wall
from silostudy.pressure.calls import asking
from silostudy.pressure.family import CIRCULAR, PressureMethod
from silostudy.pressure.limits import Limit, Measure

FACTOR = 10.0  # C_T
POISSON_RATIO = 0.3  # of the solid
GIVEN = (*wall.GIVEN, *wall.SOFT, "cooling_strain")


def ring_pressure(strain, *, radius, wall_flexibility, solid_modulus):
    """Pressure (Pa) of a thin ring that would shrink by a strain on an elastic core: strain/[r/(E_w t) + (1 - nu)/E_s].

    Source: equilibrium and compatibility of ring and core; as3774_1996 and en1991_4_2006 share the form (second-hand).
    """
    return strain / (radius * wall_flexibility + (1 - POISSON_RATIO) / solid_modulus)


def cooling_pressure(z, given):
    """Pressure (Pa) added by the cooling at depth z (m): C_T = 10 times the ring's, E_s = chi p_vi.

    Source: as3774_1996, second-hand (one account).
    """
    modulus = given["solid_modulus_factor"] * wall.vertical_pressure(z, given)
    soft = np.where(modulus > 0, modulus, 1.0)
    own = {"radius": given["diameter"] / 2, "wall_flexibility": given["wall_flexibility"], "solid_modulus": soft}
    return np.where(modulus > 0, FACTOR * ring_pressure(given["cooling_strain"], **own), 0.0)


ROW = PressureMethod(
    key="as3774_1996_cooling",
    rank=171,
    title="AS 3774-1996, cooling of the wall (one source)",
    source="as3774_1996",
    locator="second-hand account (printed standard not seen)",
    phases={
        "filling": {
            "wall_normal_pressure": asking(
                lambda z, **given: wall.normal_pressure(z, given) + cooling_pressure(z, given),
                GIVEN,
                "Wall pressure (Pa) after filling and cooling at depth z (m). Source: as3774_1996, second-hand (one account).",
            )
        }
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    limits=(
        Limit(
            measure=Measure("strain of the cooling", "1", lambda *, cooling_strain: cooling_strain),
            above=0.0,
            why="no cooling is given",
        ),
        Limit(
            measure=Measure("chi", "1", lambda *, solid_modulus_factor: solid_modulus_factor),
            above=0.0,
            why="the wall's stiffness and the solid's are not given: flexible_wall",
        ),
    ),
    used={"filling": {"wall_normal_pressure": {"lateral_pressure_ratio": wall.lateral_ratio}}},
    formula="p_ni + C_T alpha dT E_w/[r/t + (1 - nu) E_w/E_s], C_T = 10, nu = 0.3, E_s = chi p_vi",
    validity="a load case of its own; a finite-element study finds more than such a rule near the surface for drops above "
    "20 K; no published numbers: checked at its two limits, a rigid wall and a rigid solid",
    colour="#35978F",
    marker="$c$",
    on_request=True,
)
