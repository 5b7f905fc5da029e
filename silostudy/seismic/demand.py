"""Seismic demand on the wall: internal forces of the beam and the contents' additional pressure, over height."""

from dataclasses import dataclass
from math import pi

import numpy as np

from silostudy.seismic.beam import Tube, modes
from silostudy.seismic.en1998_4 import wall_pressure
from silostudy.seismic.records import Record
from silostudy.seismic.response import absolute_acceleration, internal_forces, refined
from silostudy.tables.constants import STANDARD_GRAVITY

MODES_SEEN = 3  # modes whose true peaks the refined step resolves; higher ones hardly move the base forces


@dataclass(frozen=True)
class Demand:
    """True peaks over time, at heights above the base; the pressure is EN 1998-4's at the peak accelerations."""

    shear_force: np.ndarray  # N
    bending_moment: np.ndarray  # N m
    axial_wall_force: np.ndarray  # N m-1, compression where the moment presses
    acceleration: np.ndarray  # m s-2, absolute
    wall_pressure: np.ndarray  # Pa, in the direction of motion
    top_peak: float  # m s-2, true
    top_peak_sampled: float  # m s-2, at the record's own samples


def axial_wall_force(bending_moment, *, radius):
    """Largest axial force per metre of perimeter (N/m) of a thin tube of mid-wall radius (m) under a bending moment (N m)."""
    return bending_moment / (pi * radius**2)


def demand(tube: Tube, stiffness_reduction: float, coefficient: float, damping_ratio: float, base: Record, height) -> Demand:
    """Demand at heights (m) above the base on a tube whose contents take part with `coefficient`."""
    height = np.asarray(height, dtype=float)
    shapes = modes(tube, coefficient, stiffness_reduction, heights=np.append(height, tube.height))
    fine, dt = refined(base.acceleration, base.dt, shapes.frequency[MODES_SEEN - 1])
    shear, moment = (np.abs(part).max(axis=-1)[:-1] for part in internal_forces(fine, dt, shapes, damping_ratio))
    history = absolute_acceleration(fine, dt, shapes, damping_ratio)
    peaks = np.abs(history).max(axis=-1)
    parts = round(base.dt / dt)
    pressure = wall_pressure(
        height,
        acceleration=peaks[:-1],
        unit_weight=tube.contents_density * STANDARD_GRAVITY,
        contents_height=tube.fill_height,
        diameter=2 * tube.radius - tube.thickness,
    )
    line_force = axial_wall_force(moment, radius=tube.radius)
    sampled = float(np.abs(history[-1, ::parts]).max())
    return Demand(shear, moment, line_force, peaks[:-1], pressure, float(peaks[-1]), sampled)
