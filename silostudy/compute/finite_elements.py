"""A mesh of four-node shells on a silo's wall and hopper, its lines on the edges of the load, and the load's nodal forces."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from silostudy.cube.load import Load

EPSILON = 1e-9  # m or rad, within which two edges are one
GAUSS = np.polynomial.legendre.leggauss(4)  # points and weights of an interval: exact for polynomials up to the seventh degree


@dataclass(frozen=True)
class Mesh:
    """Rings of nodes from the top down: depths (m) and radii (m), angles (rad); x towards the outlet's side, z up.

    thickness (m) of the wall at each ring down to the transition, the mean where two strakes meet; foot: the ring at the
    transition.  A further, last ring is the foot of a skirt below it, which is held: no load stands on it.
    """

    depths: np.ndarray
    angles: np.ndarray
    radii: np.ndarray
    thickness: np.ndarray
    foot: int
    skirt: float  # height (m)

    @property
    def nodes(self) -> np.ndarray:
        """Coordinates (m) of the nodes, (ring, angle, xyz)."""
        round_it = np.stack([np.cos(self.angles), np.sin(self.angles)], axis=-1)
        flat = np.append(self.radii, self.radii[self.foot])[:, None, None] * round_it
        depths = np.append(self.depths, self.depths[self.foot] + self.skirt)
        return np.concatenate([flat, np.broadcast_to(-depths[:, None, None], (*flat.shape[:2], 1))], axis=-1)

    @property
    def rows(self) -> dict[str, list[tuple[int, int]]]:
        """Upper and lower ring of every row of elements of wall, hopper and skirt."""
        down = list(pairwise(range(len(self.depths))))
        return {"WALL": down[: self.foot], "HOPPER": down[self.foot :], "SKIRT": [(self.foot, len(self.depths))]}

    def number(self, ring: int, angle: int) -> int:
        """Number of a node, from 1."""
        return 1 + ring * len(self.angles) + angle % len(self.angles)

    def elements(self, upper: int, lower: int) -> list[tuple[int, ...]]:
        """The nodes of every element between two rings, so that its normal points outward."""
        across = range(len(self.angles))
        return [
            (self.number(upper, k), self.number(lower, k), self.number(lower, k + 1), self.number(upper, k + 1)) for k in across
        ]


def mesh(load: Load, strakes: tuple[np.ndarray, np.ndarray], *, size: float) -> Mesh:
    """A mesh of elements of about a size (m); strakes: (depths of their feet (m), thicknesses (m)) from the top."""
    feet, thicknesses = strakes
    depths, angles = load.edges()
    depths = _filled(np.unique(np.concatenate([depths, feet])), size)
    half = _filled(angles, size / load.radius)
    whole = np.concatenate([half, 2 * np.pi - half[-2:0:-1]])
    foot = int(np.argmin(np.abs(depths - load.transition)))
    sides = [depths[: foot + 1] + side * EPSILON for side in (-1, 1)]
    courses = [thicknesses[np.minimum(np.searchsorted(feet, side), len(thicknesses) - 1)] for side in sides]
    return Mesh(depths, whole, load.radius_at(depths), np.mean(courses, axis=0), foot, size)


def _filled(edges: np.ndarray, size: float) -> np.ndarray:
    """Edges with places between them, at most a size apart; edges closer than rounding are one."""
    edges = edges[np.concatenate([[True], np.diff(edges) > EPSILON])]
    parts = [np.linspace(a, b, max(1, int(np.ceil((b - a) / size))) + 1)[:-1] for a, b in pairwise(edges)]
    return np.append(np.concatenate(parts), edges[-1])


def nodal_forces(load: Load, on: Mesh) -> np.ndarray:
    """Force (N) on every node, (ring, angle, xyz): pressure outward and friction down, integrated on the true surface.

    Each element's share goes to its nodes by their bilinear functions of depth and angle, by Gauss points.
    """
    z, along = _points(on.depths)
    theta, around = _points(np.append(on.angles, 2 * np.pi))
    force = _traction(load, z[:, :, None, None], theta)  # (row, point, column, point, xyz)
    forces = np.zeros((len(on.depths), len(on.angles), 3))
    for ring, down in enumerate(along):
        for angle, across in enumerate(around):
            share = np.einsum("rpcqx,rp,cq->rcx", force, down, across)
            forces[ring : ring + len(z)] += np.roll(share, angle, axis=1)
    return forces


def _points(ends: np.ndarray) -> tuple[np.ndarray, tuple[np.ndarray, np.ndarray]]:
    """Gauss points between ends, and weights of the linear functions of both ends, each (interval, point)."""
    places, weights = GAUSS
    share, width = (1 + places) / 2, np.diff(ends)[:, None]
    whole = width * weights / 2
    return ends[:-1, None] + width * share, (whole * (1 - share), whole * share)


def _traction(load: Load, z: np.ndarray, theta: np.ndarray) -> np.ndarray:
    """Force per depth and angle (N m-1 rad-1) along x, y, z: on a hopper's wall p_n - p_t tan(beta) outward."""
    normal, traction = load.stress(z, theta)
    slope = np.where(z > load.transition, np.nan_to_num(np.tan(load.half_angle)), 0.0)
    outward, down = normal - traction * slope, traction + normal * slope
    parts = (outward * np.cos(theta), outward * np.sin(theta), -down)
    return np.stack(np.broadcast_arrays(*parts), axis=-1) * load.radius_at(z)[..., None]
