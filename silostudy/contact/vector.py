"""Arithmetic of sliding and rolling motion by the same words: a number in the plane, three numbers in space.

In a kernel these are numba's overloads, in Python they look at what they are given.
"""

from math import sqrt

from numba import types
from numba.extending import overload


def less(value, factor, motion):
    """Difference value - factor * motion."""
    return _less_three(value, factor, motion) if isinstance(value, tuple) else value - factor * motion


def scaled(factor, motion):
    """Product factor * motion."""
    return _scaled_three(factor, motion) if isinstance(motion, tuple) else factor * motion


def direction(motion):
    """Sign of a number, unit vector of three; nothing of nothing."""
    return _direction_three(motion) if isinstance(motion, tuple) else _direction_one(motion)


def limited(value, cap):
    """Value held at a size of cap at most, cap being zero or more; and 1.0 where it was not cut, else 0.0."""
    return _limited_three(value, cap) if isinstance(value, tuple) else _limited_one(value, cap)


def product(first, second):
    """Product of two numbers, scalar product of two vectors."""
    return _product_three(first, second) if isinstance(first, tuple) else first * second


def same(first, second):
    """Whether two are equal."""
    return _same_three(first, second) if isinstance(first, tuple) else first == second


def _less_one(value, factor, motion):
    return value - factor * motion


def _less_three(value, factor, motion):
    return value[0] - factor * motion[0], value[1] - factor * motion[1], value[2] - factor * motion[2]


def _scaled_one(factor, motion):
    return factor * motion


def _scaled_three(factor, motion):
    return factor * motion[0], factor * motion[1], factor * motion[2]


def _direction_one(motion):
    return 1.0 if motion > 0.0 else -1.0 if motion < 0.0 else 0.0


def _direction_three(motion):
    square = motion[0] * motion[0] + motion[1] * motion[1] + motion[2] * motion[2]
    share = 1.0 / sqrt(square if square > 0.0 else 1.0)
    return share * motion[0], share * motion[1], share * motion[2]


def _limited_one(value, cap):
    low = value if value > -cap else -cap
    held = low if low < cap else cap
    return held, 1.0 if held == value else 0.0


def _limited_three(value, cap):
    square = value[0] * value[0] + value[1] * value[1] + value[2] * value[2]
    sticks = square <= cap * cap
    share = 1.0 if sticks else cap / sqrt(square)
    return (share * value[0], share * value[1], share * value[2]), 1.0 if sticks else 0.0


def _product_one(first, second):
    return first * second


def _product_three(first, second):
    return first[0] * second[0] + first[1] * second[1] + first[2] * second[2]


def _same_one(first, second):
    return first == second


def _same_three(first, second):
    return first[0] == second[0] and first[1] == second[1] and first[2] == second[2]


@overload(less, jit_options={"forceinline": True})
def _less(value, factor, motion):
    return _less_three if isinstance(value, types.BaseTuple) else _less_one


@overload(scaled, jit_options={"forceinline": True})
def _scaled(factor, motion):
    return _scaled_three if isinstance(motion, types.BaseTuple) else _scaled_one


@overload(direction, jit_options={"forceinline": True})
def _direction(motion):
    return _direction_three if isinstance(motion, types.BaseTuple) else _direction_one


@overload(limited, jit_options={"forceinline": True})
def _limited(value, cap):
    return _limited_three if isinstance(value, types.BaseTuple) else _limited_one


@overload(product, jit_options={"forceinline": True})
def _product(first, second):
    return _product_three if isinstance(first, types.BaseTuple) else _product_one


@overload(same, jit_options={"forceinline": True})
def _same(first, second):
    return _same_three if isinstance(first, types.BaseTuple) else _same_one
