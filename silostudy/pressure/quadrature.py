"""Integrals of pressures over a wall: trapezoids down the cylinder, the double-exponential rule over the hopper."""

from collections.abc import Callable, Mapping

import numpy as np

from silostudy.pressure import hopper_shape
from silostudy.pressure.calls import parameters_of

# of the double-exponential rule
NODES = 81  # points
REACH = 3.3  # where its variable ends


def from_surface(traction: np.ndarray, z: np.ndarray) -> np.ndarray:
    """The integral (N/m) of a traction (Pa) from the surface, where it vanishes, to each depth z (m): trapezoids."""
    whole = np.concatenate([np.zeros((*traction.shape[:-1], 1)), traction], axis=-1)
    levels = np.concatenate([np.zeros((*z.shape[:-1], 1)), z], axis=-1)
    return np.cumsum((whole[..., 1:] + whole[..., :-1]) / 2 * np.diff(levels, axis=-1), axis=-1)


def double_exponential(count: int = NODES) -> tuple[np.ndarray, np.ndarray]:
    """Places within 0 ... 1 and weights of the double-exponential rule, which integrates powers at either end well."""
    nodes = np.linspace(-REACH, REACH, count)
    places = (1 + np.tanh(np.pi / 2 * np.sinh(nodes))) / 2
    return places, np.pi / 4 * np.cosh(nodes) / np.cosh(np.pi / 2 * np.sinh(nodes)) ** 2 * (nodes[1] - nodes[0])


def hopper_wall_force(pressures: Callable, between, parameters: Mapping, slope, rule=None) -> np.ndarray:
    """Vertical force (N) on a hopper's wall: p_n slope + p_t over the wall between two heights (m) above its apex.

    pressures(x) -> (p_n, p_t) (Pa) at heights of shape (cases, places); slope: tangent of the wall's half angle;
    rule: (places, weights), None: double_exponential().
    """
    start, end = between
    places, weights = double_exponential() if rule is None else rule
    x = start + (end - start) * places
    normal, traction = pressures(x)
    around = hopper_shape.wall_length(x, **{name: parameters[name] for name in parameters_of(hopper_shape.wall_length)})
    pushed = normal * slope + traction
    return np.sum(pushed * around * weights, axis=-1) * (end - start)[..., 0]
