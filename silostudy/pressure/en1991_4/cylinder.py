"""Vertical walls of EN 1991-4:2006: slender silos by Janssen, intermediate and squat ones by a modified Reimbert power law.

Printed standard not seen; agrees in two or more public programs.  mu and K are characteristic values; z counts from the
equivalent surface, and so does the highest wall contact h_o: a level surface has h_o = 0, a full cone (r/3) tan(phi_r).
"""

import numpy as np
from scipy.special import exprel

from silostudy.pressure import janssen

# h_c / d_c
SLENDER = 2.0  # from which on a silo is slender
SQUAT = 1.0  # up to which it is squat
CLASSES = ("squat", "intermediate", "slender")


def _over(y):
    """Quotient log(1 + y) / y (1), 1 at y = 0."""
    return np.where(y == 0, 1.0, np.log1p(y) / np.where(y == 0, 1.0, y))


def power_exponent(*, hydraulic_radius, mu, k, contact, repose_angle):
    """Exponent n (1) of the power law: -(1 + tan phi_r)(1 - h_o/z_o), z_o = R/(K mu). Source: en1991_4_2006."""
    return -(1 + np.tan(repose_angle)) * (hydraulic_radius - k * mu * contact) / hydraulic_radius


def power_law(z, *, unit_weight, hydraulic_radius, mu, k, contact, repose_angle):
    """Pressures p_h, p_v (Pa) of intermediate and squat silos at depth z (m); NaN above the wall contact.

    Source: en1991_4_2006: Y = 1 - [(z - h_o)/(z_o - h_o) + 1]^n, n = -(1 + tan phi_r)(1 - h_o/z_o), p_v = gamma z_V.
    Written so that nothing cancels at n = -1 nor as mu goes to 0: y = (z - h_o)/(z_o - h_o), z_o = R/(K mu).
    """
    reserve = hydraulic_radius - k * mu * contact  # (z_o - h_o) K mu
    n = power_exponent(hydraulic_radius=hydraulic_radius, mu=mu, k=k, contact=contact, repose_angle=repose_angle)
    covered = (reserve > 0) & (z >= contact)
    depth, reserve = np.where(covered, z - contact, 0.0), np.where(reserve > 0, reserve, 1.0)
    y = k * mu * depth / reserve
    log = np.log1p(y)
    stretched = depth * _over(y)  # (z_o - h_o) log(1 + y)
    p_h = unit_weight * hydraulic_radius * -n * stretched * k / reserve * exprel(n * log)
    p_v = unit_weight * (contact + stretched * exprel((n + 1) * log))
    return np.where(covered, p_h, np.nan), np.where(covered, p_v, np.nan)


def slenderness_class(*, cylinder_depth, diameter):
    """Class by h_c/d_c (1), a number of CLASSES. Source: en1991_4_2006: slender >= 2, intermediate > 1, squat below."""
    slenderness = cylinder_depth / diameter
    return np.select([slenderness >= SLENDER, slenderness > SQUAT], [2.0, 1.0], 0.0)


def pressures(z, *, unit_weight, hydraulic_radius, mu, k, diameter, cylinder_depth, repose_angle, contact_depth):
    """Pressures p_hf, p_vf (Pa) after filling at depth z (m), by slenderness class.

    Source: en1991_4_2006: p_hf = p_ho (1 - exp(-z/z_o)) and p_vf = p_hf/K for slender silos, power_law for the others.
    """
    slender = cylinder_depth / diameter >= SLENDER
    own = {"unit_weight": unit_weight, "hydraulic_radius": hydraulic_radius}
    p_v = janssen.vertical_pressure(z, **own, wall_friction=mu, lateral_pressure_ratio=k)
    squat_h, squat_v = power_law(z, **own, mu=mu, k=k, contact=contact_depth, repose_angle=repose_angle)
    return np.where(slender, k * p_v, squat_h), np.where(slender, p_v, squat_v)
