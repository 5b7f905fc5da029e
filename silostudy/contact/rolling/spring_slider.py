"""Rolling resistance: a rotational spring behind a slider."""

from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import RollingLaw
from silostudy.contact.vector import less, limited


@register_jitable
def law(stored, rolling, touch, elastic, c):
    """Stored and total moment (N m/m, of spheres N m) against the difference of the spins (rad/s): one and the same.

    Iwashita & Oda (1998) without the dashpot; c = (rotational stiffness, rolling friction), the cap being friction times
    the reduced radius times the elastic normal force.
    """
    held, _ = limited(less(stored, c[0] * touch.dt, rolling), c[1] * touch.radius * elastic)
    return held, held


STIFFNESS = Coefficient(
    name="rolling_stiffness",
    unit="N",
    fields=(("rolling_stiffness_N",),),
    in_space=("N m", (("rolling_stiffness_N_m",),)),
    text="rotational stiffness",
    default=0.0,
    stiffness_power=1.0,
)
FRICTION = Coefficient(
    name="rolling_friction", unit="1", fields=(("rolling_friction",),), text="rolling friction coefficient", default=0.0
)
ROW = RollingLaw(
    key="spring-slider",
    rank=2,
    title="Rotational spring behind a slider",
    source="iwashita_oda_1998",
    locator="rolling resistance, without dashpot",
    law=law,
    stiffness=spring.stiffness,
    coefficients=(STIFFNESS, FRICTION),
    stores=True,
    dissipates=("sliding",),
)
