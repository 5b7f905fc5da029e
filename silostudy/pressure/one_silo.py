"""Scope of the methods that the source gives for one silo only: its proportions and, for charts, its friction."""

import numpy as np

SLENDERNESS = 3.6  # 18 m of cylinder over 5 m of diameter; inferred from Table 4.2.5, the source prints no size
WALL_FRICTION = 0.44  # silo_handbook, Table 4.2.4
LATERAL_PRESSURE_RATIO = 0.45  # silo_handbook, Table 4.2.4
TOLERANCE = 1e-6


def same_proportions(diameter, cylinder_depth):
    """True where the cylinder has the proportions of the source's silo."""
    return np.isclose(cylinder_depth / diameter, SLENDERNESS, rtol=TOLERANCE, atol=0)


def same_friction(wall_friction, lateral_pressure_ratio):
    """True where the solid rubs and spreads as the source's wheat does."""
    return np.isclose(wall_friction, WALL_FRICTION, rtol=TOLERANCE, atol=0) & np.isclose(
        lateral_pressure_ratio, LATERAL_PRESSURE_RATIO, rtol=TOLERANCE, atol=0
    )
