"""Outlets of a floor of discs that are open where a run ended, in the pieces of another floor that goes on from there."""

import numpy as np

from silostudy.dem.joints import END, ENDS, REACH, START
from silostudy.dem.walls import GROWTH, OWN

Handed = tuple[np.ndarray, np.ndarray, list[tuple[int, int]]]  # rows, which go on for which, outlets that are lost


def handed_on(now: np.ndarray, begun: np.ndarray, here: np.ndarray) -> Handed:
    """Rows of the pieces here with the ends open that are so there; which go on for which there; ends that none here has.

    now, begun: rows of the pieces there, as they stand and as they began; here: of those here as they begin.  No rows where
    more has changed there than outlets.
    """
    of_ends = [[REACH + end, ENDS + end, GROWTH + end] for end in (START, END)]
    others = np.setdiff1d(np.arange(now.shape[1]), np.ravel(of_ends))
    if not np.array_equal(now[:, others], begun[:, others]):
        return here[:0], np.empty((0, 0), bool), []
    rows, lost, seams = here.copy(), [], []
    for piece, end in np.argwhere([(now[:, columns] != begun[:, columns]).any(axis=1) for columns in of_ends])[:, ::-1]:
        place = [OWN + end, REACH + end]
        (same,) = np.nonzero((here[:, place] == begun[piece, place]).all(axis=1))
        rows[same[:1, None], of_ends[end]] = now[piece, of_ends[end]]
        lost += [] if len(same) else [(int(piece), int(end))]
        seams += [begun[piece, REACH]] if end == START else []
    before, after = (np.searchsorted(np.sort(seams), of[:, REACH], side="right") for of in (begun, here))
    return rows, before[:, None] == after, lost
