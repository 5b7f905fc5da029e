"""Forces on walls over a window of steps: least, largest and sum of every step's force, by cell and by wall."""

import numpy as np
from numba import njit
from numba.extending import register_jitable

from silostudy.dem.arrays import WallRecord
from silostudy.dem.cache import OPTIONS

NOTHING = 0.0, np.inf, -np.inf  # sum, least, largest of no step


def record_of(owner: np.ndarray, walls: int, felt: int, threads: int, room: int) -> WallRecord:
    """An empty record of cells that belong to these walls, with room for so many contacts a thread."""
    return WallRecord(
        force=np.zeros((threads, room, felt)),
        cell=np.zeros((threads, room), np.int32),
        counts=np.zeros(threads, np.int64),
        now=np.zeros((len(owner), felt)),
        window=np.zeros((len(owner), felt, 3)) + np.array(NOTHING),
        owner=owner,
        whole_now=np.zeros((walls, felt)),
        whole=np.zeros((walls, felt, 3)) + np.array(NOTHING),
    )


def first_of_faces(cells: np.ndarray) -> np.ndarray:
    """First cell of each face of walls: of each its own, and that of its back, where it has one."""
    first, back = cells[:, 0], cells[:, -1]
    return np.sort(np.concatenate([first, (first + back)[back > 0]]))


def owners(first: np.ndarray, cells: int) -> np.ndarray:
    """Face of every cell, from the first cell of each face."""
    return np.repeat(np.arange(len(first), dtype=np.int32), np.diff(first, append=cells))


@register_jitable
def keep(now, window):
    """Add the forces of a step to sums, and keep their least and largest."""
    for c in range(now.shape[0]):
        for way in range(now.shape[1]):
            value = now[c, way]
            window[c, way, 0] += value
            window[c, way, 1] = min(window[c, way, 1], value)
            window[c, way, 2] = max(window[c, way, 2], value)


@njit(**OPTIONS)
def add_to_window(record):
    """Add this step's wall forces to the window, contact by contact in the order of the discs.

    Those of a whole wall are no sums of cells: their bits, by which a lid moves, do not hang on how many cells there are.
    """
    now, whole = record.now, record.whole_now
    now[:] = 0.0
    whole[:] = 0.0
    for part in range(record.counts.size):
        for k in range(record.counts[part]):
            cell = record.cell[part, k]
            for way in range(now.shape[1]):
                now[cell, way] += record.force[part, k, way]
                whole[record.owner[cell], way] += record.force[part, k, way]
    keep(now, record.window)
    keep(whole, record.whole)
