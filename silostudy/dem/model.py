"""What the engine is asked to step: discs, walls, laws with their coefficients, and the march. Checked when it is made."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import inf, isfinite, pi
from typing import Any, ClassVar

import numpy as np

from silostudy.contact import NORMAL, Law
from silostudy.dem.dimension import Dimension
from silostudy.dem.integrate import INTEGRATORS, PLAIN
from silostudy.dem.pieces import Laws, Pieces
from silostudy.dem.plane import PLANE
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
        needed = {coefficient.name for row in self.rows for coefficient in row.coefficients}
        for name in sorted(self.coefficients.keys() - needed):
            raise BadInput(name, self.coefficients[name], f"unknown; these laws take {', '.join(sorted(needed))}")
        self.ordered  # noqa: B018  (each law looks at its own)
        if self.laws.cohesion.of_hertz and not self.laws.normal.of_hertz:
            fitting = ", ".join(key for key, row in NORMAL.items() if row.of_hertz)
            raise BadInput(
                "cohesion", self.laws.cohesion.key, f"stands on {fitting} as normal law, not on {self.laws.normal.key}"
            )

    @classmethod
    def taking(cls, laws: Laws, values: Mapping[str, float]) -> "Contact":
        """A contact with those of the values that its laws take."""
        needed = {coefficient.name for row in laws.rows for coefficient in row.coefficients}
        return cls(laws, {name: value for name, value in values.items() if name in needed})

    @property
    def rows(self) -> tuple[Law, ...]:
        """Rows of the laws."""
        return self.laws.rows

    @cached_property
    def ordered(self) -> tuple[tuple[float, ...], ...]:
        """Coefficients of the laws in the order that their functions take."""
        return tuple(row.ordered(self.coefficients) for row in self.rows)

    def gap(self, radius: float) -> float:
        """Gap (m) across which two bodies that have touched hold on, of a reduced radius (m)."""
        return float(self.laws.cohesion.gap(radius, self.ordered[3]))

    def scaled(self, *, stiffness: float, damping: float) -> "Contact":
        """The same laws with springs and dashpots stronger by these factors."""
        powers = {one.name: (one.stiffness_power, one.damping_power) for row in self.rows for one in row.coefficients}
        changed = {
            name: value * (stiffness ** powers[name][0] * damping ** powers[name][1])
            for name, value in self.coefficients.items()
        }
        return replace(self, coefficients=changed)


@dataclass(frozen=True, kw_only=True)
class Lid:
    """A wall that may be pressed or moved: its name, area (m2; in the plane m), mass (kg, kg/m) and the most bodies it may
    touch at once; the mass is the least that it is given, infinite where it moves at a speed alone."""

    area: float
    touching: float
    mass: float = inf
    name: str = "lid"


@dataclass(frozen=True, eq=False)
class Model:
    """Discs (m, m/s, kg/m3), walls, contacts, gravity (m/s2), base acceleration a step (m/s2), integrator and step (s).

    waiting: so many of the last are not there at the start; they come in while the model runs.  moving: whether walls move.
    """

    space: ClassVar[Dimension] = PLANE
    columns: ClassVar[tuple[str, ...]] = ("x", "y", "radius", "u", "v", "w")

    x: np.ndarray
    y: np.ndarray
    radius: np.ndarray
    density: float
    walls: tuple[Wall, ...]
    pair_contact: Contact
    wall_contact: Contact
    dt: float
    gravity: tuple[float, ...]
    integrator: str = PLAIN.key
    quake: np.ndarray | None = None
    watched: bool = False
    booked: bool = False
    moving: bool = False
    lid: Lid | None = None
    u: np.ndarray | None = None
    v: np.ndarray | None = None
    w: np.ndarray | None = None
    waiting: int = 0

    def __post_init__(self):
        for name in self.columns:
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
            raise BadInput("x", len(self.x), f"a scene needs a {self.space.body} at least")
        with np.errstate(over="ignore", under="ignore"):
            inertia = self.mass * self.radius**2
        if not ((inertia > TINY) & (inertia < 1.0 / TINY)).all():
            allowed = f"its mass and inertia must be numbers between {TINY:g} and {1.0 / TINY:g}"
            raise BadInput("radius", float(self.radius[np.argmax(np.abs(np.log(self.radius)))]), allowed)
        INTEGRATORS[self.integrator]
        names = [wall.name for wall in self.walls]
        if len(set(names)) < len(names):
            raise BadInput("walls", names, "each wall needs a name of its own")
        for law in (*self.pair_contact.laws.rows, *self.wall_contact.laws.rows):
            if law.acts and f"{self.space.body}s" not in law.grains:
                raise BadInput("law", law.key, f"is a law of {' and '.join(law.grains)}, not of {self.space.body}s")
        for normal in (self.pair_contact.laws.normal, self.wall_contact.laws.normal):
            if self.unequal and normal.one_size:
                raise BadInput("normal", normal.key, "the curve is for discs of one size")

    def wall_number(self, name: str) -> int:
        """Number of the wall of a name, as contacts count walls; BadInput for a name that no wall has."""
        names = [wall.name for wall in self.walls]
        if name not in names:
            raise unknown("wall", name, names)
        return names.index(name)

    def wall_named(self, name: str) -> Wall:
        """The wall of a name."""
        return self.walls[self.wall_number(name)]

    @staticmethod
    def level_wall(half: float, height: float) -> Any:
        """A floor of a half width at a height (m)."""
        return Wall("floor", (-half, height), (half, height))

    @property
    def place(self) -> np.ndarray:
        """Place (n, 2) of the centres, m."""
        return np.stack([self.x, self.y], axis=-1)

    @property
    def velocity(self) -> np.ndarray:
        """Velocity (n, 2) at the start, m/s."""
        return self._started(self.u, self.v)

    @property
    def spin(self) -> np.ndarray:
        """Spin (n, 1) at the start, rad/s."""
        return self._started(self.w)

    def _started(self, *columns: np.ndarray | None) -> np.ndarray:
        still = np.zeros(len(self.x))
        return np.stack([still if column is None else column for column in columns], axis=-1)

    @property
    def unequal(self) -> bool:
        return bool(np.ptp(self.radius) > 0.0)

    @property
    def gap(self) -> float:
        """Gap (m) across which any two bodies that have touched may hold on; a bent wall at most doubles a body's radius."""
        largest = float(self.radius.max())
        return max(self.pair_contact.gap(0.5 * largest), self.wall_contact.gap(2.0 * largest))

    @property
    def mass(self) -> np.ndarray:
        """Mass of each disc (kg/m)."""
        return self.density * pi * self.radius**2

    @property
    def pieces(self) -> Pieces:
        """What these contents call for."""
        return Pieces(
            space=self.space,
            pair_laws=self.pair_contact.laws,
            wall_laws=self.wall_contact.laws,
            integrator=self.integrator,
            unequal=self.unequal,
            shaken=self.quake is not None,
            watched=self.watched or self.moving,
            booked=self.booked,
            moving=self.moving,
        )
