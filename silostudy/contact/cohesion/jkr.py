"""Cohesion of elastic spheres by their surface energy: the contact is wider than Hertz's and holds on until it is torn off.

Put as a law of attraction: Hertz's, Mindlin's and Marshall's laws see the overlap at which a contact without attraction would
be as wide, and the surface energy pulls against Hertz's force.  With a the radius of the contact, R and E* those of Hertz:
overlap = a^2/R - sqrt(2 pi w a/E*), force = 4/3 E* a^3/R - sqrt(8 pi w E* a^3).
"""

from math import pi

import numpy as np
from numba.extending import register_jitable

from silostudy.contact import elastic
from silostudy.contact.coefficient import Coefficient
from silostudy.contact.family import CohesionLaw

STEPS = 8  # of Newton's method, from above: to rounding at all overlaps that a contact has
LARGEST_PULL = 1.5 * pi  # of a contact, over work of adhesion and reduced radius


@register_jitable
def sinking(c):
    """Root of length (m1/2) by which the attraction takes the bodies nearer or apart: overlap = a^2/R - this times sqrt(a)."""
    return np.sqrt(2.0 * pi * c[1] / (0.75 * c[0]))


@register_jitable
def law(touch, c):
    """Attraction (N) of two elastic spheres by their surface energy; c = (4/3 E*, work of adhesion).

    Johnson, Kendall & Roberts (1971) in the form that LAMMPS documents, w there being 2 gamma.
    """
    radius = elastic.contact_radius(touch)
    return 1.5 * c[0] * sinking(c) * radius * np.sqrt(radius)


@register_jitable
def energy(touch, c):
    """Energy (J) that the attraction holds: the integral of JKR's force less that of Hertz."""
    radius, sunk = elastic.contact_radius(touch), sinking(c)
    return 0.75 * c[0] * sunk * radius * radius * (0.5 * sunk - 4.0 / 3.0 * radius * np.sqrt(radius) / touch.radius)


@register_jitable
def pressed(overlap, radius, c):
    """Overlap (m) at which Hertz's contact is as wide as JKR's at an overlap (m) that may be negative."""
    sunk = sinking(c)
    root = (radius * sunk) ** (1.0 / 3.0) + np.sqrt(np.sqrt(radius * max(overlap, 0.0)))
    for _ in range(STEPS):
        cube = root * root * root / radius
        root -= (root * (cube - sunk) - overlap) / (4.0 * cube - sunk)
    return root * root * root * root / radius


@register_jitable
def gap(radius, c):
    """Gap (m) at which the pull is largest and the contact torn off."""
    wide = (9.0 * pi * c[1] * radius * radius / (6.0 * c[0])) ** (1.0 / 3.0)
    return sinking(c) * np.sqrt(wide) - wide * wide / radius


@register_jitable
def rubbed(force, pull, touch, c):
    """Normal force (N) that friction takes: the contact's own and twice its largest pull.

    Thornton (1991) as LAMMPS documents it.
    """
    return force - pull + 2.0 * LARGEST_PULL * c[1] * touch.radius


ROW = CohesionLaw(
    key="jkr",
    rank=4,
    title="Surface energy of elastic spheres, torn off at a gap",
    source="johnson_kendall_roberts_1971",
    locator="as documented for LAMMPS pair granular",
    law=law,
    energy=energy,
    holds_on=True,
    gap=gap,
    pressed=pressed,
    rubbed=rubbed,
    of_hertz=True,
    coefficients=(
        elastic.STIFFNESS,
        Coefficient(
            name="work_of_adhesion",
            unit="J m-2",
            fields=(("work_of_adhesion_J_m2",),),
            text="energy of surface that two bodies of an area of contact save",
            positive=True,
        ),
    ),
    grains=("spheres",),
    dissipates=("sliding",),
)
