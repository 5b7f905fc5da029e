"""What the ledger books of spheres themselves: kinetic and potential energy, and the work of gravity and base over a step."""

from silostudy.dem.cache import piece
from silostudy.dem.space.lanes import FX, TX, P, U, X


def book_bodies(holds: bool, unequal: bool, key: str):
    """Function that gives kinetic and potential energy (J) and the work of gravity and base (J) over a step.

    It also enters the spheres with their mean velocity of the step.
    """

    @piece("space", holds, unequal, key)
    def spheres_book(spheres, mean, n, pull, gravity, kick):
        rows = spheres.rows
        kinetic = potential = falling = shaking = 0.0
        m, im, ii = spheres.mass[0], spheres.inverse_mass[0], spheres.inverse_inertia[0]
        for i in range(n):
            if unequal:
                m, im, ii = spheres.mass[i], spheres.inverse_mass[i], spheres.inverse_inertia[i]
            for way in range(3):
                speed = spheres.held[i, way] if holds else rows[i, U + way]
                spin = spheres.held[i, 3 + way] if holds else rows[i, P + way]
                average = speed + 0.5 * kick * (rows[i, FX + way] * im + pull[way])
                mean[i, X + way], mean[i, U + way] = rows[i, X + way], average
                mean[i, P + way] = spin + 0.5 * kick * rows[i, TX + way] * ii
                kinetic += 0.5 * m * speed * speed + 0.5 * spin * spin / ii
                potential -= m * gravity[way] * rows[i, X + way]
                falling += m * gravity[way] * average * kick
                shaking += m * (pull[way] - gravity[way]) * average * kick
        return kinetic, potential, falling, shaking

    return spheres_book
