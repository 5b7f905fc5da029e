"""Wall friction of corrugated walls: on part of the surface the solid slides on the sheet, on the rest on itself."""

import numpy as np


def corrugated_friction(wall_friction, internal_friction_angle, contact_share):
    """Effective wall friction (1): (1 - a_w) tan(phi) + a_w mu_w, mu_w of the flat sheet and at most tan(phi).

    Source: en1991_4_2006, wall category D4, and as3774_1996, whose forms agree; which spread it has is not known.
    """
    inside = np.tan(internal_friction_angle)
    return (1 - contact_share) * inside + contact_share * np.minimum(wall_friction, inside)
