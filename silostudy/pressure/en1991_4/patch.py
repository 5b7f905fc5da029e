"""Patch loads of EN 1991-4:2006: on a thin circular wall, and as a band round any other plan.

Printed standard not seen; agrees in two or more public programs.
"""

import numpy as np

BAND = 0.36  # of the patch pressure


def patch_factor_filling(*, patch_factor, eccentricity, diameter, cylinder_depth):
    """Patch factor C_pf (1): 0.21 C_op (1 + 2 E^2)(1 - exp(-1.5 (h_c/d_c - 1))) >= 0, E = 2 e/d_c. Source: en1991_4_2006."""
    e, excess = 2 * eccentricity / diameter, cylinder_depth / diameter - 1
    return np.maximum(0.21 * patch_factor * (1 + 2 * e**2) * -np.expm1(-1.5 * excess), 0.0)


def patch_factor_discharge(*, patch_factor, eccentricity, diameter, cylinder_depth):
    """Patch factor C_pe (1): twice the filling's above h_c/d_c = 1.2, below 0.272 C_op (h_c/d_c - 1 + E), at least 0.

    Source: en1991_4_2006; the second form from one public program only.
    """
    own = {"patch_factor": patch_factor, "eccentricity": eccentricity, "diameter": diameter, "cylinder_depth": cylinder_depth}
    slenderness = cylinder_depth / diameter
    low = 0.272 * patch_factor * (slenderness - 1 + 2 * eccentricity / diameter)
    return np.where(slenderness > 1.2, 2 * patch_factor_filling(**own), np.maximum(low, 0.0))


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


def band_pressure(pressure):
    """Pressure (Pa) of a band of the patch's height all round a plan that is no circle: 0.36 p_p. Source: en1991_4_2006."""
    return BAND * pressure
