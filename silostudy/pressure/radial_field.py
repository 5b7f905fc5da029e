"""Radial stress fields in a converging channel: stresses grow in proportion to the distance r from the apex.

Spherical (cone, m = 1) or cylindrical (wedge, m = 0) coordinates, theta from the axis, compression positive.  With
sigma_r = gamma r a(theta), sigma_theta = gamma r b(theta), hoop stress gamma r c(theta) and shear gamma r t(theta),
equilibrium along r and theta reads

    (2 + m) a - b - m c + t' + m t cot(theta) + cos(theta) = 0
    (3 + m) t + b' + m (b - c) cot(theta) - sin(theta) = 0

On the axis t = 0; at the wall the solid slides downward with its wall friction fully mobilised, t = -b tan(phi').

Flow (arched field): the solid is everywhere on the yield limit of a cohesionless Coulomb solid with the effective angle
of friction delta, k = sin(delta); the major principal stress is horizontal on the axis and the hoop stress equals it:
    a = s (1 - k cos(w)), b = s (1 + k cos(w)), t = -s k sin(w), c = s (1 + k),
w twice the turn of the major stress away from the theta direction: 0 on the axis, phi' + asin(sin(phi')/k) at the wall.

Initial (peaked field): the stresses across the channel are a constant share of the radial one, b = c = K a.  The source
names K = 0.8 for its chart of i_1 without defining K; this reading of it is an assumption.

Source: silo_handbook, section 4.5.2 (which gives the results as charts only); the equations are Jenike's and Sokolovskii's
radial fields, worked out here.
"""

from functools import lru_cache

import numpy as np

STEPS = 60  # of the integration from the axis to the wall
HALVINGS = 12  # of the bracket of the stress on the axis, before secants take over
SECANTS = 6  # from there to the solution
# stress on the axis over gamma r, between which the field is looked for
SMALLEST = 1e-4
LARGEST = 1e4


def flow_slope(half_angle, wall_friction, effective_friction_angle, slot, steps=STEPS):
    """Normal wall pressure over unit weight and height above the apex (1) in flow; NaN where no field exists.

    Source: silo_handbook, section 4.5.2; arched radial field of the module's first lines.
    """
    return _solved(_flow, steps, half_angle, wall_friction, effective_friction_angle, slot)


def initial_slope(half_angle, wall_friction, stress_ratio, slot, steps=STEPS):
    """Normal wall pressure over unit weight and height above the apex (1) before flow.

    inf where wall friction is too small to hold a field (its peak sinks to the apex), NaN where it would ask for tension on
    the axis.

    Source: silo_handbook, section 4.5.2; peaked radial field of the module's first lines.
    """
    return _solved(_initial, steps, half_angle, wall_friction, stress_ratio, slot)


def _solved(solve, steps, *parameters):
    """Solves over the distinct sets of parameters only, and spreads the solution back over their common shape."""
    arrays = np.broadcast_arrays(*(np.asarray(parameter, dtype=float) for parameter in parameters))
    distinct, place = np.unique(np.stack([array.ravel() for array in arrays]), axis=1, return_inverse=True)
    return remembered(solve, steps, distinct.tobytes(), distinct.shape)[place.ravel()].reshape(arrays[0].shape)


@lru_cache(maxsize=256)
def remembered(solve, steps: int, content: bytes, shape: tuple[int, ...]) -> np.ndarray:
    """Wall values of sets of parameters that were solved before; whoever times a solution empties it first."""
    return solve(steps, *np.frombuffer(content).reshape(shape))


def _march(derivative, start, half_angle, steps):
    """Runge-Kutta from the first step off the axis, where cot(theta) is singular, to the wall; state (2, cases)."""
    h = half_angle / steps
    state = start(h)
    for step in range(1, steps):
        angle = step * h
        first = derivative(angle, state)
        second = derivative(angle + h / 2, state + h / 2 * first)
        third = derivative(angle + h / 2, state + h / 2 * second)
        state = state + h / 6 * (first + 2 * second + 2 * third + derivative(angle + h, state + h * third))
    return state


def _initial(steps, half_angle, wall_friction, stress_ratio, slot):
    m = 1 - slot
    spread = (2 + m) / stress_ratio - 1 - m

    def field(on_axis, weight):
        """Values b, t at the wall for the stress b on the axis; the equations are linear in both."""

        def derivative(angle, state):
            b, t = state
            radial = -(spread * b + m * t / np.tan(angle) + weight * np.cos(angle))
            return np.array([weight * np.sin(angle) - (3 + m) * t, radial])

        def start(h):
            t = -(spread * on_axis + weight) / (1 + m)
            return np.array([on_axis + (weight - (3 + m) * t) * h**2 / 2, t * h])

        return _march(derivative, start, half_angle, steps)

    unit = np.ones_like(half_angle)
    (b_unit, t_unit), (b_weight, t_weight) = field(unit, 0 * unit), field(0 * unit, unit)
    resistance = t_unit + wall_friction * b_unit  # of the wall against a stress of 1 on the axis
    exists = resistance > 0
    on_axis = -(t_weight + wall_friction * b_weight) / np.where(exists, resistance, 1.0)
    slope = (b_weight + on_axis * b_unit) / np.cos(half_angle)
    return np.select([~exists, on_axis > 0], [np.inf, slope], np.nan)


def _flow(steps, half_angle, wall_friction, effective_friction_angle, slot):
    m, k = 1 - slot, np.sin(effective_friction_angle)
    wall_angle = np.arctan(wall_friction)
    rubs = wall_angle < effective_friction_angle - 1e-6  # at equality the field ends on its own limit
    at_wall = wall_angle + np.arcsin(np.where(rubs, np.sin(wall_angle) / k, 1.0))
    low, high = np.full_like(half_angle, np.log(SMALLEST)), np.full_like(half_angle, np.log(LARGEST))
    for _ in range(HALVINGS):  # a larger stress on the axis turns the major stress less
        middle = (low + high) / 2
        turns_enough = _turned(steps, middle, half_angle, m, k)[1] > at_wall
        low, high = np.where(turns_enough, middle, low), np.where(turns_enough, high, middle)
    s, w = _refined(steps, low, high, half_angle, m, k, at_wall)
    reached = rubs & (np.abs(w - at_wall) < 1e-8)
    return np.where(reached, s * (1 + k * np.cos(at_wall)) / np.cos(half_angle), np.nan)


def _refined(steps, first, second, half_angle, m, k, at_wall):
    """Values s, w at the wall by secants from two starts close to the solution."""
    miss = _turned(steps, first, half_angle, m, k)[1] - at_wall
    for _ in range(SECANTS):
        s, w = _turned(steps, second, half_angle, m, k)
        slope = np.where(second == first, 1.0, (w - at_wall - miss) / np.where(second == first, 1.0, second - first))
        step = np.where(slope == 0, 0.0, (w - at_wall) / np.where(slope == 0, 1.0, slope))
        first, miss, second = second, w - at_wall, second - np.clip(step, -0.1, 0.1)
    return s, w


def _turned(steps, log_on_axis, half_angle, m, k):
    """Values s, w at the wall for the logarithm of s on the axis; a field that turns past its limit stays there."""
    on_axis = np.exp(log_on_axis)
    limit = np.arccos(-k) - 1e-9  # beyond it the yield condition lets no stress state go on

    def derivative(angle, state):
        s, w = state
        w = np.minimum(w, limit)
        sin_w, cos_w = np.sin(w), np.cos(w)
        a, b, c, t = s * (1 - k * cos_w), s * (1 + k * cos_w), s * (1 + k), -s * k * sin_w
        dt = -((2 + m) * a - b - m * c + m * t / np.tan(angle) + np.cos(angle))
        db = np.sin(angle) - (3 + m) * t - m * (b - c) / np.tan(angle)
        # dt = -k (s' sin w + s w' cos w), db = s' (1 + k cos w) - s k w' sin w, solved for s' and s w'
        both = k * (k + cos_w)
        ds = (k * sin_w * -dt + k * cos_w * db) / both
        dw = (-(1 + k * cos_w) * dt - k * sin_w * db) / (both * s)
        goes_on = state[1] < limit
        return np.array([np.where(goes_on, ds, 0.0), np.where(goes_on, dw, 0.0)])

    def start(h):
        w = -((2 + m) * on_axis * (1 - k) - (1 + m) * on_axis * (1 + k) + 1) / (-(1 + m) * on_axis * k)
        db = 1 + (3 + m) * on_axis * k * w + m * on_axis * k * w**2 / 2
        s = on_axis + h**2 / 2 * (db + on_axis * k * w**2) / (1 + k)
        return np.array([np.maximum(s, SMALLEST), np.minimum(w * h, limit)])

    with np.errstate(all="ignore"):  # fields far from the solution may run off; they only steer the search
        return _march(derivative, start, half_angle, steps)
