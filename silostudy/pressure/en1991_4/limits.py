"""Limits of EN 1991-4:2006, as far as they are known second-hand."""

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4 import classes
from silostudy.pressure.en1991_4.cylinder import SLENDER, SQUAT
from silostudy.pressure.limits import DIAMETER, SLENDERNESS, Limit, Measure

RETAINING = 0.4  # h_c / d_c
# action assessment classes
SIMPLIFIED = 1.0  # whose methods may be simplified
EVERY_CASE = 3.0  # that calls for every load case
LARGE_ECCENTRICITY = 0.25  # of the outlet, over d_c
OF_BOTTOM = (
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
)
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
    """Ratio of h_o to the least z_o of any set (1), where the power law stands."""
    friction = np.prod([solid[name] for name in FRICTION], axis=0)
    return np.where(cylinder_depth / diameter >= SLENDER, 0.0, contact_depth * friction / hydraulic_radius)


def _lower_ratio(*, lateral_pressure_ratio, a_K):
    return lateral_pressure_ratio / a_K


def _heap_on_floor(*, top_cone_height, cylinder_depth, diameter, hopper_half_angle):
    """Heap height (m) of a flat-bottomed silo that is not slender; 0 of others."""
    concerned = np.isnan(hopper_half_angle) & (cylinder_depth / diameter < SLENDER)
    return np.where(concerned, top_cone_height, 0.0)


def _slenderness_unasked(*, cylinder_depth, diameter, low_patch):
    """Slenderness h_c/d_c (1); NaN, which breaks no limit, where the patch of the one source is asked for."""
    return np.where(low_patch == 1, np.nan, cylinder_depth / diameter)


def _declared(*, assessment_class):
    return np.where(assessment_class == 0, EVERY_CASE, assessment_class)


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
        measure=Measure("largest particle/d_c", "1", lambda *, largest_particle, diameter: largest_particle / diameter),
        most=0.03,
        why="EN 1991-4:2006, 1.1.2, by the publisher's scope paragraph, one source; the older edition is read as 0.3",
    ),
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
LOW_PATCH = Limit(
    measure=Measure("h_c/d_c, where patch_of_low_silo is not asked for,", "1", _slenderness_unasked),
    above=1.2,
    part="patch load",
    phases=("discharge",),
    quantities=("patch_load_factor", "patch_pressure", "patch_resultant", "band_pressure"),
    why="C_pe below is known from one program only",
)
BOTTOM = Limit(
    measure=Measure("heap of a flat-bottomed silo of h_c/d_c < 2", "m", _heap_on_floor),
    most=0.0,
    part="load on the floor",
    quantities=("bottom_pressure",),
    why="how a heap presses on the floor of a silo that is not slender is known from memory only",
)
CLASS_1 = (
    Limit(
        measure=Measure("action assessment class, declared or the least one,", "1", classes.class_taken),
        most=SIMPLIFIED,
        why="the simplified rules are for class 1",
    ),
    Limit(
        measure=Measure("least action assessment class", "1", classes.least_class),
        most=SIMPLIFIED,
        why="below 100 t, one source; a national choice",
    ),
    Limit(
        measure=SLENDERNESS,
        gap=(SQUAT, SLENDER),
        phases=("discharge",),
        why="C_h and C_w of class 1 between squat and slender are known from memory only",
    ),
    Limit(
        measure=Measure("declared dynamic load on the bottom", "1", lambda *, dynamic_bottom: dynamic_bottom),
        most=0.0,
        part="hopper and bottom",
        quantities=(*OF_BOTTOM, "bottom_load_magnifier", "bottom_pressure", "transition_force"),
        why="C_b of class 1 with it is known from memory only",
    ),
)
HOPPER = Limit(
    measure=Measure("lower K", "1", _lower_ratio),
    below=1.0,
    part="hopper",
    quantities=OF_BOTTOM,
    why="mu_eff = (1 - K)/(2 tan beta) of a shallow hopper would be negative",
)
ECCENTRIC = (
    *ALL,
    Limit(
        measure=Measure("e_o/d_c", "1", lambda *, outlet_eccentricity, diameter: outlet_eccentricity / diameter),
        above=LARGE_ECCENTRICITY,
        why="two accounts: large outlet eccentricity",
    ),
    Limit(
        measure=Measure("action assessment class, where it is declared,", "1", _declared),
        least=EVERY_CASE,
        why="the load case is one of class 3",
    ),
)
ECCENTRIC_SLENDER = Limit(measure=SLENDERNESS, least=SLENDER, why="lower silos by one source, a row of its own")
ECCENTRIC_LOW = Limit(measure=SLENDERNESS, below=SLENDER, why="slender silos by two sources, a row of its own")
