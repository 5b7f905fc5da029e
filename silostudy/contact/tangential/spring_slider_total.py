"""A spring and dashpot behind a slider that caps their sum."""

from math import sqrt

from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.family import TangentialLaw
from silostudy.contact.tangential import spring_slider
from silostudy.contact.vector import less, limited, scaled


@register_jitable
def law(stored, sliding, touch, elastic, normal, c):
    """Stored and total tangential force (N/m); spring and dashpot together stay below friction times normal force.

    Cundall & Strack (1979), slip check of the law FORD, where a dashpot that pulls leaves nothing to rub;
    c = (stiffness, damping, damping by root of mass, friction).
    """
    dashpot = scaled(-(c[1] + c[2] * sqrt(touch.mass)), sliding)
    total, _ = limited(less(less(stored, c[0] * touch.dt, sliding), -1.0, dashpot), c[3] * spring.pressing(normal))
    return less(total, 1.0, dashpot), total


ROW = TangentialLaw(
    key="spring-slider-total",
    rank=3,
    title="Spring and dashpot, their sum capped",
    source="cundall_strack_1979",
    locator="force-displacement law",
    law=law,
    stiffness=spring.stiffness,
    damping=spring.damping,
    coefficients=spring.SLIDER,
    stores=True,
    dissipates=("dashpot", "sliding"),
    measured=True,  # spring-slider drops the dashpot at slip: a force jumps, errors fall with the step more slowly or hardly
    explicit_key=spring_slider.ROW.key,
)
