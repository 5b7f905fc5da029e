"""Where EN 1991-4:2006 holds, as far as its limits are known second-hand."""

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4.cylinder import SLENDER
from silostudy.pressure.limits import DIAMETER, SLENDERNESS, Limit, Measure

RETAINING = 0.4  # h_c / d_c
LARGE_ECCENTRICITY = 0.25  # of the outlet, over d_c
FRICTION = ("wall_friction", "a_mu", "lateral_pressure_ratio", "a_K")
SCOPE = "EN 1991-4:2006, 1.1.2, by the publisher's scope paragraph and programs"


def _apex_depth(*, cylinder_depth, diameter, hopper_half_angle):
    """Depth (m) of the hopper's apex below the equivalent surface; of the transition where the bottom is flat."""
    below = np.where(np.isnan(hopper_half_angle), 0.0, hopper_shape.apex_height(diameter, hopper_half_angle))
    return cylinder_depth + below


def _apex_slenderness(*, cylinder_depth, diameter, hopper_half_angle):
    return _apex_depth(cylinder_depth=cylinder_depth, diameter=diameter, hopper_half_angle=hopper_half_angle) / diameter


def _heap_share(*, top_cone_height, diameter, repose_angle):
    return top_cone_height / (diameter / 2 * np.tan(repose_angle))


def _contact_share(*, contact_depth, cylinder_depth, diameter, hydraulic_radius, **solid):
    """h_o over the least z_o of any set (1), where the power law stands."""
    friction = np.prod([solid[name] for name in FRICTION], axis=0)
    return np.where(cylinder_depth / diameter >= SLENDER, 0.0, contact_depth * friction / hydraulic_radius)


def _lower_ratio(*, lateral_pressure_ratio, a_K):
    return lateral_pressure_ratio / a_K


CONTACT_SHARE = asking(
    _contact_share,
    (*FRICTION, "contact_depth", "cylinder_depth", "diameter", "hydraulic_radius"),
    _contact_share.__doc__ or "",
    None,
)
ALL = (
    Limit(measure=SLENDERNESS, above=RETAINING, why="retaining silos: their rule was not verified"),
    Limit(measure=Measure("h_b/d_c", "1", _apex_slenderness), below=10.0, why=SCOPE),
    Limit(measure=Measure("h_b", "m", _apex_depth), below=100.0, why=SCOPE),
    Limit(measure=DIAMETER, below=60.0, why=SCOPE),
    Limit(
        measure=Measure("heap height/(d_c/2 tan phi_r)", "1", _heap_share),
        most=1.0,
        why="a heap is no steeper than the angle of repose",
    ),
    Limit(
        measure=Measure("h_o/z_o of the upper mu and K, for h_c/d_c < 2,", "1", CONTACT_SHARE),
        below=1.0,
        why="the power law has no value beyond",
    ),
)
HOPPER = Limit(
    measure=Measure("lower K", "1", _lower_ratio),
    below=1.0,
    part="hopper",
    quantities=(
        "hopper_normal_pressure",
        "hopper_friction_traction",
        "hopper_vertical_pressure",
        "hopper_end_normal_pressure",
        "hopper_end_friction_traction",
        "outlet_force",
        "hopper_steep",
        "hopper_effective_friction",
        "hopper_pressure_ratio",
        "hopper_exponent",
    ),
    why="mu_eff = (1 - K)/(2 tan beta) of a shallow hopper would be negative",
)
ECCENTRIC = (
    *ALL,
    Limit(
        measure=Measure("e_o/d_c", "1", lambda *, outlet_eccentricity, diameter: outlet_eccentricity / diameter),
        above=LARGE_ECCENTRICITY,
        why="two accounts: large outlet eccentricity; the action assessment class is not judged here",
    ),
)
