"""What the ledger books of discs themselves: kinetic and potential energy, and the work of gravity and base over a step."""

from silostudy.dem.cache import piece
from silostudy.dem.lanes import FX, FY, TORQUE, U, V, W, X, Y


def book_bodies(holds: bool, unequal: bool, key: str):
    """Function that gives kinetic and potential energy (J/m) and the work of gravity and base (J/m) over a step.

    It also enters the discs with their mean velocity of the step.
    """

    @piece("plane", holds, unequal, key)
    def discs_book(discs, mean, n, pull, gravity, kick):
        rows, (gx, gy) = discs.rows, pull
        kinetic = potential = falling = shaking = 0.0
        m, im, ii = discs.mass[0], discs.inverse_mass[0], discs.inverse_inertia[0]
        for i in range(n):
            if unequal:
                m, im, ii = discs.mass[i], discs.inverse_mass[i], discs.inverse_inertia[i]
            u, v, w = rows[i, U], rows[i, V], rows[i, W]
            if holds:
                u, v, w = discs.held[i, 0], discs.held[i, 1], discs.held[i, 2]
            mean[i, X], mean[i, Y] = rows[i, X], rows[i, Y]
            mean[i, U] = u + 0.5 * kick * (rows[i, FX] * im + gx)
            mean[i, V] = v + 0.5 * kick * (rows[i, FY] * im + gy)
            mean[i, W] = w + 0.5 * kick * rows[i, TORQUE] * ii
            kinetic += 0.5 * m * (u * u + v * v) + 0.5 * w * w / ii
            potential -= m * (gravity[0] * rows[i, X] + gravity[1] * rows[i, Y])
            falling += m * (gravity[0] * mean[i, U] + gravity[1] * mean[i, V]) * kick
            shaking += m * ((gx - gravity[0]) * mean[i, U] + (gy - gravity[1]) * mean[i, V]) * kick
        return kinetic, potential, falling, shaking

    return discs_book
