"""Model that the engine steps in space: spheres, surfaces, laws, time stepping."""

from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import ClassVar

import numpy as np

from silostudy.dem.dimension import Dimension
from silostudy.dem.model import Model
from silostudy.dem.space.dimension import SPACE
from silostudy.dem.space.walls import Surface, TurnedLine
from silostudy.errors import BadInput


@dataclass(frozen=True, eq=False, kw_only=True)
class SphereModel(Model):
    """Spheres (m, m/s, rad/s, kg/m3), surfaces, contacts, gravity and base acceleration (three components, m/s2), march.

    u, v, w are velocities and p, q, r spins here.
    """

    space: ClassVar[Dimension] = SPACE
    columns: ClassVar[tuple[str, ...]] = ("x", "y", "z", "radius", "u", "v", "w", "p", "q", "r")

    z: np.ndarray
    walls: tuple[Surface, ...]  # type: ignore[assignment]  # surfaces stand where a plane has walls
    p: np.ndarray | None = None
    q: np.ndarray | None = None
    r: np.ndarray | None = None

    def __post_init__(self):
        super().__post_init__()
        if len(self.gravity) != 3:
            raise BadInput("gravity", self.gravity, "must have three components (m/s2)")

    @staticmethod
    def level_wall(half: float, height: float) -> TurnedLine:
        """A level disc of a radius at a height (m)."""
        return TurnedLine(name="floor", start=(0.0, height), end=(half, height))

    @property
    def place(self) -> np.ndarray:
        """Place (n, 3) of the centres, m."""
        return np.stack([self.x, self.y, self.z], axis=-1)

    @property
    def velocity(self) -> np.ndarray:
        """Velocity (n, 3) at the start, m/s."""
        return self._started(self.u, self.v, self.w)

    @property
    def spin(self) -> np.ndarray:
        """Spin (n, 3) at the start, rad/s."""
        return self._started(self.p, self.q, self.r)

    @cached_property
    def mass(self) -> np.ndarray:
        """Mass of each sphere (kg)."""
        return self.density * (4.0 / 3.0) * pi * self.radius**3
