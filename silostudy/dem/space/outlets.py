"""Outlets of a floor of spheres that are open where a run ended, in another floor that goes on from there."""

import numpy as np

from silostudy.dem.outlets import Handed
from silostudy.dem.space.rows import HOLES, MORE, PER_HOLE


def handed_on(now: np.ndarray, begun: np.ndarray, here: np.ndarray) -> Handed:
    """Rows of the floor here with the holes open that are so there; that it goes on for that; holes that it has not.

    now, begun: its row there, as it stands and as it began; here: the row here as it begins.  No rows where more has changed
    there than holes, or where the floors differ in more.
    """
    others = np.setdiff1d(np.arange(MORE), [HOLES])
    if not len(now) == len(here) == 1 or any(not np.array_equal(row[:, others], begun[:, others]) for row in (now, here)):
        return here[:0], np.empty((0, 0), bool), []
    rows, lost = here.copy(), []
    was, own, new = holes_of(begun[0]), holes_of(here[0]), holes_of(rows[0])
    then = now[0, MORE:][: was.size].reshape(was.shape)
    for number in np.flatnonzero((then != was).any(axis=1)):
        (same,) = np.nonzero((own == was[number]).all(axis=1))
        new[same[:1]] = then[number]
        lost += [] if len(same) else [(0, int(number))]
    return rows, np.ones((1, 1), bool), lost


def holes_of(row: np.ndarray) -> np.ndarray:
    """Numbers of each hole (holes, numbers) of a level surface's row, in place."""
    return row[MORE:][: PER_HOLE * int(row[HOLES])].reshape(-1, PER_HOLE)
