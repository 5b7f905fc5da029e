"""Silos in space for the tests, and the push of their surfaces on a sphere."""

from math import radians

import numpy as np
import pytest

from silostudy.dem.space.rows import FLAT, NEXT, OUT_OF_REACH
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import walls_of
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import FLOOR, Outlet, SpaceSilo

WIDE, DEEP, BALL, PRESSED = 0.2, 0.15, 0.01, 0.0098  # m: the silos, a sphere, and its distance from what it is pressed on
CONE = Hopper(half_angle=radians(30.0), outlet_width=0.08)


def silo(plan="circular", hopper=None, **changes) -> Silo:
    length, sides = (0.3 if plan == "rectangular" else 0.0), (6 if plan == "polygonal" else 0)
    return Silo(**({"plan": plan, "diameter": WIDE, "wall_depth": DEEP, "length": length, "sides": sides, "hopper": hopper}
                   | changes))  # fmt: skip


def space(plan="circular", hopper=None, outlet=None, wedge=False, **changes) -> SpaceSilo:
    outlets = (outlet,) if outlet else ()
    return SpaceSilo(silo=silo(plan, hopper, **changes), outlets=outlets, wedge=wedge, lid=True)


def floor_with(*outlets) -> SpaceSilo:
    """A round silo whose flat floor has outlets of a name, width, length and middle."""
    return SpaceSilo(silo=silo(), outlets=tuple(
        Outlet(name=name, width=width, length=length, middle=middle) for name, width, length, middle in outlets))  # fmt: skip


SPACES = {
    "closed": space(),
    "cone": space(hopper=CONE),
    "cone to its apex": space(hopper=Hopper(half_angle=0.5, outlet_width=0.0)),
    "eccentric cone": space(hopper=CONE, outlet_eccentricity=0.035),
    "eccentric cone to its apex": space(hopper=Hopper(half_angle=0.5, outlet_width=0.0), outlet_eccentricity=0.07),
    "hole": space(outlet=Outlet(width=0.08)),
    "eccentric hole": space(outlet=Outlet(width=0.06), outlet_eccentricity=0.05),
    "slot in a circle": space(outlet=Outlet(width=0.05, length=0.1), outlet_eccentricity=0.03),
    "square, hole": space("square", outlet=Outlet(width=0.07), outlet_eccentricity=0.04),
    "square, pyramid": space("square", CONE),
    "square, eccentric pyramid": space("square", CONE, outlet_eccentricity=0.05),
    "square, wedge": space("square", CONE, wedge=True, outlet_eccentricity=0.02),
    "rectangle, pyramid": space("rectangular", CONE),
    "rectangle, pyramid to its apex": space("rectangular", Hopper(half_angle=0.9, outlet_width=0.0)),
    "rectangle, wedge": space("rectangular", CONE, wedge=True),
    "rectangle, slot from wall to wall": space("rectangular", outlet=Outlet(width=0.06, length=0.3)),
    "rectangle, slot across": space("rectangular", outlet=Outlet(width=WIDE, length=0.06, middle=(0.0, 0.05))),
    "hexagon, pyramid": space("polygonal", CONE, outlet_eccentricity=0.03),
    "triangle, slot": space("polygonal", outlet=Outlet(width=0.06, length=0.04), sides=3),
    "octagon, hole": space("polygonal", outlet=Outlet(width=0.06), sides=8),
}
every_silo = pytest.mark.parametrize("of", SPACES.values(), ids=SPACES)


def shape_of(of: SpaceSilo, opened: bool) -> np.ndarray:
    """Rows of the surfaces that stand: at the start, or once the outlets are open; one row a sheet."""
    surfaces = [wall for wall in of.walls() if not (opened and of.opening and wall.name == FLOOR)]
    walls = walls_of(surfaces)
    for surface, row in zip(surfaces, walls.shape, strict=True):
        if opened and surface.name == FLOOR and of.outlets:
            surface.opened(row, tuple(of.openings), 0.0)
    return walls.shape


def opens(of: SpaceSilo) -> bool:
    return bool(of.openings)


def firsts(shape) -> np.ndarray:
    """Numbers of the surfaces that push: of a sheet the first piece, which stands for all."""
    return np.setdiff1d(np.arange(len(shape)), [row[NEXT] for row in shape if row[0] == FLAT and row[NEXT]])


def vectors(shape, point) -> list[np.ndarray]:
    """Vectors (m) from the nearest points of the surfaces that can be touched from a point."""
    found = [np.array(nearest(shape, q, *point)[:3]) for q in firsts(shape)]
    return [away for away in found if away[0] != OUT_OF_REACH]


def nearest_of_all(shape, point) -> np.ndarray:
    """Vector (m) from the nearest point of all surfaces; endless where there is none to touch."""
    return min(vectors(shape, point), key=np.linalg.norm, default=np.full(3, np.inf))


def distance(shape, point) -> float:
    return float(np.linalg.norm(nearest_of_all(shape, point)))


def push(shape, point) -> np.ndarray:
    """Push on a sphere by springs of stiffness one (m)."""
    pushes = [away * (BALL / length - 1.0) for away in vectors(shape, point) if (length := np.linalg.norm(away)) < BALL]
    return np.sum(pushes, axis=0) if pushes else np.zeros(3)
