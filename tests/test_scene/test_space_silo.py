"""The surfaces of a silo in space: where they stand, without leak or double push at joints, and silos that have none."""

from math import cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from scipy.spatial import cKDTree

from silostudy.dem.space.surfaces import OUT_OF_REACH, nearest
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
    return SpaceSilo(silo=silo(plan, hopper, **changes), outlet=outlet, wedge=wedge, lid=True)


SPACES = {
    "closed": space(),
    "cone": space(hopper=CONE),
    "cone to its apex": space(hopper=Hopper(half_angle=0.5, outlet_width=0.0)),
    "hole": space(outlet=Outlet(width=0.08)),
    "eccentric hole": space(outlet=Outlet(width=0.06), outlet_eccentricity=0.05),
    "slot in a circle": space(outlet=Outlet(width=0.05, length=0.1), outlet_eccentricity=0.03),
    "square, hole": space("square", outlet=Outlet(width=0.07), outlet_eccentricity=0.04),
    "square, pyramid": space("square", CONE),
    "square, eccentric pyramid": space("square", CONE, outlet_eccentricity=0.05),
    "square, wedge": space("square", CONE, wedge=True, outlet_eccentricity=0.02),
    "rectangle, pyramid": space("rectangular", CONE),
    "rectangle, pyramid to its ridge": space("rectangular", Hopper(half_angle=0.9, outlet_width=0.0)),
    "rectangle, wedge": space("rectangular", CONE, wedge=True),
    "rectangle, slot from wall to wall": space("rectangular", outlet=Outlet(width=0.06, length=0.3)),
    "hexagon, pyramid": space("polygonal", CONE, outlet_eccentricity=0.03),
    "triangle, slot": space("polygonal", outlet=Outlet(width=0.06, length=0.04), sides=3),
    "octagon, hole": space("polygonal", outlet=Outlet(width=0.06), sides=8),
}
every_silo = pytest.mark.parametrize("of", SPACES.values(), ids=SPACES)


def shape_of(of: SpaceSilo, opened: bool) -> np.ndarray:
    """Rows of the surfaces that stand: at the start, or once the outlet is open."""
    return walls_of([wall for wall in of.walls() if (wall.name != FLOOR if opened else wall.live)]).shape


def opens(of: SpaceSilo) -> bool:
    return of.opening is not None and min(of.opening.half) > 0.0


def vectors(shape, point) -> list[np.ndarray]:
    """Vectors (m) from the nearest points of the surfaces that can be touched from a point."""
    found = [np.array(nearest(shape, q, *point)[:3]) for q in range(len(shape))]
    return [away for away in found if away[0] != OUT_OF_REACH]


def distance(shape, point) -> float:
    return min((float(np.linalg.norm(away)) for away in vectors(shape, point)), default=np.inf)


def push(shape, point) -> np.ndarray:
    """Push on a sphere by springs of stiffness one (m)."""
    pushes = [away * (BALL / length - 1.0) for away in vectors(shape, point) if (length := np.linalg.norm(away)) < BALL]
    return np.sum(pushes, axis=0) if pushes else np.zeros(3)


class Sheet:
    """A silo's inner surface by its own formulas: one outline that widens with height from the outlet to the plan."""

    def __init__(self, of: SpaceSilo, opened: bool):
        one, hopper = of.silo, of.silo.hopper
        self.sides = {"circular": 0, "polygonal": one.sides}.get(one.plan, 4)
        self.high = np.array([one.diameter, one.length or one.diameter]) / 2
        self.bottom = (one.diameter - hopper.outlet_width) / 2 / tan(hopper.half_angle) if hopper else 0.0
        self.top, self.aside = self.bottom + one.wall_depth, one.outlet_eccentricity
        self.low = self.high - (one.diameter - hopper.outlet_width) / 2 * np.array([1, not of.wedge]) if hopper else self.high
        self.hole, self.round = (None, False) if hopper or not of.outlet else (self._hole(of.outlet), of.outlet.length is None)
        self.opened = opened

    @staticmethod
    def _hole(outlet: Outlet) -> np.ndarray:
        return np.array([outlet.width, outlet.length or outlet.width]) / 2

    def half_at(self, z):
        """Half widths and middle of the outline at a height (m)."""
        share = np.clip(z / self.bottom, 0.0, 1.0) if self.bottom else np.ones_like(z)
        half = self.low + np.multiply.outer(share, self.high - self.low)
        return half[..., 0], half[..., 1], self.aside * (1.0 - share)

    @staticmethod
    def inset(sides, half_x, half_y, x, y):
        """Distance inside an outline about the origin, the least over its sides."""
        if sides == 0:
            return half_x - np.hypot(x, y)
        if sides == 4:
            return np.minimum(half_x - abs(x), half_y - abs(y))
        return half_x - np.max([x * cos(2 * pi * k / sides) + y * sin(2 * pi * k / sides) for k in range(sides)], axis=0)

    def in_hole(self, x, y):
        return self.inset(0 if self.round else 4, *self.hole, x - self.aside, y)

    def within(self, points):
        """Whether points are inside, those under an open outlet included."""
        x, y, z = points.T
        half_x, half_y, aside = self.half_at(z)
        inside = (self.inset(self.sides, half_x, half_y, x - aside, y) > 0.0) & (z < self.top)
        if self.opened and self.hole is not None:
            return inside & ((z > 0.0) | (self.in_hole(x, y) > 0.0))
        return inside & ((z > 0.0) | self.opened)

    def ring(self, half_x, half_y, middle, z, pitch):
        """Points on the outline at a height, and which of them are its corners."""
        if self.sides == 0:
            turn = np.linspace(0.0, 2.0 * pi, max(3, int(2 * pi * half_x / pitch) + 1))
            return np.c_[middle + half_x * np.cos(turn), half_x * np.sin(turn), np.full_like(turn, z)]
        if self.sides == 4:
            ends = np.array([(1, -1), (1, 1), (-1, 1), (-1, -1)]) * (half_x, half_y)
        else:
            turn = 2 * pi / self.sides * (np.arange(self.sides) - 0.5)
            ends = half_x / cos(pi / self.sides) * np.c_[np.cos(turn), np.sin(turn)]
        ends = np.r_[ends, ends[:1]]
        lines = [np.linspace(a, b, int(hypot(*(b - a)) / pitch) + 2) for a, b in zip(ends[:-1], ends[1:], strict=True)]
        flat = np.concatenate(lines) + (middle, 0.0)
        return np.c_[flat, np.full(len(flat), z)]

    def level(self, half, middle, z, pitch, pierced=False):
        """Points on a level surface inside the outline, those over the hole left out."""
        wide = 2.0 * max(half)
        lines = np.linspace(-wide, wide, int(2.0 * wide / pitch) + 1)
        x, y = (axis.ravel() for axis in np.meshgrid(lines, lines))
        there = self.inset(self.sides, *half, x, y) > 0.0
        x, y = x[there] + middle, y[there]
        if pierced:
            free = self.in_hole(x, y) <= 0.0
            x, y = x[free], y[free]
        return np.c_[x, y, np.full_like(x, z)]

    def strewn(self, pitch):
        """Points all over the surface, no farther apart than the pitch (m)."""
        steep = max(abs(self.high - self.low)) + self.aside
        count = int(hypot(self.bottom, 2.0 * steep) / pitch) + 1
        heights = np.r_[np.linspace(0.0, self.bottom, count + 1)[:-1] if self.bottom else [],
                        np.linspace(self.bottom, self.top, int((self.top - self.bottom) / pitch) + 2)]  # fmt: skip
        halves = np.c_[self.half_at(heights)]
        parts = [self.ring(*half, z, pitch) for half, z in zip(halves, heights, strict=True)]
        parts.append(self.level(self.high, 0.0, self.top, pitch))
        if self.hole is not None or not self.opened:
            parts.append(self.level(self.low, self.aside if self.bottom else 0.0, 0.0, pitch, pierced=self.opened))
        if self.hole is not None and self.opened:
            edge, other = Sheet.__new__(Sheet), 0 if self.round else 4
            edge.sides = other
            rim = edge.ring(*self.hole, self.aside, 0.0, pitch)
            parts.append(rim)
        return np.concatenate(parts)

    def joints(self, pitch):
        """Points on the lines at which surfaces meet."""
        heights = np.linspace(0.0, self.top, int(2.0 * self.top / pitch))
        parts = [self.ring(*self.half_at(z), z, pitch) for z in (0.0, self.bottom, self.top)]
        if self.sides:
            corners = [self.ring(*self.half_at(z), z, 1e3)[::2] for z in heights]
            parts += corners
        return np.concatenate(parts)


def check_distances(of: SpaceSilo, opened: bool, seed: int, pitch=0.004, count=150):
    """Points inside, and outside but beside joints, are as far from the surfaces as a search over strewn points says."""
    random, sheet, shape = np.random.default_rng(seed), Sheet(of, opened), shape_of(of, opened)
    cloud = sheet.strewn(pitch)
    tree, joints = cKDTree(cloud), cKDTree(sheet.joints(pitch))
    points = cloud[random.integers(0, len(cloud), count)] + random.uniform(-0.02, 0.02, (count, 3))
    searched, which = tree.query(points)
    for point, most, inside, at in zip(points, searched, sheet.within(points), which, strict=True):
        least = distance(shape, point)
        assert least <= most + 1e-9 or (not inside and joints.query(cloud[at])[0] < 2.0 * pitch), point
        if least < np.inf and least <= most:
            assert most <= sqrt(least**2 + 2.0 * pitch**2), point


@every_silo
def test_distances_against_a_search(of):
    for opened in (False, True)[: 2 if opens(of) else 1]:
        check_distances(of, opened, 1)
