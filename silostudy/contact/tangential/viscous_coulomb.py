"""A dashpot capped by Coulomb friction."""

from math import sqrt

import numpy as np
from numba.extending import register_jitable

from silostudy.contact import spring
from silostudy.contact.family import TangentialLaw
from silostudy.contact.vector import limited, scaled


@register_jitable
def law(stored, sliding, touch, elastic, normal, c):
    """Tangential force (N/m) of a dashpot capped by friction times the normal force that presses; nothing is stored.

    Haff & Werner (1986); c = (damping, damping by root of mass, friction).
    """
    return stored, limited(scaled(-(c[0] + c[1] * sqrt(touch.mass)), sliding), c[2] * spring.pressing(normal))[0]


def damping(touch, c):
    """Damping (N s/m per m) of the dashpot where it is not capped."""
    return c[0] + c[1] * np.sqrt(touch.mass)


ROW = TangentialLaw(
    key="viscous-coulomb",
    rank=5,
    title="Dashpot capped by Coulomb friction",
    source="haff_werner_1986",
    locator="tangential force",
    law=law,
    damping=damping,
    coefficients=(*spring.DRAG, spring.FRICTION),
    dissipates=("dashpot", "sliding"),
)
