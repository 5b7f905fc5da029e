"""Flow out of silos of grains by a law."""

import numpy as np

from silostudy.tables.constants import ROUNDED_GRAVITY


def beverloo(width, grain, density, constant: float, edge: float):
    """Mass flow (kg/s) through a round outlet: C rho_b sqrt(g) (D - k d)^(5/2). Source: mankoc_2007 (Beverloo's law)."""
    return constant * density * np.sqrt(ROUNDED_GRAVITY) * np.maximum(width - edge * grain, 0.0) ** 2.5
