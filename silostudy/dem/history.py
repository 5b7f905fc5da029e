"""Histories of contacts: a number each in the plane, three in space, which stand in three rows; by the same words.

In a kernel these are numba's overloads, in Python they look at what they are given.
"""

import numpy as np
from numba import types
from numba.extending import overload

from silostudy.dem.arrays import aligned

NONE = (0.0, 0.0, 0.0)  # nothing stored


def histories(room: int, components: int) -> np.ndarray:
    """Histories of so many contacts, nothing held."""
    return aligned(room) if components == 1 else aligned(components, room)


def entry(history, k):
    """History of contact k; zeros where no histories are kept."""
    return _entry_one(history, k) if history.ndim == 1 else _entry_three(history, k)


def enter(history, k, value):
    """Let contact k hold a value, where histories are kept."""
    (_enter_one if history.ndim == 1 else _enter_three)(history, k, value)


def forget(history, k):
    """Let contact k hold nothing, where histories are kept."""
    (_forget_one if history.ndim == 1 else _forget_three)(history, k)


def holds(value):
    """Whether a history is one: not nothing."""
    return _holds_three(value) if isinstance(value, tuple) else _holds_one(value)


def where(same, value):
    """The history itself, or nothing."""
    return _where_three(same, value) if isinstance(value, tuple) else _where_one(same, value)


def _entry_one(history, k):
    return history[k] if history.size else 0.0


def _entry_three(history, k):
    return (history[0, k], history[1, k], history[2, k]) if history.size else NONE


def _enter_one(history, k, value):
    if history.size:
        history[k] = value


def _enter_three(history, k, value):
    if history.size:
        history[0, k], history[1, k], history[2, k] = value


def _forget_one(history, k):
    if history.size:
        history[k] = 0.0


def _forget_three(history, k):
    if history.size:
        history[0, k] = history[1, k] = history[2, k] = 0.0


def _holds_one(value):
    return value != 0.0


def _holds_three(value):
    return (value[0] != 0.0) | (value[1] != 0.0) | (value[2] != 0.0)


def _where_one(same, value):
    return value if same else 0.0


def _where_three(same, value):
    return value if same else NONE


@overload(entry, jit_options={"forceinline": True})
def _entry(history, k):
    return _entry_one if history.ndim == 1 else _entry_three


@overload(enter, jit_options={"forceinline": True})
def _enter(history, k, value):
    return _enter_one if history.ndim == 1 else _enter_three


@overload(forget, jit_options={"forceinline": True})
def _forget(history, k):
    return _forget_one if history.ndim == 1 else _forget_three


@overload(holds, jit_options={"forceinline": True})
def _holds(value):
    return _holds_three if isinstance(value, types.BaseTuple) else _holds_one


@overload(where, jit_options={"forceinline": True})
def _where(same, value):
    return _where_three if isinstance(value, types.BaseTuple) else _where_one
