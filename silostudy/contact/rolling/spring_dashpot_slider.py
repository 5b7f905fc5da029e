"""Rolling resistance: a rotational spring behind a slider, and a dashpot where that sticks."""

from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import RollingLaw
from silostudy.contact.rolling import spring_slider
from silostudy.contact.vector import less, limited


@register_jitable
def law(stored, rolling, touch, elastic, c):
    """Stored and total moment (N m/m, of spheres N m) against the difference of the spins (rad/s).

    Ai et al. (2011), model C, without a dashpot where the slider slips; c = (rotational stiffness, rotational damping, rolling
    friction), the cap of the spring being friction times the reduced radius times the elastic normal force.
    """
    held, sticks = limited(less(stored, c[0] * touch.dt, rolling), c[2] * touch.radius * elastic)
    return held, less(held, c[1] * sticks, rolling)


def damping(touch, c):
    """Damping (N m s/m, of spheres N m s) of the dashpot."""
    return c[1] + 0.0 * touch.mass


ROW = RollingLaw(
    key="spring-dashpot-slider",
    rank=4,
    title="Rotational spring and dashpot behind a slider",
    source="ai_2011",
    locator="model C",
    law=law,
    stiffness=spring.stiffness,
    damping=damping,
    coefficients=(
        spring_slider.STIFFNESS,
        Coefficient(
            name="rolling_damping",
            unit="N s",
            fields=(("rolling_damping_N_s",),),
            in_space=("N m s", (("rolling_damping_N_m_s",),)),
            text="rotational dashpot",
            default=0.0,
            damping_power=1.0,
        ),
        spring_slider.FRICTION,
    ),
    stores=True,
    dissipates=("dashpot", "sliding"),
)
