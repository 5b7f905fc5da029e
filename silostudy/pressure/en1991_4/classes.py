"""Action assessment classes of EN 1991-4:2006: how much care a silo asks for, by capacity and eccentricity of its outlet.

A higher class may always be taken.  The limits are national choices: they stand in tables/en1991_4_classes.csv.
"""

import numpy as np

from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.read import HERE, rows

LIMITS = {row["limit"]: row["value"] for row in rows(HERE / "en1991_4_classes.csv", ("limit", "unit"))}


def capacity(*, volume, unit_weight):
    """Mass (kg) of the contents, of the upper unit weight. Source: en1991_4_2006, as a public program reckons it."""
    return volume * unit_weight / STANDARD_GRAVITY


def least_class(*, volume, unit_weight, outlet_eccentricity, diameter):
    """Least action assessment class (1) of a silo: 3 by its capacity, or by it with an eccentric outlet; 1 for a small one.

    Source: en1991_4_2006: above 10 000 t class 3, above 1000 t with e_o/d_c > 0.25 too, below 100 t class 1 (one source).
    A squat silo above 1000 t with a large eccentricity of its surface is class 3 as well; its limit is from memory only.
    """
    mass, eccentricity = capacity(volume=volume, unit_weight=unit_weight), outlet_eccentricity / diameter
    off_axis = (mass > LIMITS["class_3_off_axis_above"]) & (eccentricity > LIMITS["class_3_outlet_eccentricity_above"])
    return np.select([(mass > LIMITS["class_3_above"]) | off_axis, mass < LIMITS["class_1_below"]], [3.0, 1.0], 2.0)


def class_taken(*, assessment_class, volume, unit_weight, outlet_eccentricity, diameter):
    """Action assessment class (1): the one declared, else the least one. Source: en1991_4_2006."""
    least = least_class(volume=volume, unit_weight=unit_weight, outlet_eccentricity=outlet_eccentricity, diameter=diameter)
    return np.where(assessment_class == 0, least, assessment_class)
