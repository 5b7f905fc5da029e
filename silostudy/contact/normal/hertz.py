"""Hertz's contact of two elastic spheres, with a dashpot that gives one restitution at every speed and never pulls."""

from numba.extending import register_jitable

from silostudy.contact import elastic
from silostudy.contact.family import NormalLaw


@register_jitable
def law(overlap, closing, touch, c):
    """Elastic and total normal force (N) of two elastic spheres; the sum with the dashpot never pulls.

    Johnson (1985), eq. (4.23); dashpot of Antypov & Elliott (2011); c = (4/3 E*, damping).
    """
    force = c[0] * elastic.contact_radius(touch) * overlap
    total = force + elastic.dashpot(c[1], touch) * closing
    return force, (total if total > 0.0 else 0.0)


ROW = NormalLaw(
    key="hertz",
    rank=5,
    title="Hertz's elastic spheres, dashpot of one restitution, no tension",
    source="johnson_1985",
    locator="eq. (4.23)",
    law=law,
    energy=elastic.energy,
    stiffness=elastic.stiffness,
    damping=elastic.damping,
    coefficients=(elastic.STIFFNESS, elastic.DAMPING),
    grains=("spheres",),
    of_hertz=True,
    damped=elastic.damping_where_cut,
    dissipates=("dashpot",),
)
