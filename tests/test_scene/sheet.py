"""The inner surface of a silo in space by formulas of its own, as strewn points, to hold the engine's surfaces against."""

from itertools import pairwise
from math import cos, hypot, pi, sin, tan

import numpy as np

from silostudy.scene.space_silo import SpaceSilo


class Sheet:
    """A silo's inner surface by its own formulas: one outline that widens with height from the outlet to the plan."""

    def __init__(self, of: SpaceSilo, opened: bool):
        one, hopper = of.silo, of.silo.hopper
        self.sides = {"circular": 0, "polygonal": one.sides}.get(one.plan, 4)
        self.high = np.array([one.diameter, one.length or one.diameter]) / 2
        self.bottom = (one.diameter - hopper.outlet_width) / 2 / tan(hopper.half_angle) if hopper else 0.0
        self.top, self.aside = self.bottom + one.wall_depth, one.outlet_eccentricity
        left = hopper.outlet_width / one.diameter if hopper else 1.0
        self.low = self.high * np.array([left, 1.0 if of.wedge else left])
        outlet = of.outlets[0] if of.outlets else None
        self.hole = np.array([outlet.width, outlet.length or outlet.width]) / 2 if outlet else None
        self.round = outlet is not None and outlet.length is None
        self.away = outlet.middle[1] if outlet and outlet.middle else 0.0  # the middle of the outlet, along y
        self.opened = opened

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
        return self.inset(0 if self.round else 4, *self.hole, x - self.aside, y - self.away)

    def within(self, points):
        """Whether points are inside, those under an open outlet included."""
        x, y, z = points.T
        half_x, half_y, aside = self.half_at(z)
        inside = (self.inset(self.sides, half_x, half_y, x - aside, y) > 0.0) & (z < self.top)
        if self.opened and self.hole is not None:
            return inside & ((z > 0.0) | (self.in_hole(x, y) > 0.0))
        return inside & ((z > 0.0) | self.opened)

    @staticmethod
    def ring(sides, half_x, half_y, middle, z, pitch):
        """Points on an outline at a height, its corners among them."""
        if sides == 0:
            turn = np.linspace(0.0, 2.0 * pi, max(3, int(2 * pi * half_x / pitch) + 1))
            return np.c_[middle + half_x * np.cos(turn), half_x * np.sin(turn), np.full_like(turn, z)]
        if sides == 4:
            ends = np.array([(1, -1), (1, 1), (-1, 1), (-1, -1)]) * (half_x, half_y)
        else:
            turn = 2 * pi / sides * (np.arange(sides) - 0.5)
            ends = half_x / cos(pi / sides) * np.c_[np.cos(turn), np.sin(turn)]
        ends = np.r_[ends, ends[:1]]
        lines = [np.linspace(a, b, int(hypot(*(b - a)) / pitch) + 2) for a, b in pairwise(ends)]
        x, y = np.concatenate(lines).T
        return np.c_[x + middle, y, np.full_like(x, z)]

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
        parts = [self.ring(self.sides, *half, z, pitch) for half, z in zip(halves, heights, strict=True)]
        parts.append(self.level(self.high, 0.0, self.top, pitch))
        if self.hole is not None or not self.opened:
            parts.append(self.level(self.low, self.aside if self.bottom else 0.0, 0.0, pitch, pierced=self.opened))
        if self.hole is not None and self.opened:
            rim = self.ring(0 if self.round else 4, *self.hole, self.aside, 0.0, pitch)
            parts.append(rim + np.array([0.0, self.away, 0.0]))
        return np.concatenate(parts)

    def joints(self, pitch):
        """Points on the lines at which surfaces meet."""
        heights = np.linspace(0.0, self.top, int(2.0 * self.top / pitch))
        parts = [self.ring(self.sides, *self.half_at(z), z, pitch) for z in (0.0, self.bottom, self.top)]
        if self.sides:
            corners = [self.ring(self.sides, *self.half_at(z), z, 1e3)[::2] for z in heights]
            parts += corners
        return np.concatenate(parts)
