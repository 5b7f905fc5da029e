"""Mindlin's tangential spring without slip, whose force shrinks with the contact as it unloads."""

from numba.extending import register_jitable

from silostudy.contact import elastic
from silostudy.contact.family import TangentialLaw
from silostudy.contact.tangential import mindlin
from silostudy.contact.vector import scaled


@register_jitable
def law(stored, sliding, touch, elastic_force, normal, c):
    """Stored and total tangential force (N) as by `mindlin`, the stored one reduced with the contact's radius on unloading.

    Otherwise a contact that slides while it is pressed and lets go unstrained would make energy;
    c = (8 G*, damping, friction).
    """
    return mindlin.law(scaled(elastic.shrinking(touch), stored), sliding, touch, elastic_force, normal, c)


ROW = TangentialLaw(
    key="mindlin-rescaled",
    rank=7,
    title="Mindlin's spring without slip, shrinking on unloading",
    source="mindlin_1949",
    locator="compliance of elastic bodies in contact",
    law=law,
    stiffness=elastic.shear_stiffness,
    damping=mindlin.damping,
    coefficients=mindlin.ROW.coefficients,
    grains=("spheres",),
    stores=True,
    dissipates=("dashpot", "sliding"),
)
