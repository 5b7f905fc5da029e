"""Differences between plane and space: a table of functions that the passes of a kernel close over.

Passes are written once for any dimension; another is a second table like `plane.PLANE`.
"""

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True, repr=False)
class Dimension:
    """The shapes of its arrays, its functions, and factories of functions where a piece may be left out."""

    key: str
    body: str  # what a grain is called
    bodies: type  # Discs or Spheres
    place: tuple[int, ...]  # numbers of a row
    velocity: tuple[int, ...]
    spin: tuple[int, ...]
    force: tuple[int, ...]
    torque: tuple[int, ...]
    row: int  # numbers in a row, whole cache lines
    inverse_inertia: float  # of a body, times mass and square of radius
    stretch: int  # contacts whose forces are computed together
    ahead: float  # steps that a list of near contacts should last at the speed of its bodies
    lanes: tuple[int, int]  # of relative motion
    forces: tuple[int, int]  # lanes of force
    components: int  # of a history
    felt: Callable  # model -> number of components of what a wall feels
    gather: Callable  # apart -> lanes of the relative motion of pairs, with the difference of their spins or without
    gather_walls: Callable  # moving -> the same of bodies near walls
    scatter: Callable  # apart -> adds forces to pairs, with a torque for each body or the same for both
    scatter_walls: Callable
    note_walls: Callable  # what walls feel
    wall_power: Callable  # (rows, shape, i, wall, force, moment) -> power of a wall that moves
    rise: int  # column of a wall's shape: its speed upward
    height_of: Callable  # (shape, wall) -> height of a level wall (m)
    motion_of: Callable  # shape -> of every wall its height where it is level (m), speed upward (m/s), how it turns or runs
    handed_on: (
        Callable  # (now, begun, here) -> rows of a floor with what is open of another, which go on for which, what is lost
    )
    widen: Callable  # (shape, wall, dt) -> whether the holes that grow in a wall have taken it away
    lift: Callable  # (shape, wall, way): moves a level wall up
    run: Callable  # (shape, walls, speed or velocity): lets the faces of straight walls run along them, m/s
    walls_of: Callable  # the walls of a model as arrays
    cell_count: Callable  # how many cells the walls of a model have
    extents: Callable  # walls -> of each the corners (n, d) of a box around it, m
    beside: Callable  # (walls, places) -> which places stand beside what the walls surround
    densest: Callable  # -> places (n, d) of the densest packing about the origin, in radii
    all_from_wall: Callable  # (walls, wall, places) -> vectors (n, d; m) from a wall's nearest points to places
    passed: tuple[int, ...]  # lanes in which rows count the steps that bodies have been below the outlets; none: they are not
    nearest: Callable  # (walls, wall, *place) -> vector (m) from a wall's nearest point to a place, then what else it finds
    bent: Callable  # (walls, wall, *place) -> curvature (1/m) of a wall at its point nearest to a place
    force_of: Callable  # (lanes of force, k) -> force on the first body
    facing: Callable  # (lanes, k) -> normal, distance (m)
    reduced: Callable  # flat -> (lanes, k, a, b) -> reduced radius (m)
    rates: Callable  # unequal -> (lanes, k, normal, a, b, depth, flat) -> closing, sliding (m/s), difference of spins (1/s)
    carry: Callable  # (history, normal) -> the history as the contact stands now
    twisting: Callable  # (lanes, k, normal) -> difference of spins about the normal (1/s)
    about: Callable  # (moment, twist, normal) -> the moment with another about the normal
    whole: Callable  # (push, drag, normal) -> force on the first body
    put: Callable  # drags, brakes, apart -> (out, k, normal, push, drag, moment, a, b, depth, flat): lanes of force
    where: Callable  # (touching, drag or moment) -> it, or nothing
    walk: Callable  # gathered, contact, unequal, laws, key -> function of a stretch of a list
    move: Callable  # advance, holds, turns, unequal -> function that moves a block and writes the square of each way (m2)
    pushed: Callable  # (gravity, quake, step) -> acceleration (m/s2) of bodies in an accelerated box

    def __repr__(self) -> str:
        return self.key  # the same in every process: kept kernels are named by it

    @property
    def ways(self) -> int:
        """Number of directions."""
        return len(self.place)

    @property
    def motion(self) -> int:
        """Numbers of a row that are place, velocity and spin; they come first."""
        return len(self.place) + len(self.velocity) + len(self.spin)
