"""Linear spring and dashpot, of which the dashpot may pull."""

from math import sqrt

from numba.extending import register_jitable

from silostudy.contact import restitution, spring
from silostudy.contact.family import NormalLaw
from silostudy.contact.normal import spring_dashpot
from silostudy.contact.sources import KIYAMA


@register_jitable
def law(overlap, closing, touch, c):
    """Elastic and total normal force (N/m) of a spring and dashpot; the dashpot may pull until the discs part.

    Kiyama & Fujimura (1983), eqs. (6)-(9) by the letter: only a lost overlap cuts the force.
    """
    elastic = c[0] * overlap
    return elastic, elastic + (c[1] + c[2] * sqrt(touch.mass)) * closing


ROW = NormalLaw(
    key="spring-dashpot-tension",
    rank=2,
    title="Linear spring and dashpot, the dashpot may pull",
    source=KIYAMA,
    locator="eqs. (6)-(9) without the cut of the sum",
    law=law,
    energy=spring.energy,
    stiffness=spring.stiffness,
    damping=spring.damping,
    coefficients=spring.NORMAL,
    linear=True,
    damped=restitution.ratio_where_pulled,
    dissipates=("dashpot",),
    explicit_key=spring_dashpot.ROW.key,
)
