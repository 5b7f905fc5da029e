"""A spring and dashpot behind a slider that caps the elastic part."""

from math import sqrt

from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.family import TangentialLaw
from silostudy.contact.sources import KIYAMA
from silostudy.contact.vector import less, limited


@register_jitable
def law(stored, sliding, touch, elastic, normal, c):
    """Stored and total tangential force (N/m); the slider caps the elastic part and then drops the dashpot.

    Kiyama & Fujimura (1983), eqs. (10)-(14); c = (stiffness, damping, damping by root of mass, friction).
    """
    held, sticks = limited(less(stored, c[0] * touch.dt, sliding), c[3] * elastic)
    return held, less(held, (c[1] + c[2] * sqrt(touch.mass)) * sticks, sliding)


ROW = TangentialLaw(
    key="spring-slider",
    rank=2,
    title="Spring and dashpot, the elastic part capped",
    source=KIYAMA,
    locator="eqs. (10)-(14)",
    law=law,
    stiffness=spring.stiffness,
    damping=spring.damping,
    coefficients=spring.SLIDER,
    stores=True,
    dissipates=("dashpot", "sliding"),
)
