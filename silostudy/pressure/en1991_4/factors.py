"""C_h and C_w, wall pressure and friction in discharge over those after filling, and C_b of the load on the bottom.

Printed standard not seen.  Action assessment classes 2 and 3 share the usual factors; class 1 may take the simplified ones.
"""

import numpy as np

from silostudy.pressure.en1991_4.cylinder import SLENDER, SQUAT

# of a slender silo in discharge
NORMAL_INCREASE = 0.15  # C_h - 1
FRICTION_INCREASE = 0.10  # C_w - 1
DYNAMIC_BOTTOM = 0.2  # more where the solid may act dynamically on the bottom
SIMPLIFIED_BOTTOM = 1.3  # C_b of class 1
SLENDERNESS = ("diameter", "cylinder_depth")
OFF_AXIS = ("filling_eccentricity", "outlet_eccentricity")


def _increased(increase, diameter, cylinder_depth):
    """Factor 1 + increase (1) for slender silos, 1 for squat ones, with C_S = h_c/d_c - 1 between."""
    return 1 + increase * np.clip(cylinder_depth / diameter - SQUAT, 0.0, 1.0)


def normal_factor(*, diameter, cylinder_depth):
    """Discharge factor C_h (1): 1.15 for slender silos, 1 for squat ones, between 1 + 0.15 C_S, C_S = h_c/d_c - 1.

    Source: en1991_4_2006 (agrees in two or more public programs).
    """
    return _increased(NORMAL_INCREASE, diameter, cylinder_depth)


def friction_factor(*, diameter, cylinder_depth):
    """Discharge factor C_w (1): 1.10 for slender silos, 1 for squat ones, between 1 + 0.10 C_S, C_S = h_c/d_c - 1.

    Source: en1991_4_2006 (agrees in two or more public programs).
    """
    return _increased(FRICTION_INCREASE, diameter, cylinder_depth)


def _simplified(slender, diameter, cylinder_depth):
    """A factor (1) of class 1: that of slender silos, 1 for squat ones; NaN between, where it is known from memory only."""
    slenderness = cylinder_depth / diameter
    return np.select([slenderness >= SLENDER, slenderness <= SQUAT], [slender, 1.0], np.nan)


def _off_axis(filling_eccentricity, outlet_eccentricity, diameter):
    """Factor 1 + 0.4 e/d_c (1), e the larger eccentricity of heap and outlet."""
    return 1 + 0.4 * np.maximum(filling_eccentricity, outlet_eccentricity) / diameter


def simplified_normal_factor(*, patch_factor, filling_eccentricity, outlet_eccentricity, diameter, cylinder_depth):
    """Discharge factor C_h (1) of class 1 in slender silos: 1.15 + 1.5 (1 + 0.4 e/d_c) C_op, e the larger eccentricity.

    Source: en1991_4_2006, one source: one public program; an account without the 1.15 gets less than 1 for soya and says so.
    """
    off_axis = _off_axis(filling_eccentricity, outlet_eccentricity, diameter)
    return _simplified(1 + NORMAL_INCREASE + 1.5 * off_axis * patch_factor, diameter, cylinder_depth)


def simplified_friction_factor(*, filling_eccentricity, outlet_eccentricity, diameter, cylinder_depth):
    """Discharge factor C_w (1) of class 1 in slender silos: 1.4 (1 + 0.4 e/d_c), e the larger eccentricity.

    Source: en1991_4_2006, one source: one public program; an account agrees at e = 0.
    """
    return _simplified(1.4 * _off_axis(filling_eccentricity, outlet_eccentricity, diameter), diameter, cylinder_depth)


def bottom_magnifier(*, dynamic_bottom):
    """Bottom load magnifier C_b (1), over the vertical pressure at the transition: 1.0; 1.2 where the solid acts dynamically.

    Source: en1991_4_2006: 1.0 as four public programs have it; 1.2, on the user's declaration alone, one source.
    """
    return 1 + DYNAMIC_BOTTOM * dynamic_bottom


def simplified_bottom_magnifier():
    """Bottom load magnifier C_b (1) of class 1: 1.3. Source: en1991_4_2006, one source: one public program."""
    return np.float64(SIMPLIFIED_BOTTOM)


USUAL = {"normal_pressure_increase": normal_factor, "wall_friction_increase": friction_factor}
SIMPLIFIED = {
    "normal_pressure_increase": simplified_normal_factor,
    "wall_friction_increase": simplified_friction_factor,
}
