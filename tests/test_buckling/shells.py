"""Shells that several tests share."""

import numpy as np

STEEL = {
    "youngs_modulus": 210e9,
    "shell_poisson_ratio": 0.3,
    "yield_stress": 235e6,
    "shell_radius": 5.0,
    "thickness": 0.01,
    "bay_length": 4.0,
    "total_length": np.nan,
    "ring_area": 0.0,
    "fabricated": True,
    "safe_constants": False,
    "fabrication_quality": 25.0,
    "end_factor": 1.0,
    "lower_internal_pressure": 0.0,
    "upper_internal_pressure": 0.0,
}


def shell(**changes) -> dict:
    """Parameters of a steel shell, R/t = 500, with changes."""
    assert set(changes) <= set(STEEL)
    return {**STEEL, **{name: np.asarray(value) for name, value in changes.items()}}
