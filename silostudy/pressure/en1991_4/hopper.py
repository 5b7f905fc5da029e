"""Steep and shallow hoppers of EN 1991-4:2006, x the height above the apex: cones, pyramids and wedges.

Printed standard not seen; agrees in two or more public programs, but for discharge in shallow hoppers (as filling: two
programs of three) and the exponent, on which programs disagree: n = S (F mu cot(beta) + F) - S is the equilibrium of slices,
and what their own filling rule and AS 3774 come to; "- 2" is the same for S = 2 alone, and lets the wall of a wedge carry 1.6
to 2.1 times contents and load.  Where two pairs of walls of different slope meet in one apex, equilibrium asks for the sum of
F (1 + mu cot(beta)) - 1 over the pairs: S = 2 for a cone or a square pyramid, S = 1 for a wedge between smooth vertical ends.
"""

import numpy as np
from scipy.special import exprel

from silostudy.pressure.hopper_shape import steepness

PRESSURE_LOSS = 0.2  # 1 - F_f on a wall so rough that tan(beta)/mu vanishes
QUANTITIES = ("normal_pressure", "friction_traction", "vertical_pressure")


def effective_friction(half_angle, mu, k):
    """Effective hopper friction mu_heff (1): mu where the hopper is steep, else (1 - K)/(2 tan beta). Source: en1991_4_2006."""
    return np.where(is_steep(half_angle, mu, k), mu, (1 - k) / (2 * np.tan(half_angle)))


def is_steep(half_angle, mu, k):
    """Whether wall friction is fully mobilised, by the lower K and mu_h: one class for filling and discharge.

    Source: en1991_4_2006: tan(beta) < (1 - K)/(2 mu); which K and mu: two programs of three.
    """
    return 2 * mu * np.tan(half_angle) < 1 - k


def filling_ratio(half_angle, mu):
    """Ratio F_f (1) of normal to vertical pressure: 1 - 0.2/(1 + tan(beta)/mu). Source: en1991_4_2006."""
    return 1 - PRESSURE_LOSS * mu / (mu + np.tan(half_angle))


def flow_angle(mu, phi):
    """Angle eps (rad) of the stresses' turn at the wall in flow: phi_wh + asin(sin phi_wh/sin phi). Source: en1991_4_2006."""
    wall = np.arctan(mu)
    return wall + np.arcsin(np.minimum(np.sin(wall) / np.sin(phi), 1.0))


def discharge_ratio(half_angle, mu, phi):
    """Ratio F_e (1): (1 + sin phi cos eps)/(1 - sin phi cos(2 beta + eps)), eps = phi_wh + asin(sin phi_wh/sin phi).

    Source: en1991_4_2006 (a public program has beta + eps in place of 2 beta + eps and is wrong).
    """
    turn = flow_angle(mu, phi)
    return (1 + np.sin(phi) * np.cos(turn)) / (1 - np.sin(phi) * np.cos(2 * half_angle + turn))


def vertical_pressure(share, *, weight, exponent, top):
    """Vertical pressure p_v (Pa) at a share x/h_h of the height: weight = gamma h_h and top = p_vft (Pa), exponent n.

    Source: en1991_4_2006: gamma h_h/(n - 1) [x/h_h - (x/h_h)^n] + p_vft (x/h_h)^n.
    (x - x^n)/(n - 1) = -x log(x) (e^u - 1)/u with u = (n - 1) log(x): nothing cancels at n = 1.
    """
    inside = np.where(share > 0, share, 1.0)
    log = np.log(inside)
    value = -weight * inside * log * exprel((exponent - 1) * log) + top * inside**exponent
    at_apex = np.select([exponent > 0, exponent == 0], [0.0, weight + top], np.inf)  # n <= 0: pressure grows downward
    return np.where(share > 0, value, np.where(np.isfinite(at_apex), at_apex, np.nan))


def exponent(ratio, half_angle, mu):
    """One pair of walls' part of the exponent n (1): F mu cot(beta) + F - 1, from two pairs in a cone or a pyramid.

    Source: en1991_4_2006, by the equilibrium of slices (programs that print "- 2" for a wedge are not in equilibrium).
    """
    return ratio * steepness(half_angle, mu) - 1
