"""The force pass: the contact laws of a scene on lanes of contacts, a loop that the compiler vectorises."""

from math import sqrt

from silostudy.contact.family import Touch
from silostudy.dem.cache import piece
from silostudy.dem.pieces import Laws


def force_pass(laws: Laws, *, unequal: bool, flat: bool):
    """Function that turns lanes of relative motion into lanes of force, for discs of one size or of many, or at a wall.

    A contact's force depends on nothing but its own numbers: the same bits wherever it stands in the list.
    """
    normal_law, tangential_law, rolling_law, cohesion_law = (row.law for row in laws.rows)
    drags, slides, rolls = laws.drags, laws.slides, laws.rolls

    @piece(laws, unequal, flat)
    def forces(lanes, out, stored, rolled, arm, other, mass, count, dt, c):
        a, b, m = arm[0], other[0], mass[0]
        for k in range(count):
            if unequal:
                a, b, m = arm[k], other[k], mass[k]
            dx, dy, du, dv = lanes[0, k], lanes[1, k], lanes[2, k], lanes[3, k]
            distance = sqrt(dx * dx + dy * dy)
            inverse = 1.0 / distance
            nx, ny = dx * inverse, dy * inverse
            overlap = a + b - distance
            touching = overlap > 0.0
            depth = overlap if touching else 0.0
            touch = Touch(m, a if flat else a * b / (a + b), dt)
            elastic, push = normal_law(depth, -(du * nx + dv * ny), touch, c[0])
            spin = 0.5 * (lanes[4, k] * (a + b) + lanes[5, k] * (a - b)) if unequal else lanes[4, k] * a
            old = stored[k] if slides else 0.0
            held, drag = tangential_law(old, dv * nx - du * ny - spin, touch, elastic, push, c[1])
            turned = rolled[k] if rolls else 0.0
            moment = rolling_law(turned, lanes[5, k], touch, elastic, c[2])
            push = push - cohesion_law(c[3]) if touching else 0.0
            drag = drag if touching else 0.0
            moment = moment if touching else 0.0
            if slides:
                stored[k] = held if touching else 0.0
            if rolls:
                rolled[k] = moment
            out[0, k] = push * nx - drag * ny if drags else push * nx  # zero times a number is not left out by itself
            out[1, k] = push * ny + drag * nx if drags else push * ny
            out[2, k] = moment - drag * a
            out[3, k] = moment + drag * b  # taken from the second

    return forces
