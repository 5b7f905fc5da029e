"""Geometry of a cone (below a circle) or a wedge (below a slot), counted from its apex; slot is 1 for a wedge, else 0."""

import numpy as np


def apex_height(diameter, hopper_half_angle):
    """Height (m) of the transition above the hopper's apex, which lies below the outlet."""
    return diameter / (2 * np.tan(hopper_half_angle))


def outlet_height(outlet_width, hopper_half_angle):
    """Height (m) of the outlet above the apex."""
    return outlet_width / (2 * np.tan(hopper_half_angle))


def area(x, *, diameter, perimeter, hopper_half_angle, slot):
    """Area (m2) of the hopper's cross-section at height x (m) above the apex."""
    share = x / apex_height(diameter, hopper_half_angle)
    return perimeter * diameter / (4 - 2 * slot) * share ** (2 - slot)


def wall_length(x, *, diameter, perimeter, hopper_half_angle, slot):
    """Length (m) of the wall around the cross-section at height x (m) above the apex."""
    return perimeter * (x / apex_height(diameter, hopper_half_angle)) ** (1 - slot)


def contents(x, *, diameter, perimeter, hopper_half_angle, slot):
    """Volume (m3) of the hopper between its apex and height x (m)."""
    section = area(x, diameter=diameter, perimeter=perimeter, hopper_half_angle=hopper_half_angle, slot=slot)
    return section * x / (3 - slot)


def steepness(hopper_half_angle, hopper_wall_friction):
    """Upward force per unit of horizontally projected wall over its normal pressure (1): 1 + mu / tan(theta)."""
    return 1 + hopper_wall_friction / np.tan(hopper_half_angle)
