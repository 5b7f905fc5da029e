"""Elastic contact of cylinders along a line: its load-displacement curve, and the linear stiffness read off it."""

from math import log, pi, sqrt

from numba.extending import register_jitable

from silostudy.errors import BadInput

PRINTED_CONSTANTS = {"1.5": 1.5, "2/3": 2.0 / 3.0}  # eq. (23) prints 1.5 where eq. (22a) prints 2/3
NEWTON_STEPS = 6  # from the guess below the curve is met to rounding


def contact_width(radius, *, load, youngs_modulus, poissons_ratio):
    """Width b (m) of the contact of two equal cylinders under a load (N/m).

    Kiyama & Fujimura (1983), eq. (22b) with r1 = r2 = radius (m); Young's modulus in Pa.
    """
    return sqrt(4.0 / pi * radius * (1.0 - poissons_ratio**2) / youngs_modulus * load)


def secant(radius, *, load, youngs_modulus, poissons_ratio, constant=1.5):
    """Normal stiffness K_n (N/m per m) of two equal cylinders under a load (N/m): the secant of the elastic curve.

    Kiyama & Fujimura (1983), eq. (23); `constant` is 1.5 as printed there, or 2/3 as in eq. (22a).
    Raises BadInput where the load is not positive or so large that the curve has turned.
    """
    if not load > 0.0:
        raise BadInput("load", load, "must be positive (N/m)")
    width = contact_width(radius, load=load, youngs_modulus=youngs_modulus, poissons_ratio=poissons_ratio)
    bracket = constant + 2.0 * log(4.0 * radius / width)
    if not bracket > 0.0:
        raise BadInput("load", load, "must leave the contact narrower than the discs")
    return pi * youngs_modulus / (2.0 * (1.0 - poissons_ratio**2) * bracket)


def curve(radius, *, youngs_modulus, poissons_ratio, constant=1.5):
    """Coefficients (A, B) of the curve overlap = A q (B - ln q), q the load (N/m), for two equal cylinders.

    Kiyama & Fujimura (1983), eqs. (22a) and (22b) with r1 = r2 = radius (m).
    """
    compliance = 2.0 * (1.0 - poissons_ratio**2) / (pi * youngs_modulus)
    width = contact_width(radius, load=1.0, youngs_modulus=youngs_modulus, poissons_ratio=poissons_ratio)
    return compliance, constant + 2.0 * log(4.0 * radius / width)


@register_jitable
def load_of(overlap, compliance, bracket):
    """Load q (N/m) at an overlap (m) on the curve overlap = A q (B - ln q), by Newton's method from below."""
    if overlap <= 0.0:
        return 0.0
    q = overlap / (compliance * (bracket - log(overlap / (compliance * bracket))))
    for _ in range(NEWTON_STEPS):
        slope = compliance * (bracket - 1.0 - log(q))
        q -= (compliance * q * (bracket - log(q)) - overlap) / slope
    return q
