"""AS 3774-1996, eccentric discharge of a circular container: more on the far wall, less on the near one.

A band of the diameter's height on either side.  On the far side p_nf grows by (e_o/d_c - 0.1) cos of the angle from the far
end, over a half circle; on the near side it falls by 1.5 times that, evenly over an arc about the outlet's side.
"""

import numpy as np

from silostudy.pressure.as3774_1996 import wall
from silostudy.pressure.calls import asking, call, parameters_of

NOT_COUNTED = 0.1  # of the diameter: how far off the axis an outlet still counts as central
RELIEF = 1.5  # decrease on the near side over the increase on the far side
SIZES = ("diameter", "outlet_eccentricity")
FRICTION = ("internal_friction_angle", "outlet_depth")


def far_side_increase(*, diameter, outlet_eccentricity):
    """Largest pressure added on the far side over p_nf (1): e_o/d_c - 0.1, at least 0.

    Source: as3774_1996, second-hand (two accounts).
    """
    return np.maximum(outlet_eccentricity / diameter - NOT_COUNTED, 0.0)


def near_side_decrease(*, diameter, outlet_eccentricity):
    """Pressure taken off on the near side over p_nf (1): 1.5 (e_o/d_c - 0.1).

    Source: as3774_1996, second-hand (two accounts).
    """
    return RELIEF * far_side_increase(diameter=diameter, outlet_eccentricity=outlet_eccentricity)


def far_side_depth(*, diameter, outlet_eccentricity, internal_friction_angle, outlet_depth):
    """Depth (m) of the middle of the far side's band: (0.5 d_c + e_o) tan(phi) above the outlet.

    Source: as3774_1996, second-hand (two accounts), which take the upper friction angle; here the one handed over.
    """
    return outlet_depth - (0.5 * diameter + outlet_eccentricity) * np.tan(internal_friction_angle)


def near_side_half_angle(*, diameter, outlet_eccentricity):
    """Half the arc (rad) on the near side: d_e over d_c, d_e = 1.83 d_c (1 - 1.43 e_o/d_c); a right angle at e_o = 0.1 d_c.

    Source: as3774_1996, second-hand (one account), and geometry: its angle of 105 - 150 e_o/d_c degrees is this half angle.
    """
    return np.radians(105.0 - 150.0 * np.maximum(outlet_eccentricity / diameter, NOT_COUNTED))


def band_height(*, diameter):
    """Height (m) of either band, the near side's up from the outlet: d_c. Source: as3774_1996, second-hand (two accounts)."""
    return 1.0 * diameter


def _far_side_pressure(**given):
    depth = call(far_side_depth, None, given)
    pressure = call(wall.FLOW["wall_normal_pressure"], depth, given) * (1 + call(far_side_increase, None, given))
    return np.where((depth > 0) & (depth <= given["cylinder_depth"]), pressure, np.nan)  # a band on the cylinder's wall


TOTALS = {
    "far_side_increase": far_side_increase,
    "far_side_depth": far_side_depth,
    "far_side_pressure": asking(
        _far_side_pressure,
        (*parameters_of(wall.FLOW["wall_normal_pressure"]), *SIZES, *FRICTION),
        "Largest wall pressure (Pa) in the middle of the far side's band. Source: as3774_1996, second-hand (two accounts).",
        None,
    ),
    "near_side_decrease": near_side_decrease,
    "near_side_half_angle": near_side_half_angle,
    "eccentric_band_height": band_height,
}
