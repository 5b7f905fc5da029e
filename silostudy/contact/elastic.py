"""Elastic spheres: the moduli of a contact from those of its two bodies, and what the laws of Hertz and Mindlin share."""

from functools import cache
from math import log, pi, sqrt

import numpy as np
from numba.extending import register_jitable
from scipy.optimize import brentq

from silostudy.contact.coefficient import Coefficient, Given

LEAST = 1e-3  # restitution below which no dashpot is sought


def contact_modulus(youngs_modulus: float, poissons_ratio: float, other_modulus: float, other_ratio: float) -> float:
    """Modulus E* (Pa) of a contact: 1/E* is the sum of (1 - nu^2)/E over both bodies (Johnson 1985, eq. 4.6)."""
    return 1.0 / ((1.0 - poissons_ratio**2) / youngs_modulus + (1.0 - other_ratio**2) / other_modulus)


def contact_shear_modulus(youngs_modulus: float, poissons_ratio: float, other_modulus: float, other_ratio: float) -> float:
    """Shear modulus G* (Pa) of a contact: 1/G* is the sum of (2 - nu)/G over both bodies, G = E/(2 (1 + nu)).

    Johnson (1985), section 7.3: with it the tangential stiffness without slip is 8 G* times the radius of the contact.
    """
    shear = [e / (2.0 * (1.0 + nu)) for e, nu in ((youngs_modulus, poissons_ratio), (other_modulus, other_ratio))]
    return 1.0 / ((2.0 - poissons_ratio) / shear[0] + (2.0 - other_ratio) / shear[1])


def damping_where_pulled(restitution: float) -> float:
    """Damping number (1) with which a Hertz contact that ends when the overlap does has this restitution at every speed.

    Antypov & Elliott (2011): 2 sqrt(5/6) beta sqrt(S m) is sqrt(5) beta sqrt(4/3 E* a m), beta = -ln e/sqrt(ln^2 e + pi^2).
    """
    return -sqrt(5.0) * log(restitution) / sqrt(pi * pi + log(restitution) ** 2)


def restitution_of_cut(damping: float) -> float:
    """Restitution (1) of a head-on Hertz impact whose contact ends when spring and dashpot together cease to press.

    In units of its own length and time the impact is x'' = -x^(3/2) - damping x^(1/4) x', whatever its speed.
    """
    from scipy.integrate import solve_ivp  # here: a start of a process takes a tenth longer with it

    def rates(_, state):
        x, v = max(state[0], 0.0), state[1]
        return v, -(x**1.5) - damping * x**0.25 * v

    def pressing(t, state):
        return 1.0 if t < 1e-3 else -rates(t, state)[1]

    pressing.terminal = True  # type: ignore[attr-defined]
    path = solve_ivp(rates, (0.0, 50.0), (0.0, 1.0), events=pressing, rtol=1e-10, atol=1e-13)
    return float(-path.y[1, -1])


@cache  # takes a tenth of a second, and a scene asks for both contacts, a sweep in every case
@cache
def damping_where_cut(restitution: float) -> float:
    """Damping number (1) with which a Hertz contact that never pulls has this restitution at every speed."""
    if restitution >= 1.0:
        return 0.0
    return float(brentq(lambda damping: restitution_of_cut(damping) - restitution, 0.0, 40.0, xtol=1e-12))


def hertz_stiffness(given: Given) -> float:
    """Hertz's stiffness 4/3 E* (Pa) of two bodies, each with a Young's modulus (Pa) and a Poisson's ratio."""
    return 4.0 / 3.0 * contact_modulus(*_of_both(given))


def hertz_damping(given: Given) -> float:
    """Damping number by the root of 4/3 E* (Pa1/2), for the restitution (1) under the law of the normal force."""
    restitution = given["restitution"]
    if restitution is None:
        return 0.0
    assert given.normal.damped is not None  # every law of Hertz has one
    return given.normal.damped(restitution) * sqrt(hertz_stiffness(given))


def mindlin_stiffness(given: Given) -> float:
    """Mindlin's stiffness 8 G* (Pa) of two bodies."""
    return 8.0 * contact_shear_modulus(*_of_both(given))


def _of_both(given: Given) -> tuple[float, float, float, float]:
    (modulus, ratio), (other_modulus, other_ratio) = given["materials"]
    return modulus, ratio, other_modulus, other_ratio


MATERIALS = ("materials",)  # Young's modulus (Pa) and Poisson's ratio of both bodies
STIFFNESS = Coefficient(
    name="hertz_stiffness", unit="Pa", fields=(MATERIALS,), prepare=hertz_stiffness, positive=True, stiffness_power=1.0
)
DAMPING = Coefficient(
    name="hertz_damping", unit="Pa1/2", fields=(MATERIALS, ("restitution",)), prepare=hertz_damping, damping_power=1.0
)
SHEAR_STIFFNESS = Coefficient(
    name="mindlin_stiffness", unit="Pa", fields=(MATERIALS,), prepare=mindlin_stiffness, positive=True, stiffness_power=1.0
)


@register_jitable
def contact_radius(touch):
    """Radius (m) of the contact of two spheres by Hertz: the root of reduced radius times overlap."""
    return np.sqrt(touch.radius * touch.overlap)


@register_jitable
def shrinking(touch):
    """Radius of a contact over that of a step before (1) where it unloads, one where it loads."""
    return np.sqrt(touch.overlap / touch.before) if touch.before > touch.overlap else 1.0


@register_jitable
def dashpot(damping, touch):
    """Damping (N s/m) of a contact whose restitution is the same at every speed: by the root of mass and contact radius."""
    return damping * np.sqrt(touch.mass * contact_radius(touch))


@register_jitable
def energy(overlap, touch, c):
    """Energy (J) of a Hertz contact at an overlap (m)."""
    return 0.4 * c[0] * np.sqrt(touch.radius * overlap) * overlap * overlap


@register_jitable
def stiffness(overlap, touch, c):
    """Slope (N/m) of Hertz's force at an overlap (m): 2 E* times the contact's radius."""
    return 1.5 * c[0] * np.sqrt(touch.radius * overlap)


def damping(touch, c):
    """Damping (N s/m) at the contact's overlap; c = (4/3 E*, damping)."""
    return dashpot(c[1], touch)


@register_jitable
def shear_stiffness(overlap, touch, c):
    """Tangential stiffness (N/m) of Mindlin's contact without slip; c = (8 G*, ...)."""
    return c[0] * np.sqrt(touch.radius * overlap)
