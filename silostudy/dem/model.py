"""What the engine is asked to step: discs, walls, laws with their coefficients, and the march. Checked when it is made."""

from dataclasses import dataclass
from functools import cached_property
from math import isfinite, pi

import numpy as np

from silostudy.contact import COHESION, NORMAL, ROLLING, TANGENTIAL
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.pieces import Laws, Pieces
from silostudy.errors import BadInput, unknown

TINY = 1e-200  # kg m: beyond it and its inverse, squares of what the engine computes with leave the range of numbers


@dataclass(frozen=True)
class Wall:
    """A straight wall from start to end (m), the solid on its left; `cells` equal parts have their force recorded.

    An end that is joined to another wall does not push as a point.
    """

    name: str
    start: tuple[float, float]
    end: tuple[float, float]
    cells: int = 1
    live: bool = True
    joined: tuple[bool, bool] = (False, False)

    def __post_init__(self):
        if not all(isfinite(value) for value in (*self.start, *self.end)):
            raise BadInput(self.name, (self.start, self.end), "the ends of a wall must be finite")
        if self.start == self.end:
            raise BadInput(self.name, self.start, "a wall must have a length")
        if self.cells < 1:
            raise BadInput(f"{self.name}.cells", self.cells, "must be 1 or more")


@dataclass(frozen=True)
class Contact:
    """The laws between two bodies and their coefficients by name, SI per metre thickness."""

    laws: Laws
    coefficients: dict[str, float]

    def __post_init__(self):
        needed = {name for row in self.rows for name in row.coefficients}
        for name in sorted(needed ^ self.coefficients.keys()):
            state = "missing" if name in needed else "unknown"
            raise BadInput(name, self.coefficients.get(name), f"{state}; these laws take {', '.join(sorted(needed))}")
        for name, value in self.coefficients.items():
            if not (isfinite(value) and (value > 0.0 or (value == 0.0 and not name.endswith("normal_stiffness")))):
                raise BadInput(name, value, "must be positive" if "stiffness" in name else "must be zero or more")

    @staticmethod
    def families(laws: Laws):
        """Rows of the four laws."""
        return NORMAL[laws.normal], TANGENTIAL[laws.tangential], ROLLING[laws.rolling], COHESION[laws.cohesion]

    @property
    def rows(self):
        """Rows of this contact's laws."""
        return self.families(self.laws)

    @cached_property
    def ordered(self) -> tuple[tuple[float, ...], ...]:
        """Coefficients of the four laws in the order that their functions take."""
        return tuple(tuple(float(self.coefficients[name]) for name in row.coefficients) for row in self.rows)


@dataclass(frozen=True, eq=False)
class Model:
    """Discs (m, m/s, kg/m3), walls, contacts, gravity (m/s2), base acceleration a step (m/s2), integrator and step (s)."""

    x: np.ndarray
    y: np.ndarray
    radius: np.ndarray
    density: float
    walls: tuple[Wall, ...]
    pair: Contact
    wall: Contact
    dt: float
    gravity: tuple[float, float]
    integrator: str = "17-18"
    quake: np.ndarray | None = None
    watched: bool = False
    booked: bool = False
    u: np.ndarray | None = None
    v: np.ndarray | None = None
    w: np.ndarray | None = None

    def __post_init__(self):
        for name in ("x", "y", "radius", "u", "v", "w"):
            value = getattr(self, name)
            if value is not None:
                value = np.broadcast_to(np.asarray(value, float), np.shape(self.x))
                object.__setattr__(self, name, value)
                if not np.isfinite(value).all():
                    raise BadInput(name, float(value[~np.isfinite(value)][0]), "must be finite")
        for name in ("gravity", "quake"):
            if getattr(self, name) is not None and not np.isfinite(getattr(self, name)).all():
                raise BadInput(name, getattr(self, name), "must be finite")
        for name, value in (("density", self.density), ("dt", self.dt), ("radius", float(np.min(self.radius, initial=1.0)))):
            if not (isfinite(value) and value > 0.0):
                raise BadInput(name, value, "must be positive")
        if not len(self.x):
            raise BadInput("x", len(self.x), "a scene needs a disc at least")
        with np.errstate(over="ignore", under="ignore"):
            inertia = self.mass * self.radius**2
        if not ((inertia > TINY) & (inertia < 1.0 / TINY)).all():
            allowed = f"its mass and inertia must be numbers between {TINY:g} and {1.0 / TINY:g}"
            raise BadInput("radius", float(self.radius[np.argmax(np.abs(np.log(self.radius)))]), allowed)
        INTEGRATORS[self.integrator]
        names = [wall.name for wall in self.walls]
        if len(set(names)) < len(names):
            raise BadInput("walls", names, "each wall needs a name of its own")
        if self.unequal and "line-contact" in (self.pair.laws.normal, self.wall.laws.normal):
            raise BadInput("normal", "line-contact", "the curve is for discs of one size")

    def wall_number(self, name: str) -> int:
        """Number of the wall of a name, as contacts count walls; BadInput for a name that no wall has."""
        names = [wall.name for wall in self.walls]
        if name not in names:
            raise unknown("wall", name, names)
        return names.index(name)

    def wall_named(self, name: str) -> Wall:
        """The wall of a name."""
        return self.walls[self.wall_number(name)]

    @property
    def unequal(self) -> bool:
        return bool(np.ptp(self.radius) > 0.0)

    @property
    def mass(self) -> np.ndarray:
        """Mass of each disc (kg/m)."""
        return self.density * pi * self.radius**2

    @property
    def pieces(self) -> Pieces:
        """What these contents call for."""
        return Pieces(
            pair=self.pair.laws,
            wall=self.wall.laws,
            integrator=self.integrator,
            unequal=self.unequal,
            shaken=self.quake is not None,
            watched=self.watched,
            booked=self.booked,
        )
