"""Response of the tube's modes to motion of its base: steady sine and time history, without a time-step error.

A damped mode is the imaginary part of a complex number that turns and decays, y' = s y + f.  For a force that is linear
between samples this has an exact recursion with one pole, the piecewise exact method of Nigam and Jennings in other
words.  The step then only says how often the exact response is looked at.
"""

from math import ceil, pi

import numpy as np
from scipy.signal import lfilter

from silostudy.seismic.beam import Modes

POINTS_PER_PERIOD = 40  # a peak seen at so many points of a period is low by at most 1 - cos(pi/40) = 0.3 %


def transfer(frequency, modes: Modes, damping_ratio: float) -> np.ndarray:
    """Absolute acceleration over base acceleration (1, complex) in a steady sine of `frequency` (Hz): (frequency, position)."""
    turning = np.asarray(frequency, dtype=float)[:, None]
    natural = modes.frequency
    carried = natural**2 + 2j * damping_ratio * natural * turning
    gain = carried / (carried - turning**2)
    weights = modes.displacement * modes.participation
    return gain @ weights.T + (1 - weights.sum(axis=1))


def oscillators(acceleration, dt: float, frequency, damping_ratio: float) -> tuple[np.ndarray, np.ndarray]:
    """Relative displacement (m) and velocity (m s-1) of oscillators of natural `frequency` (Hz) on a moving base: (mode, time).

    Exact for base acceleration (m s-2) that is linear between samples; at rest at the first sample.
    Source: nigam_jennings_1969 (the method; the recursion here is its complex form).
    """
    natural = 2 * pi * np.asarray(frequency, dtype=float)
    damped = natural * np.sqrt(1 - damping_ratio**2)
    pole = natural * (-damping_ratio) + 1j * damped
    first, second = _weights(pole * dt)
    force = -np.asarray(acceleration, dtype=complex)
    turning = np.empty((len(natural), len(force)), dtype=complex)
    for mode, z in enumerate(pole * dt):
        now, before = dt * second[mode], dt * (first[mode] - second[mode])
        turning[mode], _ = lfilter([now, before], [1, -np.exp(z)], force, zi=[-now * force[0]])
    return turning.imag / damped[:, None], (pole[:, None] * turning).imag / damped[:, None]


def _weights(z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Weights (e^z - 1)/z and (e^z - 1 - z)/z^2; the second by its series where the difference would cancel."""
    series = sum(z**k * (1 / np.prod(np.arange(1.0, k + 3))) for k in range(10))
    return np.expm1(z) / z, np.where(np.abs(z) < 0.3, series, (np.expm1(z) - z) / z**2)


def absolute_acceleration(acceleration, dt: float, modes: Modes, damping_ratio: float) -> np.ndarray:
    """Absolute acceleration (m s-2) of the tube at the modes' positions: (position, time)."""
    q, velocity = oscillators(acceleration, dt, modes.frequency, damping_ratio)
    natural = 2 * pi * modes.frequency[:, None]
    carried = natural**2 * q + 2 * damping_ratio * natural * velocity
    weights = modes.displacement * modes.participation
    rest = 1 - weights.sum(axis=1)
    return -weights @ carried + rest[:, None] * np.asarray(acceleration)


def internal_forces(acceleration, dt: float, modes: Modes, damping_ratio: float) -> tuple[np.ndarray, np.ndarray]:
    """Shear force (N) and bending moment (N m) in the wall at the modes' positions: each (position, time)."""
    q, _ = oscillators(acceleration, dt, modes.frequency, damping_ratio)
    shear = modes.shear_stiffness * (modes.shear_angle * modes.participation) @ q
    return shear, modes.bending_stiffness * (modes.curvature * modes.participation) @ q


def refined(acceleration, dt: float, highest_frequency: float) -> tuple[np.ndarray, float]:
    """The same base motion, linear between its samples, at a step that shows true peaks up to `highest_frequency` (Hz)."""
    parts = max(1, ceil(dt * highest_frequency * POINTS_PER_PERIOD))
    count = len(acceleration)
    fine = np.interp(np.arange((count - 1) * parts + 1) / parts, np.arange(count), acceleration)
    return fine, dt / parts
