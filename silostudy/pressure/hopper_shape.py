"""Geometry of a cone, a pyramid or a wedge, counted from its apex; slot is 1 for a wedge (below a slot), else 0.

A rectangle's four walls meet in one apex, so that its end walls are flatter than its long ones, whose half angle is given.
"""

import numpy as np


def apex_height(diameter, hopper_half_angle):
    """Height (m) of the transition above the hopper's apex, which lies below the outlet."""
    return diameter / (2 * np.tan(hopper_half_angle))


def outlet_height(outlet_width, hopper_half_angle):
    """Height (m) of the outlet above the apex."""
    return outlet_width / (2 * np.tan(hopper_half_angle))


def end_half_angle(hopper_half_angle, end_ratio):
    """Half angle (rad) of the end walls: tangent that of the long ones times the plan's length over its width."""
    return np.arctan(end_ratio * np.tan(hopper_half_angle))


def area(x, *, diameter, hydraulic_radius, perimeter, hopper_half_angle, slot):
    """Area (m2) of the hopper's cross-section at height x (m) above the apex."""
    share = x / apex_height(diameter, hopper_half_angle)
    return hydraulic_radius * perimeter * share ** (2 - slot)


def wall_length(x, *, diameter, perimeter, hopper_half_angle, slot):
    """Length (m) of the wall around the cross-section at height x (m) above the apex."""
    return perimeter * (x / apex_height(diameter, hopper_half_angle)) ** (1 - slot)


def contents(x, *, diameter, hydraulic_radius, perimeter, hopper_half_angle, slot):
    """Volume (m3) of the hopper between its apex and height x (m)."""
    shape = {"diameter": diameter, "hydraulic_radius": hydraulic_radius, "perimeter": perimeter}
    return area(x, **shape, hopper_half_angle=hopper_half_angle, slot=slot) * x / (3 - slot)


def steepness(hopper_half_angle, hopper_wall_friction):
    """Upward force per unit of horizontally projected wall over its normal pressure (1): 1 + mu / tan(theta)."""
    return 1 + hopper_wall_friction / np.tan(hopper_half_angle)
