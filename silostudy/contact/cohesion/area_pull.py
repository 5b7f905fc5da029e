"""Cohesion: an attraction that grows with the area of contact of two spheres."""

from math import pi

from numba.extending import register_jitable

from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import CohesionLaw


@register_jitable
def law(touch, c):
    """Attraction (N) of two spheres: an energy density times the area of the circle in which they cut each other.

    The simplified JKR law of LIGGGHTS (sjkr), its area to the first order in the overlap: 2 pi times reduced radius times
    overlap, twice that of Hertz's contact; c = (energy density,).
    """
    return 2.0 * pi * c[0] * touch.radius * touch.overlap


@register_jitable
def energy(touch, c):
    """Energy (J) that the attraction holds."""
    return -pi * c[0] * touch.radius * touch.overlap * touch.overlap


ROW = CohesionLaw(
    key="area-pull",
    rank=3,
    title="Pull that grows with the area of contact",
    source="liggghts_sjkr",
    locator="cohesion sjkr, area to the first order in the overlap",
    law=law,
    energy=energy,
    coefficients=(
        Coefficient(
            name="cohesion_energy_density",
            unit="J m-3",
            fields=(("cohesion_energy_density_J_m3",),),
            text="attraction over the area of contact",
            default=0.0,
        ),
    ),
    grains=("spheres",),
)
