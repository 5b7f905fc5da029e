"""The radial stress fields in a converging channel over the steps of their march."""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from silostudy.pressure import radial_field

STEPS = (4, 8, 15, 30, 60, 120, 240, 480)
LADDERS = {"steps": STEPS}
INITIAL_ANGLES = np.radians(np.linspace(6.0, 16.0, 10))  # half angles (rad) of hoppers in the initial field
INITIAL_FRICTION = 0.5  # of their walls
STRESS_RATIO = 0.8  # of the initial field
FLOW_ANGLES = np.radians(np.linspace(8.0, 26.0, 10))  # half angles (rad) of hoppers in flow
FLOW_FRICTION = np.tan(np.radians(15.0))  # of their walls
EFFECTIVE = np.radians(45.0)  # effective friction angle (rad)
SLOTS = (0.0, 1.0)
FIRST = 1e-5  # rad: where the independent march leaves the axis, a singular point of a cone


def prepare(ladder: str, setting: float):
    """Both fields of all hoppers, none of them remembered from before."""
    slot = np.array(SLOTS)[:, None]

    def run():
        radial_field.remembered.cache_clear()
        return {
            "initial_slope": radial_field.initial_slope(INITIAL_ANGLES, INITIAL_FRICTION, STRESS_RATIO, slot, int(setting)),
            "flow_slope": radial_field.flow_slope(FLOW_ANGLES, FLOW_FRICTION, EFFECTIVE, slot, int(setting)),
        }

    return run


def reference():
    """The same equations by scipy's DOP853; the stress on the axis by superposition and by bracketing."""
    return {
        "initial_slope": np.array([[_initial(half, 1.0 - slot) for half in INITIAL_ANGLES] for slot in SLOTS]),
        "flow_slope": np.array([[_flow(half, 1.0 - slot) for half in FLOW_ANGLES] for slot in SLOTS]),
    }


def _marched(equations, start, half):
    return solve_ivp(equations, (FIRST, half), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]


def _initial(half, m):
    spread = (2 + m) / STRESS_RATIO - 1 - m

    def equations(angle, y):
        b, t = y
        return [np.sin(angle) - (3 + m) * t, -(spread * b + m * t / np.tan(angle) + np.cos(angle))]

    def wall(on_axis):
        return _marched(equations, [on_axis, -(spread * on_axis + 1) / (1 + m) * FIRST], half)

    (b0, t0), (b1, t1) = wall(0.0), wall(1.0)
    on_axis = -(t0 + INITIAL_FRICTION * b0) / (t1 - t0 + INITIAL_FRICTION * (b1 - b0))
    return (b0 + on_axis * (b1 - b0)) / np.cos(half)


def _flow(half, m):
    k, wall_angle = np.sin(EFFECTIVE), np.arctan(FLOW_FRICTION)
    target = wall_angle + np.arcsin(np.sin(wall_angle) / k)

    def equations(angle, y):
        s, w = y
        sine, cosine = np.sin(w), np.cos(w)
        a, b, c, t = s * (1 - k * cosine), s * (1 + k * cosine), s * (1 + k), -s * k * sine
        cot = 1 / np.tan(angle)
        dt = -((2 + m) * a - b - m * c + m * t * cot + np.cos(angle))
        db = np.sin(angle) - (3 + m) * t - m * (b - c) * cot
        return np.linalg.solve([[-k * sine, -s * k * cosine], [1 + k * cosine, -s * k * sine]], [dt, db])

    def wall(on_axis):
        turn = ((2 + m) * (1 - k) * on_axis - (1 + m) * (1 + k) * on_axis + 1) / ((1 + m) * on_axis * k)
        return _marched(equations, [on_axis, turn * FIRST], half)

    on_axis = brentq(lambda logarithm: wall(np.exp(logarithm))[1] - target, *_bracket(wall, target), xtol=1e-13)
    return wall(np.exp(on_axis))[0] * (1 + k * np.cos(target)) / np.cos(half)


def _bracket(wall, target):
    """Logarithms of two stresses on the axis between which the wall is reached; a larger one turns the stress less."""
    high = 3.0
    while wall(np.exp(high))[1] < target:
        high -= 0.1
    return high, high + 0.1
