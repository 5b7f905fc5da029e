"""Cohesion: a constant attraction of two bodies in touch."""

from numba.extending import register_jitable

from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import CohesionLaw


@register_jitable
def law(touch, c):
    """Attraction (N/m, of spheres N) of two bodies while they touch: the same at every overlap; c = (pull,).

    Luding (2008), the simplest of the cohesive laws.
    """
    return c[0]


@register_jitable
def energy(touch, c):
    """Energy (J/m) that the attraction holds."""
    return -c[0] * touch.overlap


ROW = CohesionLaw(
    key="constant-pull",
    rank=2,
    title="Constant pull-off force while in touch",
    source="luding_2008",
    locator="cohesive contact, constant limit",
    law=law,
    energy=energy,
    coefficients=(
        Coefficient(
            name="pull",
            unit="N m-1",
            fields=(("pull_N_m",),),
            in_space=("N", (("pull_N",),)),
            text="attraction while in touch",
            default=0.0,
        ),
    ),
)
