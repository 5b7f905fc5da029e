"""Model that the engine steps: discs, walls, laws with their coefficients, time stepping. It is checked when it is made."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from math import dist, inf, isfinite, pi
from typing import Any, ClassVar

import numpy as np

from silostudy.dem.contacts import Contact
from silostudy.dem.dimension import Dimension
from silostudy.dem.integrate import INTEGRATORS, PLAIN
from silostudy.dem.pace import FIXED, Pace
from silostudy.dem.pieces import Pieces
from silostudy.dem.plane import PLANE
from silostudy.dem.varied import Varied, set_at_wall, set_of_pair
from silostudy.dem.walls import GROWTH, OWN, REACH, draw_back
from silostudy.errors import BadInput, unknown

FLOOR = "floor"  # name of the floor, or before a number that of its pieces
TINY = 1e-200  # kg m: beyond it and its inverse, squares of what the engine computes with leave the range of numbers


@dataclass(frozen=True)
class FloorPiece:
    """A piece of a floor: where the floor starts (m), and how far from there (m) the piece reaches while the outlets are shut
    whose names `outlets` has, a name for each end or none: to seams, where it goes straight on in the piece beside it."""

    origin: tuple[float, float]
    seams: tuple[float, float]
    outlets: tuple[str, str]


@dataclass(frozen=True)
class Wall:
    """A straight wall from start to end (m), the solid on its left; `cells` equal parts have their force recorded.

    An end that is joined to another wall does not push as a point.  faces: 2 for a line whose back has cells of its own; what
    its ends meet is found (see `joints`).  stays: whether it stands to the end, so that lines may be joined to it.
    floor: what it is of a floor of several pieces.
    """

    name: str
    start: tuple[float, float]
    end: tuple[float, float]
    cells: int = 1
    live: bool = True
    joined: tuple[bool, bool] = (False, False)
    faces: int = 1
    stays: bool = True
    floor: FloorPiece | None = None

    def __post_init__(self):
        if not all(isfinite(value) for value in (*self.start, *self.end)):
            raise BadInput(self.name, (self.start, self.end), "the ends of a wall must be finite")
        if self.start == self.end:
            raise BadInput(self.name, self.start, "a wall must have a length")
        if self.cells < 1:
            raise BadInput(f"{self.name}.cells", self.cells, "must be 1 or more")

    @property
    def outlets(self) -> tuple[str, ...]:
        """Names of the outlets at its ends, of a piece of a floor."""
        return self.floor.outlets if self.floor else ()

    @property
    def reach(self) -> tuple[float, float]:
        """Least and largest distance (m) from its own start to which it reaches with outlets shut."""
        start = dist(self.floor.origin, self.start) if self.floor else 0.0
        begin, end = self.floor.seams if self.floor else (0.0, dist(self.start, self.end))
        return begin - start, end - start

    def narrow(self, row: np.ndarray) -> tuple[str, ...]:
        """Names of the outlets at its ends that it reaches into yet, by its row."""
        return tuple(name for end, name in enumerate(self.outlets) if name and row[REACH + end] != row[OWN + end])

    def opened(self, row: np.ndarray, names: tuple[str, ...], speed: float = 0.0) -> None:
        """Draw it back, in its row, from outlets of these names: at once, or at a speed (m/s) of their width."""
        for end, name in enumerate(self.outlets):
            if name and name in names:
                row[GROWTH + end] = speed / 2.0
                draw_back(row[None], 0, end, 0.0 if speed else inf)


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
    """Discs (m, m/s, kg/m3), walls, contacts, gravity (m/s2), base acceleration a tick (m/s2), integrator and step (s).

    waiting: so many of the last are not there at the start; they come in while the model runs.  moving: whether walls move.
    kind: of each disc, counted from 0, by which contacts differ that are varied; None: all are of one.
    dt: of a tick of the clock, of which the pace makes a step: one, where steps do not follow the contacts.
    end: where an earlier run ended (see `branch`), from which a run of the model goes on; None: it starts.
    """

    space: ClassVar[Dimension] = PLANE
    columns: ClassVar[tuple[str, ...]] = ("x", "y", "radius", "u", "v", "w")

    x: np.ndarray
    y: np.ndarray
    radius: np.ndarray
    density: float | np.ndarray  # of all, or of each
    walls: tuple[Wall, ...]
    pair_contact: Contact | Varied
    wall_contact: Contact | Varied
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
    kind: np.ndarray | None = None
    end: Mapping[str, Any] | None = None
    pace: Pace = FIXED

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
        least = {"density": float(np.min(self.density)), "dt": self.dt, "radius": float(np.min(self.radius, initial=1.0))}
        for name, value in least.items():
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
        for name in ("pair_contact", "wall_contact"):
            laws = getattr(self, name).laws
            for family, law in vars(laws).items():
                if law.acts and f"{self.space.body}s" not in law.grains:
                    told = f"is a law of {' and '.join(law.grains)}, not of {self.space.body}s"
                    raise BadInput(f"{name}.{family}", law.key, told)
            if self.unequal and laws.normal.one_size:
                raise BadInput(f"{name}.normal", laws.normal.key, "the curve is for discs of one size")
        self._check_sets()

    def _check_sets(self) -> None:
        """BadInput for bodies without a kind where pairs differ, and where contacts are not as many as pairs of kinds, or as
        kinds at walls."""
        if self.kind is not None and not (np.shape(self.kind) == np.shape(self.x) and np.min(self.kind) >= 0):
            raise BadInput("kind", np.shape(self.kind), f"must be a number from 0 for each {self.space.body}")
        if self.kind is None and isinstance(self.pair_contact, Varied):
            raise BadInput("kind", None, f"must be given for each {self.space.body}: contacts of pairs differ")
        for name, contact, many in (
            ("pair_contact", self.pair_contact, set_of_pair(self.kinds - 1, self.kinds - 1) + 1),
            ("wall_contact", self.wall_contact, self.kinds * len(self.walls)),
        ):
            if isinstance(contact, Varied) and len(contact.sets) != many:
                raise BadInput(name, len(contact.sets), f"must be {many} sets of coefficients")

    def wall_number(self, name: str) -> int:
        """Number of the wall of a name, as contacts count walls; BadInput for a name that no wall has."""
        names = [wall.name for wall in self.walls]
        if name not in names:
            raise unknown("wall", name, names)
        return names.index(name)

    def wall_named(self, name: str) -> Wall:
        """The wall of a name."""
        return self.walls[self.wall_number(name)]

    def between(self, kind: int, other: int) -> Contact:
        """Contact between bodies of two kinds."""
        return self.pair_contact.numbered(set_of_pair(kind, other))

    def at_wall(self, kind: int, wall: int) -> Contact:
        """Contact of bodies of a kind at the wall of a number."""
        return self.wall_contact.numbered(set_at_wall(kind, wall, len(self.walls)))

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
    def step(self) -> float:
        """Time step (s) that a run begins with."""
        return self.pace.ticks * self.dt

    @property
    def unequal(self) -> bool:
        """Whether the discs differ in radius or in mass."""
        return bool(np.ptp(self.radius) > 0.0 or np.ptp(self.density) > 0.0)

    @property
    def kinds(self) -> int:
        """Number of kinds of discs."""
        return 1 if self.kind is None else int(np.max(self.kind)) + 1

    @property
    def gap(self) -> float:
        """Gap (m) across which any two bodies that have touched may hold on; a bent wall at most doubles a body's radius."""
        largest = float(self.radius.max())
        return max(self.pair_contact.gap(0.5 * largest), self.wall_contact.gap(2.0 * largest))

    @cached_property
    def mass(self) -> np.ndarray:
        """Mass of each disc (kg/m)."""
        return self.density * pi * self.radius**2

    @property
    def pieces(self) -> Pieces:
        """Pieces of a kernel that these contents call for."""
        return Pieces(
            space=self.space,
            pair_laws=self.pair_contact.laws,
            wall_laws=self.wall_contact.laws,
            integrator=self.integrator,
            unequal=self.unequal,
            shaken=self.quake is not None,
            watched=self.watched or self.moving,
            booked=self.booked,
            varied=(isinstance(self.pair_contact, Varied), isinstance(self.wall_contact, Varied)),
            moving=self.moving,
        )
