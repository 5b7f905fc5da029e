"""Rolling resistance of one moment against any rolling, however slow."""

from numba.extending import register_jitable

from silostudy.contact.family import RollingLaw
from silostudy.contact.rolling import spring_slider
from silostudy.contact.vector import direction, scaled


@register_jitable
def law(stored, rolling, touch, elastic, c):
    """Stored (nothing) and total moment (N m/m, of spheres N m) against the difference of the spins, of one size whatever that
    is: friction times reduced radius times normal force.

    Ai et al. (2011), model A; c = (rolling friction,).  At rest it changes its sign from step to step.
    """
    return stored, scaled(-c[0] * touch.radius * elastic, direction(rolling))


ROW = RollingLaw(
    key="constant-torque",
    rank=3,
    title="One moment against any rolling",
    source="ai_2011",
    locator="model A",
    law=law,
    coefficients=(spring_slider.FRICTION,),
    dissipates=("dashpot",),
    restless=True,
)
