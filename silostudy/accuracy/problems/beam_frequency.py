"""First and fifth frequency of a tube over the degree and the number of its elements."""

import numpy as np
from scipy.optimize import brentq

from silostudy.seismic.beam import Tube, modes, second_moment, section_area

DEGREES = (3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 23)
LADDERS = {
    "one element, its degree": DEGREES,
    "elements of degree 1": (4, 8, 16, 32, 64),
    "elements of degree 2": (2, 4, 8, 16, 32),
    "elements of degree 4": (1, 2, 4, 8, 16),
}
TUBE = Tube(
    radius=0.25, thickness=0.015, height=1.08, fill_height=1.08, wall_density=2350.0, youngs_modulus=25e9,
    poisson_ratio=0.2, shear_factor=0.5, contents_density=790.0,
)  # fmt: skip
SCAN = np.arange(0.5, 60.0, 0.01)


def prepare(ladder: str, setting: float):
    """The modes of the empty tube."""
    degree = int(setting) if ladder.startswith("one") else int(ladder.split()[-1])
    elements = 1 if ladder.startswith("one") else int(setting)

    def run():
        frequency = modes(TUBE, 0.0, degree=degree, elements=elements).frequency
        return {"first_frequency": frequency[0], "fifth_frequency": frequency[4]}

    return run


def reference():
    """Roots of the closed frequency equation of a Timoshenko cantilever; its derivation is not in the sources at hand."""
    size = {"radius": TUBE.radius, "thickness": TUBE.thickness}
    area, inertia = section_area(**size), second_moment(**size)
    bending = TUBE.youngs_modulus * inertia
    shearing = TUBE.shear_factor * TUBE.youngs_modulus / (2 * (1 + TUBE.poisson_ratio)) * area
    r, s = np.sqrt(inertia / area) / TUBE.height, np.sqrt(bending / shearing) / TUBE.height
    values = np.array([_equation(b, r, s) for b in SCAN])
    places = np.flatnonzero(values[1:] * values[:-1] < 0)
    roots = np.array([brentq(_equation, SCAN[k], SCAN[k + 1], args=(r, s), xtol=1e-13, rtol=1e-14) for k in places[:5]])
    frequency = roots * np.sqrt(bending / (TUBE.wall_density * area * TUBE.height**4)) / (2 * np.pi)
    return {"first_frequency": frequency[0], "fifth_frequency": frequency[4]}


def _equation(b: float, r: float, s: float) -> float:
    """Zero at the natural frequencies: b^2 = rho A L^4 omega^2 / EI, r^2 = I / A L^2, s^2 = EI / k G A L^2."""
    root = np.sqrt(complex((r**2 - s**2) ** 2 + 4 / b**2))
    alpha, beta = np.sqrt((root - r**2 - s**2) / 2), np.sqrt((root + r**2 + s**2) / 2)
    value = 2 + (b**2 * (r**2 - s**2) ** 2 + 2) * np.cosh(b * alpha) * np.cos(b * beta)
    value -= b * (r**2 + s**2) / np.sqrt(complex(1 - b**2 * r**2 * s**2)) * np.sinh(b * alpha) * np.sin(b * beta)
    return float(value.real)
