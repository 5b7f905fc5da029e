"""Mass-flow limit: Jenike's half angle up to which a conical hopper flows as a whole."""

import numpy as np

MARGIN = np.radians(3.0)  # designers stay three to four degrees below the limit
LEAST_FRICTION = np.radians(20.0)  # rad: effective friction below which the limit is not given
PATTERNS = ("unknown", "mass_flow", "within_the_margin", "funnel_flow")  # position = flag value in the cube


def limit_angle(effective_friction_angle, hopper_wall_friction):
    """Largest half angle (rad) of a cone in mass flow; NaN below 20 degrees of effective friction or on a rougher wall.

    Source: jenike_johanson_1969, as open programs carry it (the printed bulletin was not seen); the radial field of flow
    ends within half a degree of it.
    """
    wall = np.arctan(hopper_wall_friction)
    k = np.sin(effective_friction_angle)
    covered = (effective_friction_angle >= LEAST_FRICTION) & (wall <= effective_friction_angle)
    turn = wall + np.arcsin(np.where(covered, np.sin(wall) / k, 0.0))
    limit = np.pi / 2 - np.arccos(np.where(covered, (1 - k) / (2 * k), 0.0)) / 2 - turn / 2
    return np.where(covered, limit, np.nan)


def flow_pattern(hopper_half_angle, effective_friction_angle, hopper_wall_friction, circular):
    """Flow pattern of a hopper as a flag of PATTERNS (1); unknown without a cone or an effective friction angle."""
    limit = limit_angle(effective_friction_angle, hopper_wall_friction)
    known = np.isfinite(limit) & np.isfinite(hopper_half_angle) & (circular == 1)
    pattern = np.where(hopper_half_angle <= limit - MARGIN, 1, np.where(hopper_half_angle <= limit, 2, 3))
    return np.where(known, pattern, 0).astype(np.int8)
