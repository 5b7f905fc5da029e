"""EN 1998-4: what the contents of a silo add to the pressure on its wall in an earthquake."""

import numpy as np

from silostudy.seismic.family import MassRule
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


ROW = MassRule(
    key="en1998_4",
    rank=50,
    title="EN 1998-4, additional pressure on a circular wall",
    source="en1998_4_2006",
    locator="additional dynamic pressure, circular silo with a flat bottom",
    function=contents_share,
    formula="dp = (a/g) gamma min(min(h_b, d_c/2), 3x) cos(theta); summed: 5h/(6R) for h <= R, 1 - R/(6h) above",
    needs=("height over diameter (1)",),
    validity="circular, flat bottom, rigid; one acceleration over the height for the summed share",
)
