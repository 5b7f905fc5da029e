"""Mindlin's tangential spring without slip between two elastic spheres, behind a slider; its force stays on unloading."""

from numba.extending import register_jitable

from silostudy.contact import elastic, spring
from silostudy.contact.family import TangentialLaw
from silostudy.contact.vector import less, limited, scaled


@register_jitable
def law(stored, sliding, touch, elastic_force, normal, c):
    """Stored and total tangential force (N); spring and dashpot together stay below friction times normal force.

    Mindlin (1949), stiffness 8 G* times the contact's radius; c = (8 G*, damping, friction).
    """
    stiffness = c[0] * elastic.contact_radius(touch)
    dashpot = scaled(-elastic.dashpot(c[1], touch), sliding)
    total, _ = limited(less(less(stored, stiffness * touch.dt, sliding), -1.0, dashpot), c[2] * spring.pressing(normal))
    return less(total, 1.0, dashpot), total


def damping(touch, c):
    """Damping (N s/m) at the contact's overlap: as large as the normal one."""
    return elastic.dashpot(c[1], touch)


ROW = TangentialLaw(
    key="mindlin",
    rank=6,
    title="Mindlin's spring without slip and a dashpot, their sum capped",
    source="mindlin_1949",
    locator="compliance of elastic bodies in contact",
    law=law,
    stiffness=elastic.shear_stiffness,
    damping=damping,
    coefficients=(elastic.SHEAR_STIFFNESS, elastic.DAMPING, spring.FRICTION),
    grains=("spheres",),
    stores=True,
    dissipates=("dashpot", "sliding"),
)
