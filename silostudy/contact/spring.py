"""Coefficients that laws of linear springs and dashpots share, and how a scene's fields become them.

The coefficients of a spring and dashpot are c = (stiffness, damping, damping by root of mass).
"""

from math import pi, sqrt

import numpy as np
from numba.extending import register_jitable

from silostudy.contact.coefficient import Coefficient, Given
from silostudy.contact.curve import PRINTED_CONSTANTS, secant

STIFFNESS = ("normal_stiffness_N_m2", "line_contact")  # fields of which one is given
DAMPING = ("normal_damping_N_s_m2", "damping_ratio", "restitution")
RATIO = ("stiffness_ratio",)
IN_SPACE = ("normal_stiffness_N_m",), ("restitution",)  # what spheres have in place of stiffness and damping


def normal_stiffness(given: Given) -> float:
    """Normal stiffness (N/m per m; of spheres N/m): the scene's own, or the secant of its line contact."""
    line = given.get("line_contact")
    if line is None:
        return given.get("normal_stiffness_N_m") or given["normal_stiffness_N_m2"]
    constant = PRINTED_CONSTANTS[line["constant"]]
    elastic = {"youngs_modulus": line["youngs_modulus_Pa"], "poissons_ratio": line["poissons_ratio"]}
    return secant(given.radius, load=line["load_N_m"], constant=constant, **elastic)


def normal_damping(given: Given) -> float:
    """Normal dashpot (N s/m per m): the scene's own, or of equal discs its ratio to the critical one of their mass."""
    direct, ratio = given.get("normal_damping_N_s_m2"), given.get("damping_ratio") or 0.0
    if direct is not None or given.uneven:
        return direct or 0.0
    mass = given.density * pi * given.radius**2
    return 2.0 * ratio * sqrt(mass * normal_stiffness(given))


def normal_damping_root(given: Given) -> float:
    """Normal dashpot by the root of the reduced mass: for a restitution, and for a damping ratio of discs of several sizes.

    A damping ratio is of a disc's mass: the reduced one at a wall, and twice the reduced one between discs.
    """
    restitution, ratio = given["restitution"], given.get("damping_ratio") if given.uneven else None
    if restitution is not None:
        assert given.normal.damped is not None  # the configuration asks
        return 2.0 * given.normal.damped(restitution) * sqrt(normal_stiffness(given))
    return 2.0 * (ratio or 0.0) * sqrt(normal_stiffness(given) * (1.0 if given.wall else 2.0))


def tangential_stiffness(given: Given) -> float:
    """Tangential stiffness (N/m per m): the scene's ratio of the normal one."""
    return given["stiffness_ratio"] * normal_stiffness(given)


def tangential_damping(given: Given) -> float:
    """Tangential dashpot (N s/m per m): the normal one by the root of the ratio of stiffnesses."""
    return normal_damping(given) * sqrt(given["stiffness_ratio"])


def tangential_damping_root(given: Given) -> float:
    """Tangential dashpot by the root of the reduced mass: the normal one by the root of the ratio of stiffnesses."""
    return normal_damping_root(given) * sqrt(given["stiffness_ratio"])


def friction(given: Given) -> float:
    """Coefficient of sliding friction (1)."""
    return given["sliding_friction"]


DASHPOT = (
    Coefficient(
        name="normal_damping",
        unit="N s m-2",
        fields=(DAMPING,),
        prepare=normal_damping,
        damping_power=1.0,
        in_space=("N s m-1", IN_SPACE),
    ),
    Coefficient(
        name="normal_damping_root",
        unit="N s m-2 (kg m-1)-1/2",
        fields=(DAMPING,),
        prepare=normal_damping_root,
        damping_power=1.0,
        in_space=("N s m-1 kg-1/2", IN_SPACE),
    ),
)
NORMAL = (
    Coefficient(
        name="normal_stiffness",
        unit="N m-2",
        fields=(STIFFNESS,),
        prepare=normal_stiffness,
        positive=True,
        stiffness_power=1.0,
        in_space=("N m-1", IN_SPACE[:1]),
    ),
    *DASHPOT,
)
DRAG = (
    Coefficient(
        name="tangential_damping",
        unit="N s m-2",
        fields=(DAMPING, RATIO),
        prepare=tangential_damping,
        damping_power=1.0,
        in_space=("N s m-1", (*IN_SPACE, RATIO)),
    ),
    Coefficient(
        name="tangential_damping_root",
        unit="N s m-2 (kg m-1)-1/2",
        fields=(DAMPING, RATIO),
        prepare=tangential_damping_root,
        damping_power=1.0,
        in_space=("N s m-1 kg-1/2", (*IN_SPACE, RATIO)),
    ),
)
FRICTION = Coefficient(name="sliding_friction", unit="1", fields=(("sliding_friction",),), prepare=friction)
SLIDER = (
    Coefficient(
        name="tangential_stiffness",
        unit="N m-2",
        fields=(STIFFNESS, RATIO),
        prepare=tangential_stiffness,
        stiffness_power=1.0,
        in_space=("N m-1", (IN_SPACE[0], RATIO)),
    ),
    *DRAG,
    FRICTION,
)


@register_jitable
def energy(overlap, touch, c):
    """Energy (J/m) that a linear spring holds at an overlap (m)."""
    return 0.5 * c[0] * overlap * overlap


@register_jitable
def stiffness(overlap, touch, c):
    """Stiffness (N/m per m) of a linear spring: the same at every overlap."""
    return c[0]


def damping(touch, c):
    """Damping (N s/m per m) of an explicit dashpot."""
    return c[1] + c[2] * np.sqrt(touch.mass)


def implicit_damping(touch, c, moved=1.0):
    """Damping (N s/m per m) of a dashpot on the speed that its force leaves; `moved` bodies' worth of mass answer to it."""
    plain = damping(touch, c)
    return plain / (1.0 + moved * plain * touch.dt / touch.mass)


@register_jitable
def pressing(normal):
    """The part of a normal force (N/m) that friction takes: none of one that pulls."""
    return normal if normal > 0.0 else 0.0
