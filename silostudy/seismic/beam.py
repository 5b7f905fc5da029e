"""The silo as a Timoshenko cantilever tube with rotary inertia: exact to rounding in the modes that matter.

One or two spectral elements (below and above the contents' surface), polynomials through Gauss-Lobatto points: no shear
locking, and frequencies that converge exponentially with the degree.
"""

from dataclasses import dataclass
from itertools import pairwise
from math import pi

import numpy as np
from numpy.polynomial import legendre
from scipy.linalg import eigh

DEGREE = 17  # the first five frequencies are then right to 1e-8, from slender to stubby
ROUNDING = 1e-13  # of the largest inverse square of a frequency


@dataclass(frozen=True, kw_only=True)
class Tube:
    """A circular tube clamped at its base, in SI units; radius is that of the wall's middle surface."""

    radius: float
    thickness: float
    height: float
    wall_density: float
    youngs_modulus: float
    poisson_ratio: float
    shear_factor: float
    contents_density: float
    fill_height: float


@dataclass(frozen=True)
class Modes:
    """Natural modes, unit modal mass: positions (m) above the base, one column a mode.

    rotation_slope is the bending curvature, shear_angle what is left of the slope: both give the internal forces.
    """

    frequency: np.ndarray  # Hz
    participation: np.ndarray  # kg^0.5, to a rigid shift of the base
    position: np.ndarray  # m
    displacement: np.ndarray  # (position, mode), kg^-0.5
    curvature: np.ndarray
    shear_angle: np.ndarray
    bending_stiffness: float  # N m2
    shear_stiffness: float  # N


def section_area(*, radius, thickness):
    """Area (m2) of a ring section with mid-wall radius (m)."""
    return 2 * pi * radius * thickness


def second_moment(*, radius, thickness):
    """Second moment of area (m4) of a ring section: pi/4 (R_outer^4 - R_inner^4), exact for any thickness."""
    return pi * radius**3 * thickness * (1 + thickness**2 / (4 * radius**2))


def contents_area(*, radius, thickness):
    """Inner area (m2) of the tube."""
    return pi * (radius - thickness / 2) ** 2


def modes(
    tube: Tube,
    coefficient: float,
    stiffness_reduction: float = 1.0,
    heights: np.ndarray | None = None,
    degree: int = DEGREE,
    elements: int = 1,
) -> Modes:
    """Every mode of the discretised tube whose contents add `coefficient` of their mass.

    heights: where (m) it gives deflections and forces, default the top.
    elements: equal ones below the contents' surface, and as many above it where the tube goes on.
    """
    size = {"radius": tube.radius, "thickness": tube.thickness}
    area, inertia = section_area(**size), second_moment(**size)
    bending = stiffness_reduction * tube.youngs_modulus * inertia
    shear_modulus = tube.youngs_modulus / (2 * (1 + tube.poisson_ratio))
    shearing = stiffness_reduction * tube.shear_factor * shear_modulus * area
    added = coefficient * tube.contents_density * contents_area(**size) / area  # equation (1) with (2), as a density
    levels = (0.0, tube.fill_height, tube.height)
    ends = np.unique([np.linspace(low, high, elements + 1) for low, high in pairwise(levels)])
    densities = [tube.wall_density + added * (end <= tube.fill_height) for end in ends[1:]]
    stiffness, mass = _assemble(degree, ends, densities, area, inertia, bending, shearing)
    free = np.delete(np.arange(len(mass)), [0, len(mass) // 2])
    squares, shapes = _eigen(stiffness[np.ix_(free, free)], mass[np.ix_(free, free)])
    whole = np.zeros((len(mass), len(squares)))
    whole[free] = shapes
    rigid = np.arange(len(mass)) < len(mass) // 2
    position = np.array([tube.height]) if heights is None else np.asarray(heights, dtype=float)
    values, slopes = _interpolation(degree, ends, position)
    deflections, rotations = np.split(whole, 2)
    return Modes(
        frequency=np.sqrt(squares) / (2 * pi),
        participation=whole.T @ mass @ rigid,
        position=position,
        displacement=values @ deflections,
        curvature=slopes @ rotations,
        shear_angle=slopes @ deflections - values @ rotations,
        bending_stiffness=bending,
        shear_stiffness=shearing,
    )


def _eigen(stiffness: np.ndarray, mass: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Squares of the angular frequencies (s-2), rising, and shapes of unit modal mass in columns.

    Solved for the inverse squares, so that the lowest modes keep their digits however thin an element or slender the tube;
    modes that are nothing but rounding are left out.
    """
    inverse, shapes = eigh(mass, stiffness)
    sound = np.flatnonzero(inverse > ROUNDING * inverse[-1])[::-1]
    return 1 / inverse[sound], shapes[:, sound] / np.sqrt(inverse[sound])


def _assemble(degree, ends, densities, area, inertia, bending, shearing) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness and mass over (deflections, rotations) of all nodes, base included."""
    count = degree * (len(ends) - 1) + 1
    stiffness, mass = np.zeros((2 * count, 2 * count)), np.zeros((2 * count, 2 * count))
    points, weights = legendre.leggauss(degree + 1)
    values, slopes = _basis(degree, points)
    for element, (low, high) in enumerate(pairwise(ends)):
        half = (high - low) / 2
        nodes = degree * element + np.arange(degree + 1)
        w = np.hstack([values, 0 * values])
        rotation = np.hstack([0 * values, values])
        curvature = np.hstack([0 * values, slopes / half])
        shear = np.hstack([slopes / half, -values])
        place = np.ix_(np.concatenate([nodes, count + nodes]), np.concatenate([nodes, count + nodes]))
        scaled = half * weights
        stiffness[place] += bending * _gram(curvature, scaled) + shearing * _gram(shear, scaled)
        mass[place] += densities[element] * (area * _gram(w, scaled) + inertia * _gram(rotation, scaled))
    return stiffness, mass


def _gram(field: np.ndarray, weights: np.ndarray) -> np.ndarray:
    return field.T @ (weights[:, None] * field)


def _nodes(degree: int) -> np.ndarray:
    """Gauss-Lobatto points of an element, -1 to 1."""
    inner = legendre.legroots(legendre.legder([0] * degree + [1]))
    return np.concatenate([[-1.0], np.sort(inner), [1.0]])


def _basis(degree: int, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values and slopes at `points` of the polynomials that are 1 at one node and 0 at the others."""
    to_legendre = np.linalg.inv(legendre.legvander(_nodes(degree), degree))
    slopes = legendre.legder(to_legendre, axis=0)
    return legendre.legvander(points, degree) @ to_legendre, legendre.legvander(points, degree - 1) @ slopes


def _interpolation(degree: int, ends: np.ndarray, position: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Matrices from nodal values to values and slopes at positions (m)."""
    count = degree * (len(ends) - 1) + 1
    values, slopes = np.zeros((len(position), count)), np.zeros((len(position), count))
    element = np.clip(np.searchsorted(ends, position, side="left") - 1, 0, len(ends) - 2)
    for e in range(len(ends) - 1):
        here, half = np.flatnonzero(element == e), (ends[e + 1] - ends[e]) / 2
        value, slope = _basis(degree, (position[here] - ends[e]) / half - 1)
        columns = degree * e + np.arange(degree + 1)
        values[np.ix_(here, columns)], slopes[np.ix_(here, columns)] = value, slope / half
    return values, slopes
