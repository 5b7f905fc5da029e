"""Linear spring and a dashpot on the speed that its own force leaves."""

from math import sqrt

from numba.extending import register_jitable

from silostudy.contact import restitution, spring
from silostudy.contact.family import NormalLaw
from silostudy.contact.normal import spring_dashpot
from silostudy.contact.sources import KIYAMA


@register_jitable
def law(overlap, closing, touch, c):
    """Elastic and total normal force (N/m) with the dashpot on the speed that its own force leaves; it never pulls.

    From eqs. (6)-(9) of Kiyama & Fujimura (1983) with closing' = closing - dt dashpot / mass put into (6b).  The spring is
    left out of it: else a contact at rest would be softer by 1 + dt damping / mass.
    """
    elastic = c[0] * overlap
    damping = c[1] + c[2] * sqrt(touch.mass)
    total = elastic + damping / (1.0 + damping * touch.dt / touch.mass) * closing
    return elastic, (total if total > 0.0 else 0.0)


ROW = NormalLaw(
    key="spring-dashpot-implicit",
    rank=3,
    title="Linear spring and semi-implicit dashpot, no tension",
    source=KIYAMA,
    locator="eqs. (6)-(9), dashpot at the new speed",
    law=law,
    energy=spring.energy,
    stiffness=spring.stiffness,
    damping=spring.implicit_damping,
    coefficients=spring.NORMAL,
    linear=True,
    damped=restitution.ratio_where_cut,
    implicit=True,
    dissipates=("dashpot",),
    explicit_key=spring_dashpot.ROW.key,
)
