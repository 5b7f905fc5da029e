"""An oscillator shaken from rest, over the time step: the exact recursion, and Newmark's method beside it."""

from math import pi

import numpy as np
from scipy.signal import bilinear, lfilter

from silostudy.seismic.response import oscillators

NATURAL = 19.0  # Hz, of the oscillator
DAMPING = 0.03  # of critical damping
SHAKING = 7.0  # Hz, of the ground
DURATION = 2.0  # s
STEPS = tuple(0.02 / 2**k for k in range(10))
LADDERS = {"exact recursion": STEPS, "Newmark, mean acceleration": STEPS}


def _base(dt: float) -> np.ndarray:
    return np.sin(2 * pi * SHAKING * np.arange(round(DURATION / dt) + 1) * dt)


def prepare(ladder: str, setting: float):
    """Relative displacement (m) of one oscillator under 1 m/s2; the base motion is known at the steps only."""
    base, omega = _base(setting), 2 * pi * NATURAL

    def run():
        if ladder == "exact recursion":
            response = oscillators(base, setting, [NATURAL], DAMPING)[0][0]
        else:  # the mean-acceleration method is the trapezoidal rule, which is the bilinear transform of the oscillator
            response = lfilter(*bilinear([-1.0], [1.0, 2 * DAMPING * omega, omega**2], 1 / setting), base)
        return {"displacement": response[:: round(STEPS[0] / setting)], "peak": np.abs(response).max()}

    return run


def reference():
    """Steady sine and transient, at the coarsest steps; the peak from a fine look at the same formula."""
    return {"displacement": _exact(_times(STEPS[0])), "peak": np.abs(_exact(_times(STEPS[0] / 4096))).max()}


def _times(dt: float) -> np.ndarray:
    return np.arange(round(DURATION / dt) + 1) * dt


def _exact(t: np.ndarray) -> np.ndarray:
    """Solution of q'' + 2 zeta w q' + w^2 q = -sin(W t), q = q' = 0 at t = 0, with its coefficients by hand."""
    w, forced = 2 * pi * NATURAL, 2 * pi * SHAKING
    below = (w**2 - forced**2) ** 2 + (2 * DAMPING * w * forced) ** 2
    sine, cosine = -(w**2 - forced**2) / below, 2 * DAMPING * w * forced / below
    damped = w * np.sqrt(1 - DAMPING**2)
    first = -cosine
    second = -(sine * forced + DAMPING * w * cosine) / damped
    free = np.exp(-DAMPING * w * t) * (first * np.cos(damped * t) + second * np.sin(damped * t))
    return sine * np.sin(forced * t) + cosine * np.cos(forced * t) + free
