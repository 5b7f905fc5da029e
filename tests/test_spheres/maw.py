"""Oblique elastic impact of a sphere and a half-space of one material, apart from the package: ring by ring.

The contact is a row of independent springs, as the method of dimensionality reduction has it: it gives Hertz's force, Mindlin's
stiffness without slip and the partial slip from the edge inwards exactly, which is the problem that Maw, Barber & Fawcett
(1976) solved with rings of traction.  Nothing here is read from their paper: the curve is computed.
"""

from math import sqrt

import numpy as np

SPRINGS = 400
STEPS = 4000


class Foundation:
    """Springs along a line under a sphere of a radius (m), of moduli E* and G* (Pa) and of a friction."""

    def __init__(self, radius, modulus, shear, friction, reach):
        self.x = (np.arange(SPRINGS) + 0.5) / SPRINGS * reach
        self.width = 2.0 * reach / SPRINGS  # both sides of the middle
        self.radius, self.modulus, self.shear, self.friction = radius, modulus, shear, friction
        self.stretch = np.zeros(SPRINGS)

    def normal(self, overlap):
        """Normal force (N) at an overlap (m)."""
        return self.modulus * self.width * np.maximum(overlap - self.x**2 / self.radius, 0.0).sum()

    def tangential(self, overlap, increment):
        """Tangential force (N) after the sphere's surface has moved on by an increment (m)."""
        cap = self.friction * self.modulus * np.maximum(overlap - self.x**2 / self.radius, 0.0) / (4.0 * self.shear)
        self.stretch = np.clip(self.stretch + increment, -cap, cap)
        return -4.0 * self.shear * self.width * self.stretch.sum()


def rebound(radius, mass, modulus, shear, friction, across, down):
    """Speed (m/s) of a sphere's surface along the half-space after an impact without spin."""
    deepest = (15.0 * mass * down**2 / (16.0 * modulus * sqrt(radius))) ** 0.4
    foundation = Foundation(radius, modulus, shear, friction, 1.05 * sqrt(radius * deepest))
    dt = 2.87 * (mass**2 / (radius * modulus**2 * down)) ** 0.2 / STEPS
    overlap, closing, surface = 0.0, down, across
    while overlap >= 0.0:
        closing -= foundation.normal(overlap) / mass * dt
        overlap += closing * dt
        surface += 3.5 * foundation.tangential(overlap, surface * dt) / mass * dt  # its translation, and 5/2 of it by its spin
    return surface
