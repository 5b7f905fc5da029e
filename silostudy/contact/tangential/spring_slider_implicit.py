"""A spring and a dashpot on the speed that its own force leaves, behind a slider that caps the elastic part."""

from functools import partial
from math import sqrt

from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.family import TangentialLaw
from silostudy.contact.sources import KIYAMA
from silostudy.contact.tangential import spring_slider
from silostudy.contact.vector import less, limited


@register_jitable
def law(stored, sliding, touch, elastic, normal, c):
    """Stored and total tangential force (N/m) as spring-slider's, the dashpot on the speed that its own force leaves.

    Kiyama & Fujimura (1983), eqs. (10)-(14), with sliding' = sliding + 3 dt dashpot / mass in (11): a tangential force on
    a disc's rim moves the rim by its translation, and twice as much by its rotation (inertia m r^2 / 2).
    """
    damping = c[1] + c[2] * sqrt(touch.mass)
    softer = damping / (1.0 + 3.0 * damping * touch.dt / touch.mass)
    held, sticks = limited(less(stored, c[0] * touch.dt, sliding), c[3] * elastic)
    return held, less(held, softer * sticks, sliding)


ROW = TangentialLaw(
    key="spring-slider-implicit",
    rank=4,
    title="Spring and semi-implicit dashpot, the elastic part capped",
    source=KIYAMA,
    locator="eqs. (10)-(14), dashpot at the new speed",
    law=law,
    stiffness=spring.stiffness,
    damping=partial(spring.implicit_damping, moved=3.0),
    coefficients=spring.SLIDER,
    stores=True,
    implicit=True,
    grains=("discs",),  # its rim moves as that of a disc
    dissipates=("dashpot", "sliding"),
    explicit_key=spring_slider.ROW.key,
)
