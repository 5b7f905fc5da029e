"""EN 1998-4: what the contents of a silo add to the pressure on its wall in an earthquake."""

import numpy as np

from silostudy.tables.constants import STANDARD_GRAVITY


def wall_pressure(height_above_bottom, *, acceleration, unit_weight, contents_height, diameter, angle=0.0):
    """Additional wall pressure (Pa, outward positive) at height_above_bottom (m) of a circular silo with a flat bottom.

    Source: en1998_4_2006, additional dynamic pressure on a circular wall; acceleration (m s-2) at that height, angle (rad)
    from the direction of the motion, diameter (m) inside, unit_weight (N m-3).
    """
    reach = np.minimum(np.minimum(contents_height, diameter / 2), 3 * height_above_bottom)
    return acceleration / STANDARD_GRAVITY * unit_weight * reach * np.cos(angle)


def contents_share(slenderness):
    """Share (1) of the contents' mass that the pressure, summed over the wall at one acceleration, stands for.

    Source: en1998_4_2006, the integral of wall_pressure over height and circumference; slenderness is height over diameter.
    """
    height_over_radius = 2 * np.asarray(slenderness, dtype=float)
    return np.where(height_over_radius <= 1, 5 / 6 * height_over_radius, 1 - 1 / (6 * height_over_radius))
