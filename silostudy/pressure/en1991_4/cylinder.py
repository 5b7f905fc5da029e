"""Vertical walls of EN 1991-4:2006: slender silos by Janssen, intermediate and squat ones by a modified Reimbert power law.

Printed standard not seen; agrees in two or more public programs.  The pressures of retaining silos (h_c/d_c <= 0.4) were
not verified and are masked.  mu and K are characteristic values; z counts from the equivalent surface.
"""

import numpy as np
from scipy.special import exprel

from silostudy.pressure import janssen

SLENDER, SQUAT, RETAINING = 2.0, 1.0, 0.4  # h_c / d_c
NORMAL_INCREASE, FRICTION_INCREASE = 0.15, 0.10  # of a slender silo in discharge


def contact_depth(*, diameter, repose_angle, circular):
    """Depth h_o (m) of the highest wall contact below the equivalent surface, heap at the angle of repose.

    Source: en1991_4_2006: (r/3) tan(phi_r) for a circle, (d_c/4) tan(phi_r) for a rectangle.
    """
    return diameter * np.tan(repose_angle) * np.where(circular, 1 / 6, 1 / 4)


def _over(y):
    """log(1 + y) / y (1), 1 at y = 0."""
    return np.where(y == 0, 1.0, np.log1p(y) / np.where(y == 0, 1.0, y))


def power_law(z, *, unit_weight, hydraulic_radius, mu, k, contact, repose_angle):
    """(p_h, p_v) (Pa) of intermediate and squat silos at depth z (m); NaN above the wall contact.

    Source: en1991_4_2006: Y = 1 - [(z - h_o)/(z_o - h_o) + 1]^n, n = -(1 + tan phi_r)(1 - h_o/z_o), p_v = gamma z_V.
    Written so that nothing cancels at n = -1 nor as mu goes to 0: y = (z - h_o)/(z_o - h_o), z_o = R/(K mu).
    """
    reserve = hydraulic_radius - k * mu * contact  # (z_o - h_o) K mu
    covered = (reserve > 0) & (z >= contact)
    depth, reserve = np.where(covered, z - contact, 0.0), np.where(reserve > 0, reserve, 1.0)
    y = k * mu * depth / reserve
    n = -(1 + np.tan(repose_angle)) * reserve / hydraulic_radius
    log = np.log1p(y)
    stretched = depth * _over(y)  # (z_o - h_o) log(1 + y)
    p_h = unit_weight * hydraulic_radius * -n * stretched * k / reserve * exprel(n * log)
    p_v = unit_weight * (contact + stretched * exprel((n + 1) * log))
    return np.where(covered, p_h, np.nan), np.where(covered, p_v, np.nan)


def pressures(z, *, unit_weight, hydraulic_radius, mu, k, diameter, cylinder_depth, repose_angle, circular):
    """(p_hf, p_vf) (Pa) after filling at depth z (m), by slenderness class; NaN for retaining silos.

    Source: en1991_4_2006: p_hf = p_ho (1 - exp(-z/z_o)) and p_vf = p_hf/K for slender silos, power_law for the others.
    """
    slenderness = cylinder_depth / diameter
    own = {"unit_weight": unit_weight, "hydraulic_radius": hydraulic_radius}
    p_v = janssen.vertical_pressure(z, **own, wall_friction=mu, lateral_pressure_ratio=k)
    contact = contact_depth(diameter=diameter, repose_angle=repose_angle, circular=circular)
    squat_h, squat_v = power_law(z, **own, mu=mu, k=k, contact=contact, repose_angle=repose_angle)
    classes = [slenderness >= SLENDER, slenderness > RETAINING]
    return np.select(classes, [k * p_v, squat_h], np.nan), np.select(classes, [p_v, squat_v], np.nan)


def discharge_factor(increase, *, diameter, cylinder_depth):
    """C_h or C_w (1): 1 + increase for slender silos, 1 for squat ones, with C_S = h_c/d_c - 1 between.

    Source: en1991_4_2006.
    """
    return 1 + increase * np.clip(cylinder_depth / diameter - SQUAT, 0.0, 1.0)


def patch_factor_filling(*, patch_factor, eccentricity, diameter, cylinder_depth):
    """C_pf (1). Source: en1991_4_2006: 0.21 C_op (1 + 2 E^2)(1 - exp(-1.5 (h_c/d_c - 1))) >= 0, E = 2 e/d_c."""
    e, excess = 2 * eccentricity / diameter, cylinder_depth / diameter - 1
    return np.maximum(0.21 * patch_factor * (1 + 2 * e**2) * -np.expm1(-1.5 * excess), 0.0)


def patch_factor_discharge(*, patch_factor, eccentricity, diameter, cylinder_depth):
    """C_pe (1): twice the filling's above h_c/d_c = 1.2, below it 0.272 C_op (h_c/d_c - 1 + E), at least 0.

    Source: en1991_4_2006; the second form from one public program only.
    """
    given = {"patch_factor": patch_factor, "eccentricity": eccentricity, "diameter": diameter}
    e, excess = 2 * eccentricity / diameter, cylinder_depth / diameter - 1
    low = np.maximum(0.272 * patch_factor * (excess + e), 0.0)
    return np.where(excess > 0.2, 2 * patch_factor_filling(**given, cylinder_depth=cylinder_depth), low)


def patch_depth(*, hydraulic_radius, mu, k, cylinder_depth):
    """Depth z_p (m) of the patch: min(z_o, h_c/2), z_o = R/(K mu). Source: en1991_4_2006."""
    friction = k * mu
    z_o = np.divide(hydraulic_radius, friction, out=np.full(np.shape(friction), np.inf), where=friction > 0)
    return np.minimum(z_o, cylinder_depth / 2)


def patch_height(*, diameter):
    """Height s (m) of the patch: pi d_c/16. Source: en1991_4_2006."""
    return np.pi * diameter / 16


def patch_resultant(pressure, *, diameter):
    """Resultant (N) of a patch p_p cos(theta) on a thin steel wall: (pi/2) s d_c p_p. Source: en1991_4_2006."""
    return np.pi / 2 * patch_height(diameter=diameter) * diameter * pressure
