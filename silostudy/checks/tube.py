"""The wall as a tube that a transverse load bends: wind and patch load, by statics; standing on its foot, free at the top."""

import numpy as np

# harmonics of the wind's pressure round a closed cylinder, inwards positive: two copies of AS/NZS 1170.2, App. C, at c/b = 1
WIND_HARMONICS = {1: 0.4, 2: 0.8, 3: 0.3, 4: -0.1, 5: -0.05}


def ring_forces(moment, shear, radius):
    """Axial force and shear (N/m), each the largest round a thin tube: M/(pi r^2), V/(pi r). Source: statics."""
    return moment / (np.pi * radius**2), shear / (np.pi * radius)


def wind_forces(depth, *, pressure, force_coefficient, diameter):
    """Moment (N m) and shear (N) of a tube at a depth (m) below its top, in wind that is even over the height.

    Source: statics: c_f q d z^2/2, c_f q d z; the roof's own wind is left out.
    """
    shear = force_coefficient * pressure * diameter * depth
    return shear * depth / 2, shear


def patch_forces(depth, *, resultant, middle, height):
    """Moment (N m) and shear (N) of a tube at a depth (m) by a patch load (N) spread evenly over a height (m).

    Source: en1991_4_2006 for the patch, two public programs; statics: F (z - z_p) below it.
    """
    within = np.clip(depth - (middle - height / 2), 0.0, height)
    shear = resultant * within / height
    return np.where(within < height, shear * within / 2, resultant * (depth - middle)), shear


def wind_lift(*, pressure, height, radius, top_held):
    """Tension (N/m) at the windward foot beside what bending of the tube gives: the harmonics from 2 on, by membrane theory.

    Source: derived from mechanics: q L^2/(2 r) kappa sum m^2 C_m, kappa 1 for a free top, 1/4 where it is held round.  Many
    times what bending gives; less for walls that are slender and stiff.
    """
    harmonics = sum(m**2 * value for m, value in WIND_HARMONICS.items() if m > 1)
    return pressure * height**2 / (2 * radius) * np.where(top_held, 0.25, 1.0) * harmonics
