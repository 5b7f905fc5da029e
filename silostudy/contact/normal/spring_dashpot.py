"""Linear spring and dashpot that never pull."""

from math import sqrt

from numba.extending import register_jitable

from silostudy.contact import restitution, spring
from silostudy.contact.family import NormalLaw
from silostudy.contact.sources import KIYAMA


@register_jitable
def law(overlap, closing, touch, c):
    """Elastic and total normal force (N/m) of a spring and dashpot that never pull.

    Kiyama & Fujimura (1983), eqs. (6)-(9), with the sum of both held at zero or more as their text asks.
    overlap (m), closing speed (m/s), c = (stiffness, damping, damping by root of mass).
    """
    elastic = c[0] * overlap
    total = elastic + (c[1] + c[2] * sqrt(touch.mass)) * closing
    return elastic, (total if total > 0.0 else 0.0)


ROW = NormalLaw(
    key="spring-dashpot",
    rank=1,
    title="Linear spring and dashpot, no tension",
    source=KIYAMA,
    locator="eqs. (6)-(9)",
    law=law,
    energy=spring.energy,
    stiffness=spring.stiffness,
    damping=spring.damping,
    coefficients=spring.NORMAL,
    linear=True,
    damped=restitution.ratio_where_cut,
    dissipates=("dashpot",),
    measured=True,
)
