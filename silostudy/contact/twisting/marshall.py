"""Twisting resistance that follows from sliding friction spread over the circle of contact."""

from numba.extending import register_jitable

from silostudy.contact import elastic
from silostudy.contact.family import TwistingLaw
from silostudy.contact.tangential import mindlin
from silostudy.contact.vector import less, limited, scaled


@register_jitable
def law(stored, twisting, touch, elastic_force, c):
    """Stored and total moment (N m) about the normal; spring and dashpot together stay below 2/3 friction a normal force.

    Marshall (2009), eqs. (32), (33): half the tangential stiffness and dashpot times the square of the radius a of the contact;
    c = (8 G*, damping, friction).
    """
    radius = elastic.contact_radius(touch)
    square = 0.5 * radius * radius
    dashpot = scaled(-square * elastic.dashpot(c[1], touch), twisting)
    spring = less(stored, square * c[0] * radius * touch.dt, twisting)
    total, _ = limited(less(spring, -1.0, dashpot), 2.0 / 3.0 * c[2] * radius * elastic_force)
    return less(total, 1.0, dashpot), total


@register_jitable
def stiffness(overlap, touch, c):
    """Stiffness (N m) against twisting at an overlap (m)."""
    return 0.5 * touch.radius * overlap * elastic.shear_stiffness(overlap, touch, c)


def damping(touch, c):
    """Damping (N m s) against twisting at the contact's overlap."""
    return 0.5 * touch.radius * touch.overlap * elastic.dashpot(c[1], touch)


ROW = TwistingLaw(
    key="marshall",
    rank=4,
    title="Sliding friction spread over the circle of contact",
    source="marshall_2009",
    locator="eqs. (32), (33)",
    law=law,
    stiffness=stiffness,
    damping=damping,
    coefficients=mindlin.ROW.coefficients,
    stores=True,
    dissipates=("dashpot", "sliding"),
)
