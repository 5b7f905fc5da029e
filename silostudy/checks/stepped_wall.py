"""External pressure at which a wall of unequal courses buckles: semi-membrane theory, by Ritz' method on beam elements.

For n waves round the wall p_n = min over w(z) of [n^2/r^3 int D w^2 + E r^3/n^6 int t w''^2] / int w^2; p_cr is the least.
Derived from mechanics, checked against the uniform wall of every kind of edge; no edition of a code states it.
"""

import numpy as np

ELEMENTS = 40  # over the height; two a course at least
# edge -> which of deflection w and slope w' it holds; w' stands for the axial movement
HELD = {"free": (False, False), "pinned": (True, False), "clamped": (True, True)}
# integrals over an element of length 1 of its cubic functions: of w'' squared, of w squared
STRETCH = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
SPREAD = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]) / 420


def critical_pressure(
    thicknesses, heights, *, radius, youngs_modulus, shell_poisson_ratio, edges, elements=ELEMENTS
) -> tuple[float, int]:
    """External pressure (Pa) at which the perfect wall buckles, and waves round it; courses from the top down.

    heights (m): of the courses; edges: how the upper and the lower one are held, keys of HELD.
    """
    steps, courses = _mesh(np.asarray(thicknesses, dtype=float), np.asarray(heights, dtype=float), elements)
    stiffness = youngs_modulus * courses**3 / (12 * (1 - shell_poisson_ratio**2))
    free = _free(edges, len(steps))
    bending, stretching, pressed = (
        _assembled(steps, weights, matrix)[np.ix_(free, free)]
        for weights, matrix in ((stiffness, SPREAD), (courses, STRETCH), (np.ones_like(courses), SPREAD))
    )
    to_unit = np.linalg.inv(np.linalg.cholesky(pressed))
    bending, stretching = (to_unit @ form @ to_unit.T for form in (bending, stretching))
    least, waves, n = np.inf, 0, 2
    while n**2 * stiffness.min() / radius**3 < least:  # bending alone resists more waves by more than that
        form = n**2 / radius**3 * bending + youngs_modulus * radius**3 / n**6 * stretching
        pressure = float(np.linalg.eigvalsh(form)[0])
        least, waves, n = (pressure, n, n + 1) if pressure < least else (least, waves, n + 1)
    return least, waves


def _mesh(thicknesses: np.ndarray, heights: np.ndarray, elements: int) -> tuple[np.ndarray, np.ndarray]:
    """Length (m) and thickness (m) of every element; none reaches over an edge of a course."""
    counts = np.maximum(np.ceil(elements * heights / heights.sum() - 1e-9).astype(int), 2)
    return np.repeat(heights / counts, counts), np.repeat(thicknesses, counts)


def _free(edges, count: int) -> np.ndarray:
    """Positions of the unknowns that no edge holds: deflection and slope times the element's length at every node."""
    held = {position for end, first in zip(edges, (0, 2 * count), strict=True) for position in _held(end, first)}
    return np.array([position for position in range(2 * count + 2) if position not in held])


def _held(edge: str, first: int) -> list[int]:
    return [first + number for number, holds in enumerate(HELD[edge]) if holds]


def _assembled(steps: np.ndarray, weights: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """The whole wall's matrix of one of the integrals: of w'' squared (STRETCH) or of w squared (SPREAD)."""
    whole = np.zeros((2 * len(steps) + 2,) * 2)
    for number, (step, weight) in enumerate(zip(steps, weights, strict=True)):
        scale = np.array([1, step, 1, step])
        power = step**-3 if matrix is STRETCH else step
        place = slice(2 * number, 2 * number + 4)
        whole[place, place] += weight * power * matrix * np.outer(scale, scale)
    return whole
