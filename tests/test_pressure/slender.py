"""A slender silo by EN 1991-4, and a quantity of it at one depth."""

import numpy as np

from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call
from tests.test_pressure.bins import BIN

SLENDER = BIN | {"cylinder_depth": 12.0}


PROPERTIES = ("internal_friction_angle", "wall_friction", "lateral_pressure_ratio", "a_phi", "a_K", "a_mu")


def value(quantity, phase="filling", method="en1991_4", z=6.0, **changed):
    return float(call(PRESSURE[method].phases[phase][quantity], np.float64(z), SLENDER | changed))
